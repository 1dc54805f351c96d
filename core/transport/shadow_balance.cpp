#include "core/transport/shadow_balance.h"

#include <algorithm>
#include <cmath>

namespace fiatlux {
namespace {

constexpr double kMostLost = 0.01;    // of rays from all surfaces: what loses more is open
constexpr double kMostAstray = 0.25;  // of the flux: shadows are not that wrong, there is another cause
constexpr double kUnsure = 0.003;     // of the flux: so much may be missing or doubled by rounding as well

}  // namespace

bool isClosed(const Scene& scene) {
  double area = 0, lost = 0;
  for (const Surface& surface : scene.surfaces)
    if (!surface.measuring) area += surface.area, lost += surface.area * surface.lost;
  return lost <= kMostLost * area;
}

double mostBalance(const Site& site, const Luminaire& luminaire) {
  return std::max(0.0, 1 - std::max(luminaire.width, luminaire.height) / site.size);
}

void balanceShadows(const Scene& scene, const Site& site, const Luminaire& luminaire, double flux,
                    const std::uint8_t* visible, float* column) {
  const Patches& patches = scene.patches;
  const double mount = dot(luminaire.position, site.normal);
  const auto isBefore = [&](std::uint32_t p) { return dot(patches.center[p], site.normal) > mount; };
  // lm that arrive, and what of them b = 1 would add.
  double arrived = 0, movable = 0;
  for (std::uint32_t p = 0; p < patches.count; ++p) {
    if (column[p] == 0 || !isBefore(p)) continue;
    const double lumens = patches.area[p] * column[p];
    arrived += lumens;
    movable += lumens * (1 - SiteVisibility::shareOf(visible[p]));
  }
  const double missing = flux - arrived, sure = std::abs(missing) - kUnsure * flux;
  if (!(movable > 0 && sure > 0) || std::abs(missing) > kMostAstray * flux) return;
  const double balance = std::copysign(std::min(sure / movable, mostBalance(site, luminaire)), missing);
  for (std::uint32_t p = 0; p < patches.rows(); ++p)
    if (visible[p] != SiteVisibility::kSteps && column[p] != 0 && isBefore(p))
      column[p] *= static_cast<float>(1 + balance * (1 - SiteVisibility::shareOf(visible[p])));
}

}  // namespace fiatlux
