// core/bound/evenness_limit: no layout of any number and any fluxes is more even than the limit, which is
// nearly reached by luminaires split over all sites, and lower where sites are left out.
#include "core/bound/evenness_limit.h"

#include <gtest/gtest.h>

#include "core/base/random.h"
#include "core/search/plane_values.h"
#include "tests/core/corridor_scene.h"

namespace fiatlux {
namespace {

using fiatlux::testing::smallRoom;

Constraint evenFloor() {
  Constraint even;
  even.statistic = Statistic::kUniformity;
  even.lower = 0.9;
  even.surfaces = {0};
  even.quantity = Quantity::kIlluminance;
  even.onGrid = true;
  return even;
}

double uniformityOf(PreparedScene& prepared, const Layout& layout) {
  return valueOf(evenFloor(), planeValueUnder(prepared, evenFloor(), layout));
}

TEST(EvennessLimit, IsAboveEveryLayoutAndNearlyReached) {
  PreparedScene prepared(smallRoom());
  const auto sites = static_cast<std::uint32_t>(prepared.scene().sites.size());
  const double limit = evennessLimit(prepared, evenFloor(), {});
  EXPECT_LT(limit, 1);
  Random random(7);
  Layout layout{{}, std::vector<double>(sites), 1};
  for (std::uint32_t j = 0; j < sites; ++j) layout.sites.push_back(j);
  layout.flux.assign(sites, 100.0);
  double best = uniformityOf(prepared, layout);
  for (int trial = 0; trial < 20000; ++trial) {
    Layout other = layout;
    double& flux = other.flux[random.below(sites)];
    flux = std::max(0.0, flux + 60 * (random.unit() - 0.5));
    const double reached = uniformityOf(prepared, other);
    EXPECT_LE(reached, limit * (1 + 1e-9));
    if (reached < best) continue;
    best = reached;
    layout = other;
  }
  EXPECT_GT(best, 0.9 * limit);
}

TEST(EvennessLimit, OfOnePlaceIsItsOwn) {
  PreparedScene prepared(smallRoom());
  std::vector<std::uint32_t> others;
  for (std::uint32_t j = 1; j < prepared.scene().sites.size(); ++j) others.push_back(j);
  const double limit = evennessLimit(prepared, evenFloor(), others);
  EXPECT_NEAR(limit, uniformityOf(prepared, {{0}, {100}, 1}), 0.003 * limit);
  EXPECT_LT(limit, evennessLimit(prepared, evenFloor(), {}));
  others.push_back(0);
  EXPECT_EQ(evennessLimit(prepared, evenFloor(), others), 0);
}

}  // namespace
}  // namespace fiatlux
