#include "precompute/geometry/patch_size.h"

#include <algorithm>
#include <cmath>

namespace fiatlux {
namespace {

constexpr double kUsualPatches = 25000, kManyPatches = 100000;  // of a room, of a huge one
// m. By their number alone patches of a room of 6 x 4 m would be 0.07 m long: five times the work, for means
// that differ by 0.1 % and sigmas by 1.
constexpr double kFinestPatch = 0.1, kCoarsestPatch = 0.5;
constexpr double kFewMore = 1.15;  // times as many are fine
constexpr double kSnaps = 0.25;    // e to this: how much a patch may change to divide the sites' spacing
constexpr int kCoarsenings = 3;

Cut fittingCut(const SourceScene& source, const WeldedMesh& mesh, const SurfaceTree& tree) {
  double spacing = 0;
  for (const SourceMesh& from : source.meshes)
    if (from.extras.mount && from.extras.siteSpacing && spacing == 0) spacing = *from.extras.siteSpacing;
  const auto snapped = [&](double patch) {
    const double fraction = spacing > 0 ? spacing / std::max(1.0, std::round(spacing / patch)) : patch;
    return std::abs(std::log(fraction / patch)) < kSnaps ? fraction : patch;
  };
  const double area = areaOf(tree);
  double patch = std::clamp(std::sqrt(area / kUsualPatches), kFinestPatch,
                            std::max(kCoarsestPatch, std::sqrt(area / kManyPatches)));

  // Thin and small things get more patches than their area says: coarsen until the number fits.
  for (int i = 0;; ++i) {
    Cut cut{snapped(patch), makeCharts(mesh, tree, snapped(patch), 0)};
    const double count = foreseenPatches(cut.charts);
    if (i == kCoarsenings || count < kFewMore * kUsualPatches || cut.patch >= kCoarsestPatch) return cut;
    patch = std::min(patch * std::sqrt(count / kUsualPatches), kCoarsestPatch);
  }
}

}  // namespace

Cut cutOf(const SourceScene& source, const WeldedMesh& mesh, const SurfaceTree& tree,
          const RoomOptions& options) {
  if (options.patch > 0) return {options.patch, makeCharts(mesh, tree, options.patch, 0)};
  return fittingCut(source, mesh, tree);
}

}  // namespace fiatlux
