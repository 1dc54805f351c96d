// What the signals do that end a program: they leave no half-written file.
#pragma once

#include <string>

namespace fiatlux {

/// From now on Ctrl-C (and TERM, HUP) removes the file that is being written, says so in one line and ends
/// with status 2; what is ignored already (nohup) stays so. A file that outgrows `ulimit -f` is an error of
/// the write, no longer a signal.
void installInterruptHandler();

/// While it lives, the file at `path` is removed where the program is interrupted. One at a time.
class RemovedOnInterrupt {
 public:
  /// `path`: of at most kLongestPath bytes.
  explicit RemovedOnInterrupt(const std::string& path);
  ~RemovedOnInterrupt();
  RemovedOnInterrupt(const RemovedOnInterrupt&) = delete;
  RemovedOnInterrupt& operator=(const RemovedOnInterrupt&) = delete;

  static constexpr std::size_t kLongestPath = 4095;
};

}  // namespace fiatlux
