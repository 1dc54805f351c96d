// How a long command tells that it lives: a bar on a terminal, a plain line now and then elsewhere; standard
// error only. It has the clock, too, that the computation itself has not.
#pragma once

#include <chrono>
#include <string>
#include <vector>

#include "precompute/base/progress.h"

namespace fiatlux {

/// Stages one after the other, each from 0 to 1; throttled.
class TerminalProgress final : public Progress {
 public:
  TerminalProgress();
  ~TerminalProgress() override;
  void begin(const std::string& stage) override;
  void update(double fraction) override;
  std::vector<StageSeconds> seconds() override;
  /// Seconds since it was made.
  double total() const;
  /// Takes the bar off the terminal, so that a line may be printed.
  void clear();

 private:
  using Clock = std::chrono::steady_clock;
  struct Stage {
    std::string name;
    Clock::time_point start;
  };
  bool terminal_, shown_ = false;
  std::vector<Stage> stages_;
  const Clock::time_point start_ = Clock::now();
  Clock::time_point last_ = start_;  // when something was shown
};

/// A warning or note on standard error: "fiatlux: <line>". Control characters are shown as '?'.
void printNote(const std::string& line);

/// Text of a file's author made harmless for a terminal: control characters become '?', what is longer than
/// `longest` bytes is cut between two characters.
std::string printable(const std::string& text, std::size_t longest = 400);

}  // namespace fiatlux
