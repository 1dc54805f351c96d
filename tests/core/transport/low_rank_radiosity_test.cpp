// The low-rank inverse against a radiosity system written out in full (form_factors, site_responses).
#include "core/transport/low_rank_radiosity.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "core/base/random.h"
#include "core/transport/column_block.h"
#include "core/transport/site_responses.h"

namespace fiatlux {
namespace {

/// n patches in k clusters, each row of F with `rays` random hits and some slopes: a closed room that no
/// geometry need have.
struct RandomRoom {
  Patches patches;
  FormFactors factors;
  std::vector<double> full;  // n x n, the F that irradiance() applies

  RandomRoom(std::uint32_t n, std::uint32_t k, std::uint32_t rays) {
    Random random(7);
    patches.count = n;
    patches.clusterCount = k;
    std::vector<double> clusterArea(k, 0.0);
    for (std::uint32_t p = 0; p < n; ++p) {
      patches.area.push_back(0.5 + random.unit());
      patches.reflectance.push_back(static_cast<float>(0.2 + 0.7 * random.unit()));
      patches.surface.push_back(0);
      patches.cluster.push_back(p % k);
      clusterArea[p % k] += patches.area[p];
    }
    factors.rows = factors.count = n;
    factors.clusters = k;
    factors.cluster = patches.cluster;
    factors.u.assign(std::size_t{n} * k, 0.0f);
    factors.near.resize(n);
    factors.slopes.resize(n);
    factors.lost.assign(n, 0.0f);
    full.assign(std::size_t{n} * n, 0.0);
    for (std::uint32_t p = 0; p < n; ++p) factors.share.push_back(patches.area[p] / clusterArea[p % k]);
    for (std::uint32_t p = 0; p < n; ++p) {
      std::vector<std::uint32_t> hits(rays);
      for (std::uint32_t& hit : hits) hit = random.below(n);
      std::sort(hits.begin(), hits.end());
      for (const std::uint32_t hit : hits) {
        factors.u[std::size_t{p} * k + hit % k] += 1.0f / static_cast<float>(rays);
        factors.near[p].push_back({hit, 1.0f / static_cast<float>(rays)});
        full[std::size_t{p} * n + hit] += 1.0 / rays;
      }
    }
    for (std::uint32_t i = 0; i < 2 * n; ++i)
      factors.slopeShare.push_back(static_cast<float>(0.1 * random.unit() - 0.05));
    for (std::uint32_t p = 0; p < n; p += 2) addSlope(p, p % k, static_cast<std::int8_t>(p), -100);
  }

  void addSlope(std::uint32_t p, std::uint32_t cluster, std::int8_t u, std::int8_t v) {
    factors.slopes[p].push_back({static_cast<std::uint16_t>(cluster), u, v});
    for (std::uint32_t q = cluster; q < factors.count; q += factors.clusters)
      full[std::size_t{p} * factors.count + q] +=
          factors.u[std::size_t{p} * factors.clusters + cluster] / 127.0 *
          (u * factors.slopeShare[2 * q] + v * factors.slopeShare[2 * q + 1]);
  }
};

TEST(FormFactors, IrradianceIsTheFullMatrixTimesExitance) {
  const RandomRoom room(60, 12, 64);
  for (const std::uint32_t width : {1u, 3u, 8u, 16u, 32u}) {
    Random random(width);
    std::vector<float> b(60 * width), out(60 * width);
    for (float& value : b) value = static_cast<float>(random.unit());
    irradiance(room.factors, b.data(), width, out.data());
    for (std::uint32_t p = 0; p < 60; ++p) {
      for (std::uint32_t j = 0; j < width; ++j) {
        double expected = 0;
        for (std::uint32_t q = 0; q < 60; ++q) expected += room.full[p * 60 + q] * b[q * width + j];
        EXPECT_NEAR(out[p * width + j], expected, 1e-5);
      }
    }
  }
}

TEST(FormFactors, TransposedIrradianceIsTheFullMatrixFromTheOtherSide) {
  constexpr std::uint32_t kWidth = kColumnBlock;
  for (const std::uint32_t n : {60u, 63u}) {  // whole fours of rows, and not
    const RandomRoom room(n, 12, 64);
    Random random(3);
    std::vector<float> w(n * kWidth), out(n * kWidth);
    for (float& value : w) value = static_cast<float>(random.unit());
    for (std::uint32_t j = 0; j < kWidth; ++j) w[7 * kWidth + j] = 0;
    transposedIrradiance(room.factors, w.data(), out.data());
    for (std::uint32_t q = 0; q < n; ++q) {
      for (std::uint32_t j = 0; j < kWidth; ++j) {
        double expected = 0;
        for (std::uint32_t p = 0; p < n; ++p) expected += room.full[p * n + q] * w[p * kWidth + j];
        EXPECT_NEAR(out[q * kWidth + j], expected, 2e-5);
      }
    }
  }
}

TEST(LowRankRadiosity, SolvesItsOwnSystem) {
  const RandomRoom room(60, 12, 64);
  const auto lowRank = LowRankRadiosity::factorize(room.factors, room.patches);
  ASSERT_TRUE(lowRank) << lowRank.error().message;
  std::vector<float> e(60 * 2), b(60 * 2), x(12 * 2);
  Random random(3);
  for (float& value : e) value = static_cast<float>(random.unit());
  lowRank->solve(e.data(), 2, b.data());
  reduce(room.factors, b.data(), 2, x.data());
  for (std::uint32_t p = 0; p < 60; ++p) {
    for (std::uint32_t j = 0; j < 2; ++j) {
      double gathered = 0;
      for (std::uint32_t c = 0; c < 12; ++c) gathered += room.factors.u[p * 12 + c] * x[c * 2 + j];
      EXPECT_NEAR(b[p * 2 + j] - room.patches.reflectance[p] * gathered, e[p * 2 + j], 1e-5);
    }
  }
}

TEST(LowRankRadiosity, GathersWhatItsAnswerSends) {
  const RandomRoom room(60, 12, 64);
  const auto lowRank = LowRankRadiosity::factorize(room.factors, room.patches);
  ASSERT_TRUE(lowRank);
  for (const std::uint32_t width : {1u, 8u, 32u}) {
    std::vector<float> e(60 * width), alone(e.size()), b(e.size()), gathered(e.size()), expected(e.size());
    Random random(width);
    for (float& value : e) value = static_cast<float>(random.unit());
    lowRank->solve(e.data(), width, alone.data());
    lowRank->solve(e.data(), width, b.data(), gathered.data());
    irradiance(room.factors, b.data(), width, expected.data());
    for (std::size_t at = 0; at < e.size(); ++at) {
      EXPECT_EQ(b[at], alone[at]);
      EXPECT_NEAR(gathered[at], expected[at], 1e-5);
    }
  }
}

TEST(LowRankRadiosity, YGivesTheSameAnswer) {
  const RandomRoom room(40, 10, 32);
  const auto lowRank = LowRankRadiosity::factorize(room.factors, room.patches);
  ASSERT_TRUE(lowRank);
  const std::vector<float> y = lowRank->y();
  std::vector<float> e(40), b(40), x(10);
  for (std::uint32_t p = 0; p < 40; ++p) e[p] = static_cast<float>(p % 7);
  lowRank->solve(e.data(), 1, b.data());
  reduce(room.factors, e.data(), 1, x.data());
  for (std::uint32_t p = 0; p < 40; ++p) {
    double expected = e[p];
    for (std::uint32_t c = 0; c < 10; ++c) expected -= double{y[p * 10 + c]} * x[c];
    EXPECT_NEAR(b[p], expected, 1e-4);
  }
}

TEST(LowRankRadiosity, RefusesARoomThatReflectsEverything) {
  RandomRoom room(20, 5, 16);
  std::fill(room.patches.reflectance.begin(), room.patches.reflectance.end(), 1.0f);
  const auto lowRank = LowRankRadiosity::factorize(room.factors, room.patches);
  ASSERT_FALSE(lowRank);
  EXPECT_NE(lowRank.error().message.find("reflect"), std::string::npos);
}

TEST(SiteResponses, RefinementConvergesToTheFullSolution) {
  const RandomRoom room(60, 12, 64);
  const auto lowRank = LowRankRadiosity::factorize(room.factors, room.patches);
  ASSERT_TRUE(lowRank);
  ResponseBlock block;
  block.width = 8;
  block.direct.resize(60 * 8);
  Random random(5);
  for (float& value : block.direct) value = static_cast<float>(random.unit());
  solveResponses(room.factors, room.patches, *lowRank, 40, 1e-6, block);
  EXPECT_LE(block.residuals.back(), 1e-6);
  EXPECT_LT(block.residuals.size(), 41u * 8u);
  // b = rho (D + F b), and g = D + F b, with F written out.
  for (std::uint32_t p = 0; p < 60; ++p) {
    for (std::uint32_t j = 0; j < 8; ++j) {
      double light = block.direct[p * 8 + j];
      for (std::uint32_t q = 0; q < 60; ++q) light += room.full[p * 60 + q] * block.radiosity[q * 8 + j];
      EXPECT_NEAR(block.irradiance[p * 8 + j], light, 2e-5 * light);
      EXPECT_NEAR(block.radiosity[p * 8 + j], room.patches.reflectance[p] * light, 2e-5 * light);
    }
  }
}

/// A room whose clusters say little of it: a chain of niches, each of which sees its neighbours alone.
void niches(std::uint32_t n, FormFactors& factors, Patches& patches) {
  constexpr std::uint32_t kTogether = 8;
  const std::uint32_t k = n / kTogether;
  patches.count = n;
  patches.clusterCount = k;
  factors.rows = factors.count = n;
  factors.clusters = k;
  factors.u.assign(std::size_t{n} * k, 0.0f);
  factors.near.resize(n);
  factors.slopes.resize(n);
  factors.slopeShare.assign(std::size_t{n} * 2, 0.0f);
  factors.lost.assign(n, 0.0f);
  factors.share.assign(n, 1.0 / kTogether);
  for (std::uint32_t p = 0; p < n; ++p) {
    patches.area.push_back(1);
    patches.reflectance.push_back(0.9f);
    patches.surface.push_back(0);
    patches.cluster.push_back(p / kTogether);
    for (const std::uint32_t q : {p == 0 ? n - 1 : p - 1, p + 1 == n ? 0 : p + 1}) {
      factors.near[p].push_back({q, 0.5f});
      factors.u[std::size_t{p} * k + q / kTogether] += 0.5f;
    }
    std::sort(factors.near[p].begin(), factors.near[p].end(),
              [](const NearPatch& a, const NearPatch& b) { return a.patch < b.patch; });
  }
  factors.cluster = patches.cluster;
}

/// Steps b <- b + (I - Y V^T)(e - (I - R F) b) until so little is left of e, the light of patch 0.
std::uint32_t plainSteps(const FormFactors& factors, const Patches& patches, const LowRankRadiosity& lowRank,
                         double tolerance) {
  std::vector<float> b(patches.count), gathered(patches.count), residual(patches.count), step(patches.count);
  residual[0] = 1;
  for (std::uint32_t steps = 0; steps < 1000; ++steps) {
    lowRank.solve(residual.data(), 1, step.data());
    for (std::uint32_t p = 0; p < patches.count; ++p) b[p] += step[p];
    irradiance(factors, b.data(), 1, gathered.data());
    double left = 0;
    for (std::uint32_t p = 0; p < patches.count; ++p) {
      residual[p] = (p == 0 ? 1.0f : 0.0f) - b[p] + patches.reflectance[p] * gathered[p];
      left += double{residual[p]} * residual[p];
    }
    if (std::sqrt(left) <= tolerance) return steps;
  }
  return 1000;
}

TEST(SiteResponses, AChainOfNichesSettlesInFarFewerStepsThanPlainRefinementTakes) {
  constexpr std::uint32_t kPatches = 64;
  FormFactors factors;
  Patches patches;
  niches(kPatches, factors, patches);
  const auto lowRank = LowRankRadiosity::factorize(factors, patches);
  ASSERT_TRUE(lowRank);
  ResponseBlock block;
  block.width = 2;
  block.direct.assign(kPatches * 2, 0.0f);
  block.direct[0] = block.direct[2 * 40 + 1] = 1;
  solveResponses(factors, patches, *lowRank, 24, 1e-3, block);
  const std::size_t steps = block.residuals.size() / 2 - 1;
  EXPECT_LE(block.residuals[2 * steps], 1e-3);
  EXPECT_LE(block.residuals[2 * steps + 1], 1e-3);
  EXPECT_LT(2 * steps, plainSteps(factors, patches, *lowRank, 1e-3));
  for (std::size_t at = 2; at < block.residuals.size(); ++at)
    EXPECT_LE(block.residuals[at], block.residuals[at - 2] * (1 + 1e-6));
}

TEST(SiteResponses, ResidualsFallWithEveryStep) {
  const RandomRoom room(60, 12, 64);
  const auto lowRank = LowRankRadiosity::factorize(room.factors, room.patches);
  ASSERT_TRUE(lowRank);
  ResponseBlock block;
  block.width = 1;
  block.direct.assign(60, 0.0f);
  block.direct[4] = 1;
  solveResponses(room.factors, room.patches, *lowRank, 3, 0, block);
  ASSERT_EQ(block.residuals.size(), 4u);
  for (std::size_t step = 1; step < 4; ++step)
    EXPECT_LT(block.residuals[step], 0.5 * block.residuals[step - 1]);
}

}  // namespace
}  // namespace fiatlux
