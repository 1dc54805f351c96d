// No search hangs luminaires where they run into each other, whatever the rule.
#include "core/search/bodies.h"

#include <gtest/gtest.h>

#include "core/search/layout_search.h"
#include "core/search/validate_intentions.h"
#include "tests/core/corridor_scene.h"

namespace fiatlux {
namespace {

using fiatlux::testing::smallRoom;

/// Battens of 1.4 m on 5 x 4 sites, 0.75 m apart, along x or along z: candidates 2 j and 2 j + 1 of site j.
Scene battens() {
  const Scene& room = smallRoom();
  Scene scene = room;
  scene.sites.clear();
  scene.responses.illuminance.clear();
  for (std::uint32_t place = 0; place < room.sites.size(); ++place)
    for (const std::uint32_t way : {0u, 1u}) {
      scene.sites.push_back(room.sites[place]);
      const Vec3 along = way == 0 ? Vec3{1, 0, 0} : Vec3{0, 0, 1};
      scene.hangings.push_back({place, 0, way, 1, {along, 0.7, 0.1}});
      const float* column = room.responses.column(place);
      scene.responses.illuminance.insert(scene.responses.illuminance.end(), column,
                                         column + room.responses.rows);
    }
  scene.responses.sites = static_cast<std::uint32_t>(scene.sites.size());
  fiatlux::testing::addStatistics(scene);
  return scene;
}

std::uint32_t candidate(int x, int z, std::uint32_t way) {
  return 2 * static_cast<std::uint32_t>(5 * z + x) + way;
}

std::size_t collisions(const Scene& scene, const std::vector<std::uint32_t>& sites) {
  std::size_t count = 0;
  for (std::size_t i = 0; i < sites.size(); ++i)
    for (std::size_t k = 0; k < i; ++k) count += collide(scene, sites[i], sites[k]);
  return count;
}

TEST(Bodies, RunIntoEachOtherAsTheyLieAndMayTouch) {
  Scene scene = battens();
  EXPECT_TRUE(haveBodies(scene));
  EXPECT_TRUE(collide(scene, candidate(0, 0, 0), candidate(1, 0, 0)));
  EXPECT_FALSE(collide(scene, candidate(0, 0, 0), candidate(2, 0, 0)));
  EXPECT_FALSE(collide(scene, candidate(0, 0, 0), candidate(0, 1, 0)));  // side by side
  EXPECT_TRUE(collide(scene, candidate(1, 1, 0), candidate(1, 1, 1)));   // a cross
  EXPECT_TRUE(collide(scene, candidate(1, 1, 0), candidate(2, 1, 1)));   // end on side: 0.7 and 0.1 of 0.75
  for (Hanging& hanging : scene.hangings) hanging.body.halfLength = 0.375;
  EXPECT_FALSE(collide(scene, candidate(0, 0, 0), candidate(1, 0, 0)));  // end to end
  scene.sites[candidate(1, 1, 1)].position.y -= 0.5;                     // below it
  EXPECT_FALSE(collide(scene, candidate(1, 1, 0), candidate(1, 1, 1)));
  EXPECT_FALSE(haveBodies(smallRoom()));
}

TEST(Bodies, NoRuleHangsOneIntoAnother) {
  const Scene scene = battens();
  for (const Rule rule : {Rule::kFree, Rule::kSymmetric, Rule::kRows, Rule::kField})
    for (const std::uint32_t high : {0u, 6u}) {
      Intentions intentions;
      intentions.luminaires.count = 4;
      intentions.luminaires.countHigh = high;
      intentions.luminaires.arrangement.rule = rule;
      intentions.luminaires.flux = {1};
      intentions.luminaires.minDistance = 1e-3;
      intentions.goals = {{Statistic::kSigma, Sense::kMaximize, 1, {0}, {}}};  // close together
      ASSERT_TRUE(checkIntentions(scene, intentions));
      PreparedScene prepared(scene);
      LayoutSearch search(prepared, intentions, 1);
      search.advance(5000);
      EXPECT_EQ(collisions(scene, search.incumbent().sites), 0u) << static_cast<int>(rule) << ' ' << high;
    }
}

TEST(Bodies, ThoseThatTradeTheirWaysFitAfterwards) {
  const Scene scene = battens();
  Intentions intentions;
  intentions.luminaires.flux = {1};
  intentions.luminaires.minDistance = 1e-3;
  intentions.goals = {{Statistic::kSigma, Sense::kMaximize, 1, {0}, {}}};
  PreparedScene prepared(scene);
  for (std::uint64_t seed = 1; seed <= 10; ++seed)
    for (intentions.luminaires.count = 4; intentions.luminaires.count <= 7; ++intentions.luminaires.count) {
      LayoutSearch search(prepared, intentions, seed);
      for (int slice = 0; slice < 20; ++slice) {
        search.advance(300);
        EXPECT_EQ(collisions(scene, search.incumbent().sites), 0u) << seed;
      }
    }
}

TEST(Bodies, TakeRoomThatOthersCannotHave) {
  const Scene scene = battens();
  Intentions intentions;
  intentions.luminaires.flux = {1};
  intentions.luminaires.minDistance = 1e-3;
  intentions.luminaires.count = 20;  // one a site
  const Result<Done> checked = checkIntentions(scene, intentions);
  ASSERT_FALSE(checked);
  EXPECT_NE(checked.error().message.find("found room for only"), std::string::npos);
  EXPECT_NE(checked.error().message.find("run into"), std::string::npos) << checked.error().message;
}

}  // namespace
}  // namespace fiatlux
