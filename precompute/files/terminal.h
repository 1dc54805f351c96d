// How a long command tells that it lives: a bar on a terminal, a plain line now and then elsewhere; standard
// error only.
#pragma once

#include <chrono>
#include <mutex>
#include <string>

namespace fiatlux {

/// Stages one after the other, each from 0 to 1. May be called from any thread; throttled.
class Progress {
 public:
  /// `quiet`: says nothing.
  explicit Progress(bool quiet = false);
  ~Progress();
  /// `fraction` of the stage is done, 0..1. A new name starts a new stage.
  void update(const std::string& stage, double fraction);
  /// Takes the bar off the terminal, so that a line may be printed.
  void clear();

 private:
  using Clock = std::chrono::steady_clock;
  std::mutex mutex_;
  bool quiet_, terminal_, shown_ = false;
  std::string stage_;
  Clock::time_point last_;
};

/// A warning or note on standard error: "fiatlux: <line>". Control characters are shown as '?'.
void printNote(const std::string& line);

/// Text of a file's author made harmless for a terminal: control characters become '?', long text is cut.
std::string printable(const std::string& text, std::size_t longest = 400);

}  // namespace fiatlux
