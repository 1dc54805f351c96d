// Areas in plan: sites that they leave out, and task areas that intentions name and results list.
#include "precompute/files/areas_json.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>

#include "core/scene/zones.h"
#include "precompute/files/intentions_json.h"
#include "precompute/files/layout_json.h"
#include "precompute/files/light_results.h"
#include "tests/core/synthetic_scene.h"
#include "tests/precompute/files/intentions_in.h"

namespace fiatlux {
namespace {

using ::testing::HasSubstr;

constexpr const char* kDesk =
    R"({"name": "desk 1", "surface": "desk plane", "outline": [[0, -9], [1, -9], [1, 9], [0, 9]]})";

TEST(AreasJson, TaskAreasAreNamedLikeSurfaces) {
  const Scene scene = syntheticScene(16, 8);
  const Result<Intentions> asked = intentionsIn(scene, std::string(R"({"taskAreas": [)") + kDesk + R"(],
      "constraints": [{"statistic": "uniformity", "surface": "desk 1", "min": 0.6, "on": "grid"},
                      {"statistic": "mean", "surface": "desk 1 surround", "min": 300}]})");
  ASSERT_TRUE(asked) << asked.error().message;
  ASSERT_GE(asked->zones.size(), 2u);
  EXPECT_EQ(asked->zones[0].name, "desk 1");
  EXPECT_EQ(asked->zones.back().name, "desk plane background");
  EXPECT_TRUE(asked->constraints[0].onGrid);
  EXPECT_FALSE(asked->constraints[1].onGrid);
  std::size_t rows = 0;
  for (const Zone& zone : asked->zones) rows += zone.rows.size();
  EXPECT_EQ(rows, scene.surfaces[2].patches) << "together they are the plane";
  for (const std::uint32_t p : asked->zones[0].rows) EXPECT_LT(scene.patches.center[p].x, 1);
  for (const std::uint32_t p : asked->zones[1].rows) EXPECT_NEAR(scene.patches.center[p].x, 1.25, 0.26);
}

TEST(AreasJson, TheirLightFollowsThatOfTheSurfaces) {
  Scene scene = syntheticScene(16, 8);
  const Result<LayoutFile> file =
      parseLayout(std::string(R"({"luminaires": [{"site": 1, "flux": 900}], "taskAreas": [)") + kDesk + "]}");
  ASSERT_TRUE(file) << file.error().message;
  const Result<std::vector<Zone>> zones = zonesOf(scene, file->taskAreas);
  ASSERT_TRUE(zones);
  ASSERT_TRUE(takeZones(scene, *zones));
  const Layout layout{{1}, {900}, 1};
  const LightResults results = lightResults(scene, layout);
  ASSERT_EQ(results.surfaces.size(), scene.surfaces.size());
  const SurfaceResult& desk = results.surfaces[firstZone(scene)];
  EXPECT_EQ(desk.name, "desk 1");
  const ExplicitStatistics patches =
      explicitStatistics(scene, illuminanceOf(scene, layout), {firstZone(scene)});
  EXPECT_NEAR(desk.illuminance.mean, patches.mean, 1e-4 * patches.mean);
  EXPECT_NEAR(desk.illuminance.minimum, patches.minimum, 1e-4 * patches.mean);
}

TEST(AreasJson, SitesOutsideAreExcludedButForPinnedOnes) {
  const Scene scene = syntheticScene(16, 8);
  const auto excludedBy = [&](const std::string& areas) {
    const Result<Intentions> asked = intentionsIn(
        scene, R"({"luminaires": {"count": 1, "flux": 900, "pinned": [0], "areas": )" + areas + "}}");
    EXPECT_TRUE(asked) << asked.error().message;
    return asked->luminaires.excluded;
  };
  const std::vector<std::uint32_t> out = excludedBy(R"({"keepOut": [[-9, -9, 1, 9]]})");
  const std::vector<std::uint32_t> in = excludedBy(R"({"keepIn": [[-9, -9, 1, 9]]})");
  for (std::uint32_t s = 1; s < scene.sites.size(); ++s) {
    const bool isLeft = scene.sites[s].position.x <= 1;
    EXPECT_EQ(std::count(out.begin(), out.end(), s), isLeft);
    EXPECT_EQ(std::count(in.begin(), in.end(), s), !isLeft);
  }
  EXPECT_EQ(std::count(out.begin(), out.end(), 0u) + std::count(in.begin(), in.end(), 0u), 0);
}

TEST(AreasJson, AnOutlineLeavesOutWhatItsRectangleDoes) {
  const Scene scene = syntheticScene(16, 8);
  const auto excludedBy = [&](const std::string& areas) {
    return intentionsIn(scene, R"({"luminaires": {"count": 1, "flux": 900, "areas": )" + areas + "}}")
        ->luminaires.excluded;
  };
  EXPECT_EQ(excludedBy(R"({"keepOut": [[[-9, -9], [1, -9], [1, 9], [-9, 9]]]})"),
            excludedBy(R"({"keepOut": [[-9, -9, 1, 9]]})"));
  const std::vector<std::uint32_t> corner = excludedBy(R"({"keepIn": [[[-9, -9], [12, -9], [-9, 12]]]})");
  for (std::uint32_t s = 0; s < scene.sites.size(); ++s) {
    const Vec3 at = scene.sites[s].position;
    EXPECT_EQ(std::count(corner.begin(), corner.end(), s), at.x + at.z > 3);
  }
}

TEST(AreasJson, LuminairesKeepTheirDistanceFromWalls) {
  const Scene scene = syntheticScene(16, 8);
  const Result<Intentions> asked =
      intentionsIn(scene, R"({"luminaires": {"count": 1, "flux": 900, "areas": {"fromWalls": 0.8}}})");
  ASSERT_TRUE(asked) << asked.error().message;
  double farX = 0, farZ = 0;  // the floor begins at the origin
  for (std::uint32_t p = 0; p < scene.patches.rows(); ++p) {
    if (scene.surfaces[scene.patches.surface[p]].name != "floor") continue;
    farX = std::max(farX, scene.patches.center[p].x + 0.125),
    farZ = std::max(farZ, scene.patches.center[p].z + 0.125);
  }
  std::vector<std::uint32_t> near;
  for (std::uint32_t s = 0; s < scene.sites.size(); ++s) {
    const Vec3 at = scene.sites[s].position;
    if (std::min({at.x, at.z, farX - at.x, farZ - at.z}) < 0.8) near.push_back(s);
  }
  EXPECT_GT(near.size(), 0u);
  EXPECT_LT(near.size(), scene.sites.size());
  EXPECT_EQ(asked->luminaires.excluded, near);
}

TEST(AreasJson, SayWhatIsWrong) {
  const Scene scene = syntheticScene(16, 8);
  const auto refused = [&](const std::string& text) { return intentionsIn(scene, text).error().message; };
  EXPECT_THAT(refused(R"({"taskAreas": [{"name": "a", "surface": "dsk", "outline": [[0,0],[1,0],[1,1]]}]})"),
              HasSubstr("there is no surface"));
  EXPECT_THAT(
      refused(
          R"({"taskAreas": [{"name": "a", "surface": "desk plane", "outline": [[90,0],[91,0],[91,1]]}]})"),
      HasSubstr("holds no point"));
  EXPECT_THAT(refused(R"({"taskAreas": [{"name": "a", "surface": "desk plane", "outline": [[0,0],[1,0]]}]})"),
              HasSubstr("three corners"));
  EXPECT_THAT(refused(R"({"luminaires": {"areas": {"keepOut": [[1, 0, 0, 1]]}}})"), HasSubstr("no extent"));
  EXPECT_THAT(refused(R"({"luminaires": {"areas": {"keepIn": [[[1, 0], [0, 1]]]}}})"),
              HasSubstr("three corners"));
  EXPECT_THAT(refused(R"({"luminaires": {"areas": {"fromWalls": -1}}})"), HasSubstr("fromWalls"));
}

}  // namespace
}  // namespace fiatlux
