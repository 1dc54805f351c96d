// Statistics of surfaces by the mean rows against those of the patches.
#include "precompute/files/light_results.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "tests/core/synthetic_scene.h"

namespace fiatlux {
namespace {

TEST(ResultsJson, KnownValues) {
  Patches patches;
  patches.count = 2;
  patches.area = {1, 3, 1};
  patches.reflectance = {0.5f, 0.25f, 0};
  patches.surface = {0, 0, 1};
  const std::vector<Surface> surfaces = {{"floor", 4, 0.3125, 2, false, 0}, {"plane", 1, 0, 1, true, 0}};
  const LightResults results = lightResults(patches, surfaces, {2, 6, 9});
  EXPECT_DOUBLE_EQ(results.surfaces[0].illuminance.mean, 5);
  EXPECT_NEAR(results.surfaces[0].illuminance.sigma, 1.7320508075688772, 1e-12);
  EXPECT_DOUBLE_EQ(results.surfaces[0].exitance.mean, (0.5 * 2 + 3 * 0.25 * 6) / 4);
  EXPECT_EQ(results.surfaces[1].illuminance.mean, 9);
  EXPECT_EQ(results.all.area, 4);
  EXPECT_DOUBLE_EQ(results.all.reflectance, 0.3125);
  const nlohmann::ordered_json json = surfacesJson(results);
  EXPECT_EQ(json[0]["min"], 2);
  EXPECT_DOUBLE_EQ(json[0]["uniformity"].get<double>(), 0.4);
  EXPECT_FALSE(json[1].contains("exitance"));
}

TEST(ResultsJson, MeanRowsAndCovariancesAgreeWithThePatches) {
  const Scene scene = syntheticScene(40, 8);
  const Layout layout{{1, 5, 6}, {1000, 500, 2000}, 0.8};
  const LightResults fast = lightResults(scene, layout);
  const LightResults slow = lightResults(scene.patches, scene.surfaces, illuminanceOf(scene, layout));
  for (std::size_t s = 0; s < 3; ++s) {
    EXPECT_NEAR(fast.surfaces[s].illuminance.mean, slow.surfaces[s].illuminance.mean,
                1e-5 * slow.surfaces[s].illuminance.mean);
    EXPECT_NEAR(fast.surfaces[s].illuminance.sigma, slow.surfaces[s].illuminance.sigma,
                1e-5 * slow.surfaces[s].illuminance.sigma);
    EXPECT_NEAR(fast.surfaces[s].exitance.sigma, slow.surfaces[s].exitance.sigma,
                1e-5 * slow.surfaces[s].exitance.mean);
  }
  EXPECT_NEAR(fast.all.illuminance.sigma, slow.all.illuminance.sigma, 1e-5 * slow.all.illuminance.sigma);
}

TEST(ResultsJson, NamesAreQuotedInCsv) {
  Scene scene = syntheticScene(4, 1);
  scene.surfaces[0].name = "a \"b\", c";
  const std::string csv = patchesCsv(scene.patches, scene.surfaces, illuminanceOf(scene, {{0}, {1}, 1}));
  EXPECT_EQ(csv.find("\"a \"\"b\"\", c\",", csv.find('\n')), csv.find('\n') + 1);
}

}  // namespace
}  // namespace fiatlux
