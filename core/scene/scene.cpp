// Unions of surfaces, and the explicit light of a layout against which every fast path is tested.
#include "core/scene/scene.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>

#include "core/scene/layout_sums.h"
#include "core/scene/stored_statistics.h"
#include "core/scene/surface_names.h"
#include "core/scene/zones.h"

namespace fiatlux {

std::vector<std::uint32_t> rowsOf(const Scene& scene, const SurfaceSet& surfaces) {
  const std::uint32_t zones = firstZone(scene);
  std::vector<char> wanted(scene.surfaces.size(), 0);
  const SurfaceSet leaves = leavesOf(scene, surfaces);
  for (const std::uint32_t s : leaves) wanted[s] = 1;
  std::vector<std::uint32_t> rows;
  for (std::uint32_t p = 0; p < scene.patches.rows(); ++p)
    if (wanted[scene.patches.surface[p]] && scene.patches.counts(p)) rows.push_back(p);
  const std::size_t ofLeaves = rows.size();
  for (const std::uint32_t s : leaves)
    if (s >= zones)
      rows.insert(rows.end(), scene.zones[s - zones].rows.begin(), scene.zones[s - zones].rows.end());
  if (rows.size() > ofLeaves) std::sort(rows.begin(), rows.end());
  return rows;
}

const Responses& responsesOf(const Scene& scene, Quantity quantity) {
  assert(quantity != Quantity::kDirect || scene.direct);
  return quantity == Quantity::kDirect ? scene.direct->responses : scene.responses;
}

const std::vector<SurfaceStatistics>& leafStatistics(const Scene& scene, Quantity quantity) {
  assert(quantity != Quantity::kDirect || scene.direct);
  if (quantity == Quantity::kDirect) return scene.direct->statistics;
  return quantity == Quantity::kExitance ? scene.exitance : scene.illuminance;
}

std::vector<SurfaceStatistics> meanRows(const Patches& patches, std::size_t surfaces,
                                        const Responses& responses, Quantity quantity) {
  const bool exitance = quantity == Quantity::kExitance;
  std::vector<SurfaceStatistics> leaves(surfaces, {std::vector<double>(responses.sites), {}});
  std::vector<double> area(surfaces);
  for (std::uint32_t p = 0; p < patches.rows(); ++p)
    if (patches.counts(p)) area[patches.surface[p]] += patches.area[p];
  struct Row {
    std::uint32_t row, surface;
    double weight;
  };
  std::vector<Row> rows;
  for (std::uint32_t p = 0; p < patches.rows(); ++p) {
    if (!patches.counts(p)) continue;
    const double factor = exitance ? patches.reflectance[p] : 1.0;
    rows.push_back({p, patches.surface[p], factor * patches.area[p] / area[patches.surface[p]]});
  }
  for (std::uint32_t j = 0; j < responses.sites; ++j) {
    const float* column = responses.column(j);
    for (const Row& row : rows) leaves[row.surface].mean[j] += row.weight * column[row.row];
  }
  return leaves;
}

SurfaceStatistics unionStatistics(const Scene& scene, Quantity quantity, const SurfaceSet& surfaces) {
  const std::vector<SurfaceStatistics>& leaves = leafStatistics(scene, quantity);
  const SurfaceSet members = leavesOf(scene, surfaces);
  const std::size_t m = scene.sites.size();
  if (!members.empty() && leaves[members[0]].covariance.empty())
    return storedStatistics(scene.patches, responsesOf(scene, quantity), quantity, rowsOf(scene, members));
  SurfaceStatistics result{std::vector<double>(m), std::vector<double>(m * m)};
  double total = 0;
  for (std::uint32_t s : members) total += scene.surfaces[s].area;
  for (std::uint32_t s : members) {
    const double weight = scene.surfaces[s].area / total;
    const SurfaceStatistics& leaf = leaves[s];
    for (std::size_t i = 0; i < m; ++i) {
      result.mean[i] += weight * leaf.mean[i];
      double* row = result.covariance.data() + i * m;
      for (std::size_t j = 0; j < m; ++j)
        row[j] += weight * (leaf.covariance[i * m + j] + leaf.mean[i] * leaf.mean[j]);
    }
  }
  for (std::size_t i = 0; i < m; ++i)
    for (std::size_t j = 0; j < m; ++j) result.covariance[i * m + j] -= result.mean[i] * result.mean[j];
  return result;
}

MeanAndSigma meanAndSigmaOf(const SurfaceStatistics& statistics, const Layout& layout) {
  const auto m = static_cast<std::uint32_t>(statistics.mean.size());
  const auto count = static_cast<std::uint32_t>(layout.sites.size());
  const std::uint32_t* sites = layout.sites.data();
  const double* flux = layout.flux.data();
  const double variance = varianceOf(statistics.covariance.data(), m, sites, flux, count);
  return {layout.dimming * meanOf(statistics.mean.data(), sites, flux, count),
          layout.dimming * std::sqrt(std::max(0.0, variance))};
}

std::vector<float> illuminanceOf(const Scene& scene, const Layout& layout, Quantity quantity) {
  const Responses& responses = responsesOf(scene, quantity);
  std::vector<float> light(responses.rows, 0.0f);
  for (std::size_t i = 0; i < layout.sites.size(); ++i) {
    const float* column = responses.column(layout.sites[i]);
    const auto flux = static_cast<float>(layout.dimming * layout.flux[i]);
    for (std::size_t p = 0; p < light.size(); ++p) light[p] += flux * column[p];
  }
  return light;
}

ExplicitStatistics explicitStatistics(const Scene& scene, const std::vector<float>& values,
                                      const SurfaceSet& surfaces) {
  const std::vector<std::uint32_t> rows = rowsOf(scene, surfaces);
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  ExplicitStatistics result{0, 0, kInfinity, -kInfinity};
  double area = 0, sum = 0, squares = 0;
  for (const std::uint32_t p : rows) {
    const double weight = scene.patches.area[p];
    area += weight;
    sum += weight * values[p];
    result.minimum = std::min<double>(result.minimum, values[p]);
    result.maximum = std::max<double>(result.maximum, values[p]);
  }
  result.mean = sum / area;
  for (const std::uint32_t p : rows) {
    const double deviation = values[p] - result.mean;
    squares += scene.patches.area[p] * deviation * deviation;
  }
  result.sigma = std::sqrt(squares / area);
  return result;
}

}  // namespace fiatlux
