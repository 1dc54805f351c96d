// What a piece of work costs: processor time, the same whatever else the machine does meanwhile.
#pragma once

#include <ctime>

namespace fiatlux {

class ProcessorTime {
 public:
  /// Seconds that this process has computed since this was made.
  double seconds() const { return static_cast<double>(std::clock() - begin_) / CLOCKS_PER_SEC; }

 private:
  std::clock_t begin_ = std::clock();
};

}  // namespace fiatlux
