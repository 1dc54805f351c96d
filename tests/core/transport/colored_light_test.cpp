// The colour that light takes against its definition on the exchange of light, on a made-up operator.
#include "core/transport/colored_light.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "core/transport/exchange.h"
#include "core/transport/repaint.h"
#include "tests/core/operator_scene.h"

namespace fiatlux {
namespace {

class Colored : public ::testing::Test {
 protected:
  Scene scene = operatorScene(12, 3);
  std::vector<float> light =
      std::vector<float>(scene.responses.column(1), scene.responses.column(1) + scene.patches.rows());

  /// One colour on a surface, white elsewhere.
  std::vector<float> paint(std::uint32_t surface, const Vec3& color) const {
    std::vector<float> colors(std::size_t{3} * scene.patches.count, 0.8f);
    for (std::uint32_t p = 0; p < scene.patches.count; ++p) {
      if (scene.patches.surface[p] != surface) continue;
      colors[3 * p] = static_cast<float>(color.x);
      colors[3 * p + 1] = static_cast<float>(color.y);
      colors[3 * p + 2] = static_cast<float>(color.z);
    }
    return colors;
  }
};

TEST_F(Colored, WhiteLightStaysWhiteOnGreyToTheBit) {
  const ColoredLight grey(scene, paint(1, {0.2, 0.2, 0.2}));
  EXPECT_TRUE(grey.isGrey());
  EXPECT_EQ(grey.of(light), std::vector<float>(2 * light.size(), 1.0f));
}

TEST_F(Colored, ARedWallReddensTheFloorMostWhereItIsNear) {
  const ColoredLight red(scene, paint(1, {0.7, 0.2, 0.2}));
  EXPECT_FALSE(red.isGrey());
  const std::vector<float> colors = red.of(light);
  for (std::uint32_t p = 0; p < scene.patches.count; ++p) {
    if (scene.patches.surface[p] != 0) continue;
    const float r = colors[2 * p], b = colors[2 * p + 1];
    EXPECT_GT(r, 1) << p;
    EXPECT_LT(b, 1) << p;
    EXPECT_NEAR((1 - 0.2126 * r - 0.0722 * b) / 0.7152, b, 1e-4) << p;  // green as blue, at luminance 1
  }
}

TEST_F(Colored, ADarkPatchIsNoMoreColouredThanItsSurroundings) {
  const std::vector<float> colors = paint(1, {0.9, 0.05, 0.05});
  const ColoredLight red(scene, colors);
  for (std::uint32_t p = 0; p < scene.patches.count; ++p) {
    std::vector<float> shadowed = light;
    shadowed[p] *= 0.01f;
    const std::vector<float> made = red.of(shadowed);
    EXPECT_GT(made[2 * p + 1], 0.2) << p;  // blue
    EXPECT_LT(made[2 * p], 3) << p;
  }
}

TEST_F(Colored, IsItsDefinitionBetweenGroups) {
  std::fill(light.begin(), light.end(),
            300.0f);  // for what is darker than its surroundings takes less colour
  const std::vector<float> colors = paint(1, {0.9, 0.3, 0.1});
  const Patches& patches = scene.patches;
  const ExchangeGroups& groups = scene.lightOperator->groups;
  const ExchangeOperator exchange(patches, groups, scene.lightOperator->exchange);
  const double luminance = 0.2126 * 0.9 + 0.7152 * 0.3 + 0.0722 * 0.1;
  const double channel[3] = {0.9 / luminance, 0.3 / luminance, 0.1 / luminance};
  std::vector<double> area(groups.count);
  std::vector<double> means[3];
  for (int k = 0; k < 3; ++k) {
    std::vector<double> lumens(groups.count), change(groups.count), before(groups.count), more(groups.count);
    area.assign(groups.count, 0.0);
    for (std::uint32_t p = 0; p < patches.count; ++p) {
      const double added = patches.surface[p] == 1
                               ? std::min(0.95, patches.reflectance[p] * channel[k]) - patches.reflectance[p]
                               : 0;
      change[groups.ofRow[p]] += patches.area[p] * added;
      lumens[groups.ofRow[p]] += patches.area[p] * added * light[p];
      before[groups.ofRow[p]] += patches.area[p] * light[p];
      area[groups.ofRow[p]] += patches.area[p];
    }
    for (int bounce = 0; bounce < 60; ++bounce) {
      std::vector<double> next(groups.count, 0.0);
      for (std::uint32_t c = 0; c < groups.count; ++c)
        for (std::uint32_t d = 0; d < groups.count; ++d)
          next[c] += exchange.between(c, d) * (lumens[d] + change[d] * more[d]);
      more = next;
    }
    for (std::uint32_t c = 0; c < groups.count; ++c) means[k].push_back(before[c] / area[c] + more[c]);
  }
  // The same as means over the groups of E times its colour.
  const std::vector<float> made = ColoredLight(scene, colors).of(light);
  std::vector<double> red(groups.count, 0.0);
  for (std::uint32_t p = 0; p < patches.count; ++p)
    red[groups.ofRow[p]] += patches.area[p] * light[p] * made[2 * p] / area[groups.ofRow[p]];
  for (std::uint32_t c = 0; c < groups.count; ++c) {
    const double all = 0.2126 * means[0][c] + 0.7152 * means[1][c] + 0.0722 * means[2][c];
    const double expected = means[0][c] / all;
    double lit = 0;
    for (std::uint32_t p = 0; p < patches.count; ++p)
      if (groups.ofRow[p] == c) lit += patches.area[p] * light[p] / area[c];
    EXPECT_NEAR(red[c] / lit, expected, 0.002 * expected) << c;
  }
}

TEST_F(Colored, InAPaintedRoomEachChannelIsPaintedByItself) {
  // A red wall above a floor that is painted darker.
  const Vec3 red = {0.7, 0.2, 0.2};
  const std::vector<float> colors = paint(1, red);
  const Patches& patches = scene.patches;
  const ExchangeOperator exchange(patches, scene.lightOperator->groups, scene.lightOperator->exchange);
  std::vector<float> darker(patches.reflectance.begin(), patches.reflectance.begin() + patches.count);
  for (std::uint32_t p = 0; p < patches.count; ++p)
    if (patches.surface[p] == 0) darker[p] *= 0.5f;
  const std::vector<float> made =
      ColoredLight(scene, colors, darker).of(Repaint(scene, exchange, darker).light(light, 1));
  std::vector<float> channels[3];
  for (int k = 0; k < 3; ++k) {
    const double own[3] = {red.x, red.y, red.z};
    const double luminance = 0.2126 * red.x + 0.7152 * red.y + 0.0722 * red.z;
    std::vector<float> reflectance = darker;
    for (std::uint32_t p = 0; p < patches.count; ++p)
      if (patches.surface[p] == 1)
        reflectance[p] = std::min(0.95f, static_cast<float>(darker[p] * own[k] / luminance));
    channels[k] = Repaint(scene, exchange, reflectance).light(light, 1);
  }
  double made0 = 0, expected0 = 0;
  for (std::uint32_t p = 0; p < patches.count; ++p) {
    if (patches.surface[p] != 0) continue;
    const double all = 0.2126 * channels[0][p] + 0.7152 * channels[1][p] + 0.0722 * channels[2][p];
    made0 += made[2 * p];
    expected0 += channels[0][p] / all;
  }
  EXPECT_NEAR(made0 / expected0, 1, 0.01);
  EXPECT_EQ(ColoredLight(scene, colors, {patches.reflectance}).of(light),
            ColoredLight(scene, colors).of(light));
}

}  // namespace
}  // namespace fiatlux
