// True least and largest light over the patches of a surface set, for a layout and for its changes. The only
// part of an evaluation that costs O(patches), so it keeps witnesses: the patches that were extreme lately
// bound the truth from the optimistic side in a few loads, and most trials end there.
#pragma once

#include <cstdint>
#include <vector>

#include "core/scene/scene.h"
#include "core/search/kernels.h"
#include "core/search/statistics.h"

namespace fiatlux {

class PatchExtremes {
 public:
  PatchExtremes(const Scene& scene, Quantity quantity, const SurfaceSet& surfaces);

  /// Sets the layout that `changed` starts from; O(patches x count).
  void load(const std::uint32_t* sites, const double* flux, std::uint32_t count);

  /// Extremes of the loaded layout at full flux (t = 1), O(patches).
  Extremes current() { return changed(nullptr, 0); }

  /// Extremes after a change of the loaded layout, O(patches x count). Remembers the extreme patches.
  Extremes changed(const FluxChange* changes, std::uint32_t count);

  /// What the extremes after a change could be at best, from the witnesses only: `minimumLow` is at least,
  /// and `maximumHigh` at most, what `changed` would say; the other two are the opposite bounds, 0 and
  /// infinity.
  Extremes hoped(const FluxChange* changes, std::uint32_t count) const;

 private:
  struct Row {
    std::uint32_t index, surface;  // into the responses' rows, into `leaves_`
    float scale;                   // 1 for illuminance, the reflectance for exitance
  };
  struct Leaf {
    std::uint32_t surface;
    double errorBound;  // share of the leaf's mean illuminance
  };

  double lightAfter(std::size_t k, const FluxChange* changes, std::uint32_t count) const;
  double leafMean(std::uint32_t leaf, const FluxChange* changes, std::uint32_t count) const;
  void remember(std::vector<std::uint32_t>& witnesses, std::uint32_t k);

  const Responses& responses_;
  const std::vector<SurfaceStatistics>& means_;  // of the leaves, of what the responses are
  std::vector<Row> rows_;
  std::vector<Leaf> leaves_;
  std::vector<float> light_;      // illuminance of each of rows_ under the loaded layout, lx at t = 1
  std::vector<double> leafMean_;  // of each leaf under the loaded layout, lx
  std::vector<double> margin_;    // scratch: errorBound x mean of each leaf after the change
  std::vector<std::uint32_t> dark_, bright_;  // witnesses, latest first
};

/// Extremes of a surface set under a layout, dimmed, in the unit of `quantity`. O(patches x luminaires).
Extremes extremesUnder(const Scene& scene, Quantity quantity, const SurfaceSet& surfaces,
                       const Layout& layout);

}  // namespace fiatlux
