// How a long computation tells how far it is, and is asked to stop. Whoever waits for it implements Progress:
// the terminal's bar, a worker of the page.
#pragma once

#include <exception>
#include <functional>
#include <string>
#include <vector>

namespace fiatlux {

/// Wall clock of one stage, as whoever waits has measured it.
struct StageSeconds {
  std::string stage;
  double seconds = 0;
};

/// Called on the thread that runs the computation only.
class Progress {
 public:
  virtual ~Progress() = default;
  /// `stage` begins; the one before it has ended.
  virtual void begin(const std::string& stage) = 0;
  /// `fraction` of the stage is done, 0..1. Called often.
  virtual void update(double fraction) = 0;
  /// True where the computation shall end soon, without a result. Asked as often.
  virtual bool stopped() { return false; }
  /// What each stage has taken up to now, in their order; empty where nobody has a clock.
  virtual std::vector<StageSeconds> seconds() { return {}; }
};

/// How a computation ends that was stopped.
struct Stopped : std::exception {
  const char* what() const noexcept override { return "stopped"; }
};

/// Begins a stage; what it returns is to be told the share of it that is done, and is empty where nobody
/// listens (nullptr). Both throw Stopped where the listener says so.
std::function<void(double)> beginStage(Progress* listener, const std::string& stage);

}  // namespace fiatlux
