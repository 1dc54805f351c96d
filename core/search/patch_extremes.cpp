// True extremes with witnesses and error margins; see patch_extremes.h.
#include "core/search/patch_extremes.h"

#include <algorithm>

namespace fiatlux {
namespace {
constexpr std::size_t kWitnesses = 12;
}

PatchExtremes::PatchExtremes(const Scene& scene, Quantity quantity, const SurfaceSet& surfaces)
    : responses_(responsesOf(scene, quantity)),
      means_(leafStatistics(scene, quantity == Quantity::kDirect ? quantity : Quantity::kIlluminance)) {
  const bool isStored = quantity != Quantity::kDirect;  // note: direct light is made, not stored in steps
  std::vector<std::uint32_t> leafOf(scene.surfaces.size(), kNone);
  for (const std::uint32_t p : rowsOf(scene, surfaces)) {
    // Errors are known of leaves of the file: a zone's rows have those of the leaf that they are of.
    const std::uint32_t s = scene.patches.surface[p];
    if (leafOf[s] == kNone) {
      leafOf[s] = static_cast<std::uint32_t>(leaves_.size());
      leaves_.push_back({s, isStored && s < scene.errorBound.size() ? scene.errorBound[s] : 0.0});
    }
    rows_.push_back({p, leafOf[s], quantity == Quantity::kExitance ? scene.patches.reflectance[p] : 1.0f});
  }
  light_.assign(rows_.size(), 0.0f);
  leafMean_.assign(leaves_.size(), 0.0);
  margin_.assign(leaves_.size(), 0.0);
}

void PatchExtremes::load(const std::uint32_t* sites, const double* flux, std::uint32_t count) {
  std::fill(light_.begin(), light_.end(), 0.0f);
  for (std::uint32_t i = 0; i < count; ++i) {
    const float* column = responses_.column(sites[i]);
    const auto lumens = static_cast<float>(flux[i]);
    for (std::size_t k = 0; k < rows_.size(); ++k) light_[k] += lumens * column[rows_[k].index];
  }
  for (std::size_t l = 0; l < leaves_.size(); ++l)
    leafMean_[l] = meanOf(means_[leaves_[l].surface].mean.data(), sites, flux, count);
}

double PatchExtremes::leafMean(std::uint32_t leaf, const FluxChange* changes, std::uint32_t count) const {
  double mean = leafMean_[leaf];
  const std::vector<double>& row = means_[leaves_[leaf].surface].mean;
  for (std::uint32_t c = 0; c < count; ++c) mean += changes[c].flux * row[changes[c].site];
  return mean;
}

double PatchExtremes::lightAfter(std::size_t k, const FluxChange* changes, std::uint32_t count) const {
  double light = light_[k];
  for (std::uint32_t c = 0; c < count; ++c)
    light += changes[c].flux * responses_.column(changes[c].site)[rows_[k].index];
  return light;
}

Extremes PatchExtremes::changed(const FluxChange* changes, std::uint32_t count) {
  for (std::uint32_t l = 0; l < leaves_.size(); ++l)
    margin_[l] = leaves_[l].errorBound * leafMean(l, changes, count);
  Extremes result{kUnbounded, kUnbounded, -kUnbounded, -kUnbounded};
  std::uint32_t darkest = 0, brightest = 0;
  for (std::uint32_t k = 0; k < rows_.size(); ++k) {
    const double light = lightAfter(k, changes, count);
    const double margin = margin_[rows_[k].surface];
    const double low = rows_[k].scale * (light - margin), high = rows_[k].scale * (light + margin);
    if (low < result.minimumLow) {
      result.minimumLow = low;
      darkest = k;
    }
    if (high > result.maximumHigh) {
      result.maximumHigh = high;
      brightest = k;
    }
    result.minimumHigh = std::min(result.minimumHigh, high);
    result.maximumLow = std::max(result.maximumLow, low);
  }
  remember(dark_, darkest);
  remember(bright_, brightest);
  return result;
}

Extremes PatchExtremes::hoped(const FluxChange* changes, std::uint32_t count) const {
  Extremes result{kUnbounded, 0, kUnbounded, -kUnbounded};
  const auto bound = [&](std::uint32_t k, double sign) {
    const std::uint32_t leaf = rows_[k].surface;
    const double margin = leaves_[leaf].errorBound * leafMean(leaf, changes, count);
    return rows_[k].scale * (lightAfter(k, changes, count) + sign * margin);
  };
  for (std::uint32_t k : dark_) result.minimumLow = std::min(result.minimumLow, bound(k, -1));
  for (std::uint32_t k : bright_) result.maximumHigh = std::max(result.maximumHigh, bound(k, +1));
  return result;
}

void PatchExtremes::remember(std::vector<std::uint32_t>& witnesses, std::uint32_t k) {
  const auto known = std::find(witnesses.begin(), witnesses.end(), k);
  if (known != witnesses.end()) {
    std::rotate(witnesses.begin(), known, known + 1);
    return;
  }
  if (witnesses.size() == kWitnesses) witnesses.pop_back();
  witnesses.insert(witnesses.begin(), k);
}

Extremes extremesUnder(const Scene& scene, Quantity quantity, const SurfaceSet& surfaces,
                       const Layout& layout) {
  std::vector<double> flux = layout.flux;
  for (double& lumens : flux) lumens *= layout.dimming;
  PatchExtremes patches(scene, quantity, surfaces);
  patches.load(layout.sites.data(), flux.data(), static_cast<std::uint32_t>(flux.size()));
  return patches.current();
}

}  // namespace fiatlux
