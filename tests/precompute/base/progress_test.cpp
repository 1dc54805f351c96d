// Stages told to a listener, and the end of a run that it wants stopped.
#include "precompute/base/progress.h"

#include <gtest/gtest.h>

#include "precompute/base/error.h"
#include "precompute/base/parallel.h"

namespace fiatlux {
namespace {

struct Listener : Progress {
  std::string stage;
  double done = -1;
  bool stops = false;
  void begin(const std::string& name) override { stage = name, done = 0; }
  void update(double fraction) override { done = fraction; }
  bool stopped() override { return stops; }
};

TEST(Progress, AStageIsToldToWhoeverListens) {
  Listener listener;
  const auto tell = beginStage(&listener, "rays");
  EXPECT_EQ(listener.stage, "rays");
  tell(0.5);
  EXPECT_EQ(listener.done, 0.5);
  EXPECT_FALSE(beginStage(nullptr, "rays"));
}

TEST(Progress, StoppingEndsALoopAndTheNextStage) {
  Listener listener;
  const auto tell = beginStage(&listener, "rays");
  int bodies = 0;
  const auto body = [&](std::size_t i) {
    ++bodies;
    if (i == 3) listener.stops = true;
  };
  EXPECT_THROW(parallelFor(100, 1, body, tell), Stopped);
  EXPECT_EQ(bodies, 4);
  EXPECT_THROW(beginStage(&listener, "light"), Stopped);
  EXPECT_EQ(listener.stage, "rays");
}

TEST(AtDoor, ExceptionsOfTheInsideBecomeOneLine) {
  const auto good = atDoor([] { return 7; }, "none");
  ASSERT_TRUE(good);
  EXPECT_EQ(*good, 7);
  const auto wrong = atDoor([]() -> int { throw CommandError("wrong; cure"); }, "none");
  EXPECT_EQ(wrong.error().message, "wrong; cure");
  const auto stopped = atDoor([]() -> int { throw Stopped(); }, "none");
  EXPECT_EQ(stopped.error().message, "stopped");
  const auto full = atDoor([]() -> int { throw std::bad_alloc(); }, "no memory; use less");
  EXPECT_EQ(full.error().message, "no memory; use less");
}

}  // namespace
}  // namespace fiatlux
