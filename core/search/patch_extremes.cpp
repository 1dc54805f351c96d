// True extremes with witnesses and error margins; see patch_extremes.h.
#include "core/search/patch_extremes.h"

#include <algorithm>

namespace fiatlux {
namespace {
constexpr std::size_t kWitnesses = 16;
constexpr std::size_t kMostNumbers = 1u << 20;  // in the rows of witnesses that are kept
}  // namespace

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
  light_.assign(rows_.size(), 0.0);
  leafMean_.assign(leaves_.size(), 0.0);
  margin_.assign(leaves_.size(), 0.0);
}

void PatchExtremes::add(std::uint32_t site, double lumens) {
  const float* column = responses_.column(site);
  for (std::size_t k = 0; k < rows_.size(); ++k) light_[k] += lumens * column[rows_[k].index];
}

void PatchExtremes::load(const std::uint32_t* sites, const double* flux, std::uint32_t count) {
  std::fill(light_.begin(), light_.end(), 0.0);
  for (std::uint32_t i = 0; i < count; ++i) add(sites[i], flux[i]);
  for (std::size_t l = 0; l < leaves_.size(); ++l)
    leafMean_[l] = meanOf(means_[leaves_[l].surface].mean.data(), sites, flux, count);
}

void PatchExtremes::apply(const FluxChange* changes, std::uint32_t count) {
  for (std::uint32_t c = 0; c < count; ++c) add(changes[c].site, changes[c].flux);
  for (std::uint32_t l = 0; l < leaves_.size(); ++l) leafMean_[l] = leafMean(l, changes, count);
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

/// What a witness says of the loaded layout.
double PatchExtremes::standingAt(const Witnesses& witnesses, std::uint32_t k) const {
  const auto& [index, surface, scale] = rows_[k];
  return scale * (light_[k] + witnesses.sign * leaves_[surface].errorBound * leafMean_[surface]);
}

Extremes PatchExtremes::hoped(const FluxChange* changes, std::uint32_t count) const {
  const auto after = [&](const Witnesses& witnesses, std::uint32_t k) {
    double value = standingAt(witnesses, k);
    for (std::uint32_t c = 0; c < count; ++c) value += changes[c].flux * witnesses.lit[k][changes[c].site];
    return value;
  };
  Extremes result{kUnbounded, 0, kUnbounded, -kUnbounded};
  for (std::uint32_t k : dark_.patches) result.minimumLow = std::min(result.minimumLow, after(dark_, k));
  for (std::uint32_t k : bright_.patches)
    result.maximumHigh = std::max(result.maximumHigh, after(bright_, k));
  return result;
}

void PatchExtremes::hopedOfMoves(std::uint32_t from, double flux, const std::uint32_t* sites,
                                 std::uint32_t count, double* least, double* most) const {
  std::fill_n(least, count, kUnbounded);
  std::fill_n(most, count, -kUnbounded);
  const auto each = [&](const Witnesses& witnesses, auto&& take) {
    for (const std::uint32_t k : witnesses.patches) {
      const double* lit = witnesses.lit[k].data();
      const double rest = standingAt(witnesses, k) - flux * lit[from];
      for (std::uint32_t i = 0; i < count; ++i) take(i, rest + flux * lit[sites[i]]);
    }
  };
  each(dark_, [&](std::uint32_t i, double value) { least[i] = value < least[i] ? value : least[i]; });
  each(bright_, [&](std::uint32_t i, double value) { most[i] = value > most[i] ? value : most[i]; });
}

void PatchExtremes::remember(Witnesses& witnesses, std::uint32_t k) {
  std::vector<std::uint32_t>& patches = witnesses.patches;
  const auto known = std::find(patches.begin(), patches.end(), k);
  if (known != patches.end()) {
    std::rotate(patches.begin(), known, known + 1);
    return;
  }
  if (patches.size() == kWitnesses) patches.pop_back();
  patches.insert(patches.begin(), k);
  makeRow(witnesses, k);
}

/// Rows stay for when a patch is extreme again, as long as they are not too many.
void PatchExtremes::makeRow(Witnesses& witnesses, std::uint32_t k) {
  witnesses.lit.resize(rows_.size());
  if (!witnesses.lit[k].empty()) return;
  if (++witnesses.made * responses_.sites > kMostNumbers) {
    for (std::uint32_t other = 0; other < witnesses.lit.size(); ++other)
      if (std::count(witnesses.patches.begin(), witnesses.patches.end(), other) == 0)
        std::vector<double>().swap(witnesses.lit[other]);
    witnesses.made = witnesses.patches.size();
  }
  const auto& [index, surface, scale] = rows_[k];
  const double margin = witnesses.sign * leaves_[surface].errorBound;
  const std::vector<double>& mean = means_[leaves_[surface].surface].mean;
  std::vector<double>& row = witnesses.lit[k];
  row.resize(responses_.sites);
  for (std::uint32_t j = 0; j < responses_.sites; ++j)
    row[j] = scale * (responses_.column(j)[index] + margin * mean[j]);
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
