// Other paint against its definition on the exchange of light, on a made-up operator.
#include "core/transport/repaint.h"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/core/operator_scene.h"

namespace fiatlux {
namespace {

class Repainted : public ::testing::Test {
 protected:
  Scene scene = operatorScene(12, 3);
  ExchangeOperator exchange{scene.patches, scene.lightOperator->groups, scene.lightOperator->exchange};
  std::vector<float> light =
      std::vector<float>(scene.responses.column(1), scene.responses.column(1) + scene.patches.rows());

  std::vector<float> paint(std::uint32_t surface, float reflectance) const {
    std::vector<float> changed(scene.patches.reflectance.begin(),
                               scene.patches.reflectance.begin() + scene.patches.count);
    for (std::uint32_t p = 0; p < scene.patches.count; ++p)
      if (scene.patches.surface[p] == surface) changed[p] = reflectance;
    return changed;
  }
  double mean(const std::vector<float>& values, std::uint32_t surface) const {
    return explicitStatistics(scene, values, {surface}).mean;
  }
};

TEST_F(Repainted, NoPaintLeavesEveryBit) {
  const std::vector<float> same(scene.patches.reflectance.begin(),
                                scene.patches.reflectance.begin() + scene.patches.count);
  EXPECT_EQ(Repaint(scene, exchange, same).light(light, 1), light);
}

TEST_F(Repainted, WhatIsAddedIsWhatTheNewPaintReflectsMore) {
  const std::vector<float> reflectance = paint(0, 0.6f);
  const std::vector<float> painted = Repaint(scene, exchange, reflectance).light(light, 1);
  // g' - g = S Delta g', with S between groups as the exchange holds it.
  const ExchangeGroups& groups = scene.lightOperator->groups;
  std::vector<double> means(groups.count, 0.0), areas(groups.count, 0.0);
  std::vector<float> lumens(groups.count, 0.0f), added(light.size());
  for (std::uint32_t p = 0; p < scene.patches.count; ++p) {
    const double change = reflectance[p] - scene.patches.reflectance[p];
    lumens[groups.ofRow[p]] += static_cast<float>(scene.patches.area[p] * change * painted[p]);
  }
  added = exchange.spread(lumens, 1);
  double largest = 0;
  for (const float value : added) largest = std::max<double>(largest, value);
  EXPECT_GT(largest, 0.05 * mean(light, 0));
  for (std::size_t p = 0; p < light.size(); ++p)
    EXPECT_NEAR(painted[p] - light[p], added[p], 0.02 * largest) << p;
}

TEST_F(Repainted, ThereAndBackRestoresTheMeans) {
  // The room as it would be stored after painting: its own exchange, and the old paint as the new one.
  Scene painted = scene;
  const std::vector<float> reflectance = paint(0, 0.6f);
  const ExchangeGroups& groups = scene.lightOperator->groups;
  Exchange& stored = painted.lightOperator->exchange;
  std::fill(stored.rest.begin(), stored.rest.end(), 0.0f);
  Scene plain = scene;
  std::fill(plain.lightOperator->exchange.rest.begin(), plain.lightOperator->exchange.rest.end(), 0.0f);
  const ExchangeOperator before(plain.patches, groups, plain.lightOperator->exchange);
  const Repaint repaint(plain, before, reflectance);
  // Its columns are light, too: of one lumen that leaves a group.
  for (std::uint32_t d = 0; d < groups.count; ++d) {
    std::vector<float> lumen(groups.count, 0.0f);
    lumen[d] = 1;
    const std::vector<float> column = repaint.light(before.spread(lumen, 1), 1);
    std::vector<double> area(groups.total, 0.0), sum(groups.total, 0.0);
    for (std::uint32_t p = 0; p < scene.patches.rows(); ++p) {
      area[groups.ofRow[p]] += scene.patches.area[p];
      sum[groups.ofRow[p]] += scene.patches.area[p] * column[p];
    }
    for (std::uint32_t c = 0; c < groups.total; ++c)
      stored.means[std::size_t{c} * groups.count + d] = static_cast<float>(sum[c] / area[c]);
  }
  std::copy(reflectance.begin(), reflectance.end(), painted.patches.reflectance.begin());
  const ExchangeOperator after(painted.patches, groups, stored);
  std::vector<float> old(scene.patches.reflectance.begin(),
                         scene.patches.reflectance.begin() + scene.patches.count);
  const std::vector<float> forth = repaint.light(light, 1);
  const std::vector<float> back = Repaint(painted, after, old).light(forth, 1);
  EXPECT_GT(std::abs(mean(forth, 0) / mean(light, 0) - 1), 0.005);
  for (std::uint32_t s = 0; s < 2; ++s) EXPECT_NEAR(mean(back, s) / mean(light, s), 1, 1e-6);
}

TEST_F(Repainted, TheDerivativeIsWhatALittlePaintDoes) {
  const float step = 0.001f;
  std::vector<float> reflectance = paint(0, scene.patches.reflectance[0]);
  for (std::uint32_t p = 0; p < scene.patches.count; ++p)
    if (scene.patches.surface[p] == 0) reflectance[p] += step;
  const std::vector<float> painted = Repaint(scene, exchange, reflectance).light(light, 1);
  const std::vector<float> derivative = lightPerReflectance(scene, exchange, light, {0});
  EXPECT_GT(mean(derivative, 1), 0);
  EXPECT_NEAR((mean(painted, 1) - mean(light, 1)) / step / mean(derivative, 1), 1, 0.02);
}

}  // namespace
}  // namespace fiatlux
