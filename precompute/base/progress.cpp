#include "precompute/base/progress.h"

namespace fiatlux {

std::function<void(double)> beginStage(Progress* listener, const std::string& stage) {
  if (!listener) return {};
  if (listener->stopped()) throw Stopped();
  listener->begin(stage);
  return [listener](double fraction) {
    if (listener->stopped()) throw Stopped();
    listener->update(fraction);
  };
}

}  // namespace fiatlux
