// The light of rooms whose answers are known in closed form (cast_form_factors, kernel_factors,
// cluster_parts, direct_light, forward_light, paper_transport).
#include "precompute/light/transport.h"

#include <gtest/gtest.h>

#include <cmath>
#include <set>

#include "core/transport/low_rank_radiosity.h"
#include "core/transport/polygon_form_factor.h"
#include "precompute/light/cast_form_factors.h"
#include "precompute/light/forward_light.h"
#include "precompute/light/kernel_factors.h"
#include "precompute/validation/rectangle_room.h"
#include "tests/precompute/furnished_box.h"
#include "tests/precompute/transport_of.h"

namespace fiatlux {
namespace {

using testing::transportOf;

/// A closed box of one reflectance, 3 x 2.5 x 4 m, with a grid of sites on its ceiling.
Room litBox(double reflectance, double patch = 0.25) {
  const auto faces = boxSurfaces({0, 0, 0}, {3, 2.5, 4}, reflectance, patch);
  Room room = rectangleRoom(faces);
  room.sites = siteGrid(faces[1], 3, 4, 0.5);
  return room;
}

/// The same with a block, a measuring plane at 0.75 m and surfaces of different reflectance.
Room boxWithBlock(double patch = 0.25) {
  return testing::furnishedBox({3, 2.5, 4}, blockSurfaces("block", {1, 0.3, 1}, {1, 0.4, 1}, 0.6, patch),
                               patch);
}

double energy(const Room& room, const float* illuminance) {
  double sum = 0;
  for (std::uint32_t p = 0; p < room.patches.count; ++p) {
    sum += room.patches.area[p] * (1 - room.patches.reflectance[p]) * illuminance[p];
  }
  return sum;
}

double sigmaOf(const SurfaceStatistics& s, std::uint32_t site) {
  return std::sqrt(s.covariance[site * s.mean.size() + site]);
}

TEST(Transport, ClosedBoxOfOneReflectanceHasItsKnownMean) {
  for (const double rho : {0.2, 0.8}) {
    const Room room = litBox(rho);
    const auto transport = transportOf(room);
    ASSERT_TRUE(transport) << transport.error().message;
    double area = 0;
    for (const Surface& s : room.surfaces) area += s.area;
    for (std::uint32_t j = 0; j < transport->responses.sites; ++j) {
      double mean = 0;
      for (std::size_t s = 0; s < room.surfaces.size(); ++s) {
        mean += room.surfaces[s].area / area * transport->exitance[s].mean[j];
      }
      EXPECT_NEAR(mean / (rho / ((1 - rho) * area)), 1, 0.005) << "site " << j;
      EXPECT_NEAR(energy(room, transport->responses.column(j)), 1, 0.005) << "site " << j;
    }
  }
}

TEST(Transport, SameSeedGivesTheSameBitsOnAnyNumberOfThreads) {
  const Room room = boxWithBlock();
  TransportOptions options;
  options.rays = 256;
  options.threads = 1;
  const auto one = transportOf(room, options);
  options.threads = 5;
  const auto five = transportOf(room, options);
  ASSERT_TRUE(one && five);
  EXPECT_EQ(one->factors.u, five->factors.u);
  EXPECT_EQ(one->factors.near, five->factors.near);
  EXPECT_EQ(one->factors.slopes, five->factors.slopes);
  EXPECT_EQ(one->direct, five->direct);
  EXPECT_EQ(one->responses.illuminance, five->responses.illuminance);
  for (std::size_t s = 0; s < room.surfaces.size(); ++s) {
    EXPECT_EQ(one->illuminance[s].covariance, five->illuminance[s].covariance);
  }
  EXPECT_EQ(one->residuals, five->residuals);
}

// note: except sigmas of the block's sides, lit so evenly (0.3 % of the mean) that a change of 0.05 % in
// single patches is a tenth of sigma.
TEST(Transport, AnotherSeedMovesMeansByHalfAPercentAndSigmasByOne) {
  const Room room = boxWithBlock();
  TransportOptions options;
  const auto one = transportOf(room, options);
  options.seed = 2;
  const auto two = transportOf(room, options);
  ASSERT_TRUE(one && two);
  EXPECT_NE(one->responses.illuminance, two->responses.illuminance);
  for (std::uint32_t j = 0; j < one->responses.sites; ++j) {
    double mean = 0, area = 0;
    for (std::size_t s = 0; s < room.surfaces.size(); ++s) {
      mean += room.surfaces[s].area * one->illuminance[s].mean[j];
      area += room.surfaces[s].area;
    }
    mean /= area;
    for (std::size_t s = 0; s < room.surfaces.size(); ++s) {
      const SurfaceStatistics &a = one->illuminance[s], &b = two->illuminance[s];
      const bool bright = a.mean[j] > 0.05 * mean;
      EXPECT_NEAR(b.mean[j] / a.mean[j], 1, bright ? 0.005 : 0.02) << room.surfaces[s].name << ", site " << j;
      if (sigmaOf(a, j) < 0.005 * a.mean[j]) continue;
      EXPECT_NEAR(sigmaOf(b, j) / sigmaOf(a, j), 1, bright ? 0.01 : 0.05)
          << room.surfaces[s].name << ", site " << j;
    }
  }
}

TEST(Transport, RefinementFallsAndTheForwardSolutionAgrees) {
  const Room room = boxWithBlock();
  const auto transport = transportOf(room);
  ASSERT_TRUE(transport);
  ASSERT_GE(transport->residuals.size(), 3u);
  EXPECT_LE(transport->residuals.back(), kSettled);
  EXPECT_LT(transport->residuals[2], 0.3 * transport->residuals[1]);
  const auto tracer = RayTracer::build(room);
  ASSERT_TRUE(tracer);
  Luminaire lamp;
  lamp.position = room.sites[5].position;
  lamp.width = lamp.height = room.sites[5].size;
  lamp.flux = 1;
  const auto light = computeForwardLight(room, *tracer, {lamp}, {});
  ASSERT_TRUE(light);
  EXPECT_LE(light->residual, 1e-6);
  EXPECT_NEAR(light->energy.imbalance, 0, 0.005);
  double squares = 0, sum = 0;
  for (std::uint32_t p = 0; p < room.patches.rows(); ++p) {
    squares += std::pow(transport->responses.column(5)[p] - light->illuminance[p], 2);
    sum += light->illuminance[p];
  }
  EXPECT_LT(std::sqrt(squares / room.patches.rows()), 0.02 * sum / room.patches.rows());
}

/// Lambert's polygon from the middle of patch p to the square patch q.
double exactFactor(const Room& room, std::uint32_t p, std::uint32_t q) {
  const Chart& chart = room.charts[room.chartOfPatch[q]];
  const Vec3 u = 0.5 * chart.cellU * chart.uAxis, v = 0.5 * chart.cellV * chart.vAxis;
  const Vec3 c = room.patches.center[q];
  const Vec3 corners[] = {c - u - v, c + u - v, c + u + v, c - u + v};
  return polygonFormFactor(room.patches.center[p], room.patches.normal[p], corners, 4);
}

TEST(FormFactors, ASmallBrightSpotIsSeenWithoutNoiseWhereverItIs) {
  const Room room = litBox(0.5);
  const auto tracer = RayTracer::build(room);
  ASSERT_TRUE(tracer);
  const FormFactors factors = castFormFactors(room, *tracer, {256, false, 1, 0, {}});
  std::vector<float> shining(factors.count), received(factors.rows);
  // A patch in the middle of its cluster and one at its corner, of the ceiling and of a wall.
  for (const std::uint32_t spot : {200u, 205u, 400u, 409u}) {
    std::fill(shining.begin(), shining.end(), 0.0f);
    shining[spot] = 1;
    SCOPED_TRACE(std::to_string(spot));
    irradiance(factors, shining.data(), 1, received.data());
    for (std::uint32_t p = 0; p < factors.count; ++p) {
      const double exact = exactFactor(room, p, spot);
      if (length(room.patches.center[p] - room.patches.center[spot]) < 0.8) continue;  // there rays tell
      // A cosine ray of 256 is 0.004 of the light, as much as the whole spot gives.
      ASSERT_NEAR(received[p], exact, 0.1 * exact + 2e-4) << "patch " << p;
    }
  }
}

TEST(FormFactors, MoreRaysMeanLessNoiseOfWhatIsPartlyHidden) {
  const Room room = boxWithBlock();
  const auto tracer = RayTracer::build(room);
  ASSERT_TRUE(tracer);
  const auto noise = [&](std::uint32_t rays) {
    const FormFactors one = castFormFactors(room, *tracer, {rays, false, 1, 0, {}});
    const FormFactors two = castFormFactors(room, *tracer, {rays, false, 2, 0, {}});
    double squares = 0;
    for (std::size_t i = 0; i < one.u.size(); ++i) squares += std::pow(one.u[i] - two.u[i], 2);
    return std::sqrt(squares);
  };
  const double usual = noise(1024);
  EXPECT_LT(noise(4096), 0.6 * usual);
  EXPECT_GT(usual, 0);
}

/// Mean irradiance of the ceiling (the second surface) where the floor shines `open` below the sky and not at
/// all below the table.
double ceilingOverATable(const Room& room, const FormFactors& factors, const std::vector<bool>& isBelow) {
  std::vector<float> shining(factors.count), received(factors.rows);
  for (std::uint32_t p = 0; p < factors.count; ++p)
    shining[p] = room.patches.surface[p] == 0 && !isBelow[p] ? 1 : 0;
  irradiance(factors, shining.data(), 1, received.data());
  double sum = 0, area = 0;
  for (std::uint32_t p = 0; p < factors.count; ++p) {
    if (room.patches.surface[p] != 1) continue;
    sum += room.patches.area[p] * received[p];
    area += room.patches.area[p];
  }
  return sum / area;
}

TEST(FormFactors, FloorInTheOpenIsSeenFromAfarAndFloorUnderATableIsNot) {
  // The table's edges run through clusters of the floor; nothing of what lies below is seen from the ceiling.
  const Vec3 low{0.75, 0.1, 1.25}, size{1.25, 0.05, 1.75};
  const Room room = testing::furnishedBox({3, 2.5, 4}, blockSurfaces("table", low, size, 0.6, 0.25), 0.25);
  const auto tracer = RayTracer::build(room);
  ASSERT_TRUE(tracer);
  std::vector<bool> isBelow;
  for (const Vec3& c : room.patches.center)
    isBelow.push_back(c.x > low.x && c.x < low.x + size.x && c.z > low.z && c.z < low.z + size.z);
  const double byRays =
      ceilingOverATable(room, castFormFactors(room, *tracer, {4096, true, 1, 0, {}}), isBelow);
  const FormFactors factors = castFormFactors(room, *tracer, {1024, false, 1, 0, {}});
  EXPECT_NEAR(ceilingOverATable(room, factors, isBelow) / byRays, 1, 0.005);
  std::vector<double> sums(factors.clusters);
  for (std::uint32_t q = 0; q < factors.count; ++q) sums[factors.cluster[q]] += factors.share[q];
  for (const double sum : sums) EXPECT_NEAR(sum, 1, 1e-9);
}

/// What some rows get from some clusters, with as many rays as patches of a large surface have, on average of
/// eight seeds, over what very many rays tell.
double overRaysAlone(const Room& room, const RayTracer& tracer, const std::vector<std::uint32_t>& rows,
                     const std::vector<bool>& isAsked) {
  const auto sum = [&](const CastOptions& options) {
    const FormFactorCaster caster(room, tracer, options);
    double all = 0;
    for (const std::uint32_t p : rows) {
      const FormFactorRow row = caster.row(p);
      for (std::uint32_t c = 0; c < room.patches.clusterCount; ++c) all += isAsked[c] ? row.u[c] : 0;
    }
    return all;
  };
  double mean = 0;
  for (std::uint64_t seed = 1; seed <= 8; ++seed) mean += sum({1024, false, seed, 0, {}, true}) / 8;
  return mean / sum({32768, true, 1, 0, {}});
}

TEST(FormFactors, WhatComesThroughANarrowGapIsNotMissed) {
  // Two boards before a wall, 3 cm apart: what they see between them of the rest of the room.
  auto boards = blockSurfaces("lower", {2, 0.9, 0}, {1, 0.05, 0.3}, 0.6, 0.2);
  const auto upper = blockSurfaces("upper", {2, 0.98, 0}, {1, 0.05, 0.3}, 0.6, 0.2);
  boards.insert(boards.end(), upper.begin(), upper.end());
  const Room room = testing::furnishedBox({5, 2.5, 5}, boards, 0.2);
  const auto tracer = RayTracer::build(room);
  ASSERT_TRUE(tracer);
  const Patches& patches = room.patches;
  std::vector<std::uint32_t> between;
  std::vector<bool> isOther(patches.clusterCount, true);
  for (std::uint32_t p = 0; p < patches.count; ++p) {
    const Vec3& c = patches.center[p];
    const bool isBoard = c.x > 1.9 && c.x < 3.1 && c.y > 0.89 && c.y < 1.04 && c.z < 0.31 && c.z > 0;
    if (isBoard) isOther[patches.cluster[p]] = false;
    if (isBoard && std::abs(patches.normal[p].y) > 0.9 && std::abs(c.y - 0.965) < 0.016) between.push_back(p);
  }
  ASSERT_GE(between.size(), 10u);
  EXPECT_NEAR(overRaysAlone(room, *tracer, between, isOther), 1, 0.05);
}

TEST(FormFactors, ClustersFarAwayOfWhichOneStandsForOthersAreSeenAsOftenAsTheyAre) {
  // From one end of a corridor the other one, behind a pillar: clusters that want half a ray each, at most.
  const Room room =
      testing::furnishedBox({2, 2, 12}, blockSurfaces("pillar", {0.5, 0, 6}, {0.6, 1.5, 0.3}, 0.6, 0.1), 0.1);
  const auto tracer = RayTracer::build(room);
  ASSERT_TRUE(tracer);
  const Patches& patches = room.patches;
  std::vector<std::uint32_t> near;
  std::vector<bool> isFar(patches.clusterCount);
  for (std::uint32_t p = 0; p < patches.count; ++p) {
    const double z = patches.center[p].z;
    if (z < 1e-6 && p % 9 == 0) near.push_back(p);
    if (z > 9) isFar[patches.cluster[p]] = true;
  }
  ASSERT_GE(near.size(), 30u);
  EXPECT_NEAR(overRaysAlone(room, *tracer, near, isFar), 1, 0.02);
}

TEST(FormFactors, NoRayToAPatchThatIsTooCloseForKernelsEndsBeforeIt) {
  const Room room = boxWithBlock();
  const auto tracer = RayTracer::build(room);
  ASSERT_TRUE(tracer);
  const KernelFactors kernels(room, *tracer, 1, 5e-4);
  for (std::uint32_t p = 0; p < room.patches.rows(); ++p) {
    double furthest = 0;
    for (std::uint32_t q = 0; q < room.patches.count; ++q) {
      if (!kernels.tooClose(p, q)) continue;
      for (const Fragment& to : room.fragmentsOf(q))
        for (const Fragment& from : room.fragmentsOf(p))
          for (const Vec3& end : to.corner)
            for (const Vec3& start : from.corner) furthest = std::max(furthest, length(end - start));
    }
    ASSERT_LE(furthest, kernels.closeReach(p)) << "patch " << p;
  }
}

TEST(Transport, MeasuringPlaneReceivesButDoesNotReflect) {
  const Room room = boxWithBlock();
  const auto transport = transportOf(room);
  ASSERT_TRUE(transport);
  const std::size_t plane = room.surfaces.size() - 1;
  ASSERT_TRUE(room.surfaces[plane].measuring);
  EXPECT_TRUE(transport->exitance[plane].mean.empty());
  // Above the floor, below the lamps: brighter than the floor, and the energy balance does not know it.
  for (std::uint32_t j = 0; j < transport->responses.sites; ++j) {
    EXPECT_GT(transport->illuminance[plane].mean[j], transport->illuminance[0].mean[j]);
    EXPECT_NEAR(energy(room, transport->responses.column(j)), 1, 0.005);
  }
}

TEST(Transport, OpenRoomReportsWhatItLoses) {
  auto faces = boxSurfaces({0, 0, 0}, {2, 2, 2}, 0.5, 0.25);
  faces.erase(faces.begin() + 1);  // no ceiling: each wall loses F = 0.2000 to the opening, the floor 0.1998
  Room room = rectangleRoom(faces);
  room.sites = siteGrid(faces[0], 1, 1, 0.5);
  const auto transport = transportOf(room);
  ASSERT_TRUE(transport);
  EXPECT_NEAR(transport->lost[0], 0.199825, 0.002);
  EXPECT_NEAR(transport->lost[1], 0.200044, 0.002);
}

TEST(Transport, LightIsAFiniteNumberAndNeverNegativeHoweverFewTheRays) {
  TransportOptions options;
  options.rays = 8;
  options.refine = 1;
  const auto transport = transportOf(boxWithBlock(), options);
  ASSERT_TRUE(transport);
  for (const float lux : transport->responses.illuminance) {
    ASSERT_TRUE(std::isfinite(lux));
    ASSERT_GE(lux, 0);
  }
  for (const auto& row : transport->factors.near) {
    for (const NearPatch& near : row) ASSERT_LE(near.factor, 1.001f);
  }
}

/// Emission (lm/m2) of luminaires of a flux on sites of 0.5 m, spread evenly over the patches under them.
std::vector<float> emissionUnder(const Room& room,
                                 const std::vector<std::pair<std::uint32_t, double>>& fluxOfSite) {
  const Patches& patches = room.patches;
  std::vector<float> e(patches.count, 0.0f);
  for (const auto& [site, flux] : fluxOfSite) {
    for (std::uint32_t p = 0; p < patches.count; ++p) {
      const Vec3 d = patches.center[p] - room.sites[site].position;
      if (std::abs(d.y) < 1e-6 && std::abs(d.x) < 0.25 && std::abs(d.z) < 0.25)
        e[p] += static_cast<float>(flux / 0.25);
    }
  }
  return e;
}

TEST(Transport, PaperModeGivesEquations8And10And11ToTheLetter) {
  const Room room = boxWithBlock();
  TransportOptions options;
  options.paper = true;
  options.rays = 256;
  const auto transport = transportOf(room, options);
  ASSERT_TRUE(transport && transport->paper);
  const Patches& patches = room.patches;
  const PaperTransport& paper = *transport->paper;
  const std::uint32_t n = patches.count, k = patches.clusterCount, m = transport->responses.sites;

  // An emission vector of two sites: E in lm/m2.
  const std::vector<float> e = emissionUnder(room, {{1, 800.0}, {7, 1500.0}});
  std::vector<float> x(k);
  reduce(transport->factors, e.data(), 1, x.data());

  // B without the emission itself, by the explicit vector of equation (4).
  const auto lowRank = LowRankRadiosity::factorize(transport->factors, patches);
  ASSERT_TRUE(lowRank);
  std::vector<float> b(n);
  lowRank->solve(e.data(), 1, b.data());
  for (std::uint32_t p = 0; p < n; ++p) b[p] -= e[p];

  for (std::size_t s = 0; s < room.surfaces.size(); ++s) {
    if (room.surfaces[s].measuring) continue;
    double area = 0, mean = 0, variance = 0;
    for (std::uint32_t p = 0; p < n; ++p) {
      if (patches.surface[p] != s) continue;
      area += patches.area[p];
      mean += patches.area[p] * b[p];
    }
    mean /= area;
    for (std::uint32_t p = 0; p < n; ++p) {
      if (patches.surface[p] == s) variance += patches.area[p] / area * std::pow(b[p] - mean, 2);
    }
    // Over the k clusters (8), (10), (11).
    double mu = 0, form = 0;
    for (std::uint32_t i = 0; i < k; ++i) {
      mu += paper.exitance[s].mean[i] * x[i];
      for (std::uint32_t j = 0; j < k; ++j)
        form += double{x[i]} * x[j] * paper.exitance[s].covariance[i * k + j];
    }
    EXPECT_NEAR(mu / mean, 1, 1e-5) << room.surfaces[s].name;
    EXPECT_NEAR(std::sqrt(form / variance), 1, 1e-5) << room.surfaces[s].name;
    // The same over the sites.
    const SurfaceStatistics& sites = transport->exitance[s];
    const double f1 = 800, f7 = 1500;
    const double sigma =
        std::sqrt(f1 * f1 * sites.covariance[1 * m + 1] + f7 * f7 * sites.covariance[7 * m + 7] +
                  2 * f1 * f7 * sites.covariance[1 * m + 7]);
    EXPECT_NEAR((f1 * sites.mean[1] + f7 * sites.mean[7]) / mean, 1, 1e-4) << room.surfaces[s].name;
    EXPECT_NEAR(sigma / std::sqrt(variance), 1, 1e-4) << room.surfaces[s].name;
  }
}

TEST(Transport, RefusesARoomWithoutSurfaces) {
  const auto transport = transportOf(Room{});
  ASSERT_FALSE(transport);
  EXPECT_NE(transport.error().message.find("no surfaces"), std::string::npos);
}

/// Sigma of the wall's direct light by a lamp of 0.25 m whose centre is `distance` from it.
double wallSigma(double distance, double patch) {
  auto faces = boxSurfaces({0, 0, 0}, {3, 2.5, 3}, 0.5, patch);
  const Room room = rectangleRoom(faces);
  const auto tracer = RayTracer::build(room);
  Luminaire lamp;
  lamp.position = {distance, 2.5, 1.4};
  lamp.width = lamp.height = 0.25;
  lamp.flux = 1000;
  ForwardOptions options;
  options.rays = 512;
  const auto light = computeForwardLight(room, *tracer, {lamp}, options);
  double area = 0, mean = 0, squares = 0;
  for (std::uint32_t p = 0; p < room.patches.count; ++p) {
    if (room.surfaces[room.patches.surface[p]].name != "wall -x") continue;
    area += room.patches.area[p];
    mean += room.patches.area[p] * light->illuminance[p];
  }
  mean /= area;
  for (std::uint32_t p = 0; p < room.patches.count; ++p) {
    if (room.surfaces[room.patches.surface[p]].name != "wall -x") continue;
    squares += room.patches.area[p] / area * std::pow(light->illuminance[p] - mean, 2);
  }
  return std::sqrt(squares);
}

TEST(Transport, ALampSlidingAwayFromAWallLowersItsSigmaWithoutSteps) {
  // Clusters are 1 m, patches 0.25 m wide: neither may show.
  double before = 1e30;
  for (double distance = 0.25; distance < 1.6; distance += 0.15) {
    const double sigma = wallSigma(distance, 0.25);
    EXPECT_LT(sigma, before) << distance;
    before = sigma;
  }
  for (const double distance : {0.3, 0.5, 0.8, 1.2}) {
    // note: sigma depends on the patch size itself; a patch half as wide is as near to the truth as a test
    // can afford.
    EXPECT_NEAR(wallSigma(distance, 0.25) / wallSigma(distance, 0.125), 1, 0.06) << distance;
  }
}

}  // namespace
}  // namespace fiatlux
