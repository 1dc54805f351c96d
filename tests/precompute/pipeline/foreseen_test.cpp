// A long run says how long it is before it begins, and what would be shorter.
#include "precompute/pipeline/foreseen.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/precompute/pipeline/box_model.h"

namespace fiatlux {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

/// Ends a run as soon as anything is cast.
struct Impatient : Progress {
  bool begun = false;
  void begin(const std::string& stage) override { begun = stage == "form factors"; }
  void update(double) override {}
  bool stopped() override { return begun; }
};

std::vector<std::string> saidOf(const SceneOptions& options) {
  std::vector<std::string> said;
  Impatient impatient;
  Host host = testing::plainHost();
  host.progress = &impatient, host.threads = 1;
  host.warn = [&](const std::vector<std::string>& lines) {
    EXPECT_FALSE(impatient.begun);
    said.insert(said.end(), lines.begin(), lines.end());
  };
  EXPECT_EQ(makeScene(testing::boxModel(), options, host).error().message, "stopped");
  return said;
}

TEST(Foreseen, ALongRunIsSaidBeforeItBegins) {
  SceneOptions options = testing::quickOptions();
  EXPECT_THAT(saidOf(options), IsEmpty());
  options.room.patch = 0.05, options.room.memory = 64, options.transport.rays = 65536;
  EXPECT_THAT(saidOf(options), ElementsAre(HasSubstr("minutes on 1 core, and about 2 with --patch 0.")));
}

TEST(Foreseen, WhatIsOfferedIsShortAndSampleRoomsAreNot) {
  Room room;
  room.patchSize = 0.2;
  room.patches.count = 90000, room.patches.area.resize(90000);
  room.sites.resize(400), room.triangles.resize(60000);
  const std::string note = noteOfTime(room, 1024, 2);
  EXPECT_THAT(note, HasSubstr("this will take about "));
  const double patch = std::stod(note.substr(note.rfind(' ') + 1));
  const double rows = 90000 * (0.2 / patch) * (0.2 / patch);
  EXPECT_LT(coreSeconds(rows, 400, 60000) / 2, 125);
  EXPECT_GT(coreSeconds(rows, 400, 60000) / 2, 100);
  room.sites.resize(9), room.triangles.resize(12);
  EXPECT_EQ(noteOfTime(room, 1024, 1), "");
}

}  // namespace
}  // namespace fiatlux
