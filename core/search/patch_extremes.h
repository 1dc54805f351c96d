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

  /// Makes a change of the loaded layout for good, O(patches x count): after many the sums have drifted by
  /// their rounding, and should be loaded anew.
  void apply(const FluxChange* changes, std::uint32_t count);

  /// Extremes of the loaded layout at full flux (t = 1), O(patches).
  Extremes current() { return changed(nullptr, 0); }

  /// Extremes after a change of the loaded layout, O(patches x count). Remembers the extreme patches.
  Extremes changed(const FluxChange* changes, std::uint32_t count);

  /// What the extremes after a change could be at best, from the witnesses only: `minimumLow` is at least,
  /// and `maximumHigh` at most, what `changed` would say; the other two are the opposite bounds, 0 and
  /// infinity.
  Extremes hoped(const FluxChange* changes, std::uint32_t count) const;

  /// The same of a change to each of `count` sites, by `flux` there and -flux at `from`: `least` and `most`
  /// of each.
  void hopedOfMoves(std::uint32_t from, double flux, const std::uint32_t* sites, std::uint32_t count,
                    double* least, double* most) const;

 private:
  struct Row {
    std::uint32_t index, surface;  // into the responses' rows, into `leaves_`
    float scale;                   // 1 for illuminance, the reflectance for exitance
  };
  struct Leaf {
    std::uint32_t surface;
    double errorBound;  // share of the leaf's mean illuminance
  };

  /// Patches that were extreme lately, on the side where margins count `sign`.
  struct Witnesses {
    double sign;
    std::vector<std::uint32_t> patches;    // into rows_, the latest first
    std::vector<std::vector<double>> lit;  // of each of rows_ what each site does there; empty until needed
    std::size_t made = 0;                  // so many of `lit` are not empty
  };

  void add(std::uint32_t site, double lumens);
  double standingAt(const Witnesses& witnesses, std::uint32_t k) const;
  double lightAfter(std::size_t k, const FluxChange* changes, std::uint32_t count) const;
  double leafMean(std::uint32_t leaf, const FluxChange* changes, std::uint32_t count) const;
  void remember(Witnesses& witnesses, std::uint32_t k);
  void makeRow(Witnesses& witnesses, std::uint32_t k);

  const Responses& responses_;
  const std::vector<SurfaceStatistics>& means_;  // of the leaves, of what the responses are
  std::vector<Row> rows_;
  std::vector<Leaf> leaves_;
  std::vector<double> light_;     // illuminance of each of rows_ under the loaded layout, lx at t = 1
  std::vector<double> leafMean_;  // of each leaf under the loaded layout, lx
  std::vector<double> margin_;    // scratch: errorBound x mean of each leaf after the change
  Witnesses dark_{-1, {}, {}}, bright_{1, {}, {}};
};

/// Extremes of a surface set under a layout, dimmed, in the unit of `quantity`. O(patches x luminaires).
Extremes extremesUnder(const Scene& scene, Quantity quantity, const SurfaceSet& surfaces,
                       const Layout& layout);

}  // namespace fiatlux
