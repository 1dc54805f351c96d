// The exchange of light, and the interpolation in it (group_interpolation), against their definitions written
// out.
#include "core/transport/exchange.h"

#include <gtest/gtest.h>

#include <cmath>

#include "core/base/random.h"
#include "tests/core/operator_scene.h"

namespace fiatlux {
namespace {

std::vector<float> randomValues(std::size_t count, std::uint64_t seed) {
  Random random(seed);
  std::vector<float> values(count);
  for (float& v : values) v = static_cast<float>(random.unit());
  return values;
}

TEST(GroupInterpolation, KeepsTheMeanOfEveryGroup) {
  const Scene scene = operatorScene(12, 2);
  const GroupInterpolation w(scene.patches, scene.lightOperator->groups);
  const std::vector<float> values = randomValues(scene.lightOperator->groups.total, 1);
  std::vector<float> rows(scene.patches.rows()), means(values.size());
  w.apply(values.data(), 1, rows.data());
  w.means(rows.data(), 1, means.data());
  for (std::size_t c = 0; c < values.size(); ++c) EXPECT_NEAR(means[c], values[c], 1e-5);
}

TEST(GroupInterpolation, IsExactForWhatIsLinearOnASurface) {
  const Scene scene = operatorScene(16, 2);
  ExchangeGroups groups = scene.lightOperator->groups;
  std::fill(groups.barriers.begin(), groups.barriers.end(), 0);
  const GroupInterpolation w(scene.patches, groups);
  std::vector<float> linear;
  for (const Vec3& c : scene.patches.center)
    linear.push_back(static_cast<float>(1 + 2 * c.x - c.y + 0.5 * c.z));
  std::vector<float> means(groups.total), rows(linear.size());
  w.means(linear.data(), 1, means.data());
  w.apply(means.data(), 1, rows.data());
  for (std::uint32_t p = 0; p < scene.patches.count; ++p) EXPECT_NEAR(rows[p], linear[p], 0.01) << p;
}

TEST(GroupInterpolation, DoesNotLookAcrossABarrier) {
  const Scene scene = operatorScene(16, 2);
  ExchangeGroups groups = scene.lightOperator->groups;
  groups.barriers.assign(groups.barriers.size(), ExchangeGroups::kLeftBarrier | ExchangeGroups::kUpBarrier);
  const GroupInterpolation w(scene.patches, groups);
  const std::vector<float> values = randomValues(groups.total, 2);
  std::vector<float> rows(scene.patches.rows());
  w.apply(values.data(), 1, rows.data());
  for (std::size_t p = 0; p < rows.size(); ++p) EXPECT_EQ(rows[p], values[groups.ofRow[p]]);
}

TEST(GroupInterpolation, ReducesByItsTranspose) {
  const Scene scene = operatorScene(12, 2);
  const std::uint32_t total = scene.lightOperator->groups.total, rows = scene.patches.rows();
  const GroupInterpolation w(scene.patches, scene.lightOperator->groups);
  const std::vector<float> x = randomValues(total, 3), y = randomValues(rows, 4);
  std::vector<float> wx(rows), sums(total), wty(total);
  w.apply(x.data(), 1, wx.data());
  w.reduce(y.data(), 1, sums.data(), wty.data());
  double left = 0, right = 0;
  for (std::size_t p = 0; p < rows; ++p) left += double{y[p]} * wx[p];
  for (std::size_t c = 0; c < total; ++c) right += double{x[c]} * wty[c];
  EXPECT_NEAR(left / right, 1, 1e-5);
}

/// S written out: W H W^T + W R^T + R, rows x patches, where R goes without its means over groups: what it
/// takes in without those of its rows, what it gives out with those taken off smoothly.
std::vector<double> fullOperator(const Scene& scene) {
  const auto& [visibility, charts, groups, exchange, surfaces] = *scene.lightOperator;
  const std::uint32_t rows = scene.patches.rows(), n = scene.patches.count, total = groups.total;
  const GroupInterpolation w(scene.patches, groups);
  std::vector<float> full(std::size_t{rows} * total), unit(std::size_t{total} * total, 0.0f);
  for (std::uint32_t c = 0; c < total; ++c) unit[std::size_t{c} * total + c] = 1;
  w.apply(unit.data(), total, full.data());
  std::vector<double> rest(std::size_t{rows} * groups.count, 0.0), s(std::size_t{rows} * n, 0.0);
  for (std::uint32_t p = 0; p < rows; ++p)
    for (std::uint32_t i = exchange.offset[p]; i < exchange.offset[p + 1]; ++i)
      rest[std::size_t{p} * groups.count + exchange.group[i]] = exchange.rest[i];
  const std::vector<double>& area = w.areas();
  std::vector<double> even(std::size_t{total} * groups.count, 0.0);  // the means of R over groups
  for (std::uint32_t p = 0; p < rows; ++p)
    for (std::uint32_t d = 0; d < groups.count; ++d)
      even[std::size_t{groups.ofRow[p]} * groups.count + d] +=
          scene.patches.area[p] / area[groups.ofRow[p]] * rest[std::size_t{p} * groups.count + d];
  for (std::uint32_t q = 0; q < n; ++q) {
    std::vector<double> between(total, 0.0);
    const std::uint32_t of = groups.ofRow[q];
    for (std::uint32_t c = 0; c < total; ++c) {
      for (std::uint32_t d = 0; d < groups.count; ++d)
        between[c] +=
            double{exchange.means[std::size_t{c} * groups.count + d]} * full[std::size_t{q} * total + d];
      if (c < groups.count)
        between[c] += rest[std::size_t{q} * groups.count + c] - even[std::size_t{of} * groups.count + c];
      between[c] -= even[std::size_t{c} * groups.count + of];
    }
    for (std::uint32_t p = 0; p < rows; ++p) {
      double& value = s[std::size_t{p} * n + q];
      value = rest[std::size_t{p} * groups.count + of];
      for (std::uint32_t c = 0; c < total; ++c) value += full[std::size_t{p} * total + c] * between[c];
    }
  }
  return s;
}

TEST(ExchangeOperator, WhatIsEvenOverAGroupLightsOthersAsTheirMeansSay) {
  // A file keeps of R only what is large: its means over groups are no longer zero, and are not light.
  const Scene scene = operatorScene(8, 2);
  const auto& [visibility, charts, groups, exchange, surfaces] = *scene.lightOperator;
  const Patches& patches = scene.patches;
  const ExchangeOperator light(patches, groups, exchange);
  const GroupInterpolation w(patches, groups);
  std::vector<float> direct(patches.rows(), 0.0f), means(groups.total), lumens(groups.count, 0.0f);
  constexpr std::uint32_t kLit = 2;
  lumens[kLit] = static_cast<float>(w.areas()[kLit]);
  for (std::uint32_t p = 0; p < patches.count; ++p)
    if (groups.ofRow[p] == kLit) direct[p] = static_cast<float>(1 / patches.reflectance[p]);
  for (const std::vector<float>& rows : {light.indirect(direct, 1), light.spread(lumens, 1)}) {
    w.means(rows.data(), 1, means.data());
    for (std::uint32_t c = 0; c < groups.total; ++c)
      EXPECT_NEAR(means[c] / (exchange.means[c * groups.count + kLit] * w.areas()[kLit]), 1, 1e-4) << c;
  }
}

TEST(ExchangeOperator, IsItsDefinitionForAnyNumberOfColumns) {
  const Scene scene = operatorScene(8, 2);
  const Patches& patches = scene.patches;
  const std::vector<double> s = fullOperator(scene);
  const ExchangeOperator exchange(patches, scene.lightOperator->groups, scene.lightOperator->exchange);
  constexpr std::uint32_t kColumns = 19;  // more than a block, and not a multiple
  const std::vector<float> direct = randomValues(std::size_t{patches.rows()} * kColumns, 5);
  const std::vector<float> light = exchange.indirect(direct, kColumns);
  for (std::uint32_t j = 0; j < kColumns; ++j)
    for (std::uint32_t p = 0; p < patches.rows(); ++p) {
      double expected = 0;
      for (std::uint32_t q = 0; q < patches.count; ++q)
        expected += s[std::size_t{p} * patches.count + q] * patches.area[q] * patches.reflectance[q] *
                    direct[std::size_t{j} * patches.rows() + q];
      ASSERT_NEAR(light[std::size_t{j} * patches.rows() + p], expected, 1e-4 * std::abs(expected) + 1e-6);
    }
}

}  // namespace
}  // namespace fiatlux
