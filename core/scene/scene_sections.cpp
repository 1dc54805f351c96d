// A scene's numbers as sections: the exact inverse of scene_reader.cpp.
#include "core/scene/scene_sections.h"

#include <algorithm>
#include <cmath>
#include <cstring>

#include "core/scene/covariance_codec.h"
#include "core/scene/operator_sections.h"
#include "core/scene/response_codec.h"
#include "core/scene/section_codec.h"
#include "core/scene/statistics_codec.h"
#include "core/scene/stored_statistics.h"

namespace fiatlux {
namespace {

template <class T>
std::vector<std::uint8_t> bytesOf(const std::vector<T>& values) {
  std::vector<std::uint8_t> bytes(values.size() * sizeof(T));
  if (!bytes.empty()) std::memcpy(bytes.data(), values.data(), bytes.size());
  return bytes;
}

PlainSection doubles(const char* name, const std::vector<double>& values, std::uint32_t columns) {
  return plainSection(name, ElementType::kFloat64, Encoding::kPlain,
                      static_cast<std::uint32_t>(values.size() / columns), columns, bytesOf(values));
}

PlainSection floats(const char* name, const std::vector<float>& values, std::uint32_t columns) {
  return plainSection(name, ElementType::kFloat32, Encoding::kFloatPlanes,
                      static_cast<std::uint32_t>(values.size() / columns), columns,
                      encodeFloatPlanes(values));
}

PlainSection integers(const char* name, const std::vector<std::uint32_t>& values, std::uint32_t columns) {
  return plainSection(name, ElementType::kUint32, Encoding::kDeltaPlanes,
                      static_cast<std::uint32_t>(values.size() / columns), columns,
                      encodeDeltaPlanes(values, columns));
}

std::vector<std::uint32_t> quantised(const std::vector<Vec3>& vectors, double unit) {
  std::vector<std::uint32_t> values;
  for (const Vec3& v : vectors)
    for (double x : {v.x, v.y, v.z}) values.push_back(static_cast<std::uint32_t>(std::lround(x / unit)));
  return values;
}

/// "" or why this scene cannot be written.
std::string faultOf(const Scene& scene) {
  const SceneCounts counts = countsOf(scene);
  const auto finite = [](double v) { return std::isfinite(v); };
  if (scene.sites.empty()) return "the room has no site for a luminaire";
  if (counts.rows() == 0 || scene.surfaces.empty()) return "the room has no surfaces";
  if (std::uint64_t{counts.rows()} * counts.sites > kMaxResponseValues)
    return std::to_string(counts.rows()) + " patches x " + std::to_string(counts.sites) +
           " sites are too many for a scene file: use larger patches or a wider site spacing";
  if (std::uint64_t{counts.surfaces} * counts.sites * counts.sites > kMaxCovarianceValues)
    return std::to_string(counts.surfaces) + " surfaces with " + std::to_string(counts.sites) +
           " sites are too many for a scene file: use a wider site spacing";
  for (const Vec3& c : scene.patches.center)
    if (!(std::max({std::abs(c.x), std::abs(c.y), std::abs(c.z)}) < 32000))
      return "the room reaches beyond 32 km";
  for (float v : scene.responses.illuminance)
    if (!finite(v) || v < 0) return "a response is negative or no number";
  for (const auto* set : {&scene.illuminance, &scene.exitance})
    for (const SurfaceStatistics& statistics : *set)
      if (!std::all_of(statistics.mean.begin(), statistics.mean.end(), finite) ||
          !std::all_of(statistics.covariance.begin(), statistics.covariance.end(), finite))
        return "a mean or covariance is no number";
  return "";
}

void addSurfaces(const Scene& scene, const std::vector<float>& errorBound, std::vector<PlainSection>& out) {
  std::vector<std::uint8_t> names;
  std::vector<double> numbers;
  for (std::size_t s = 0; s < scene.surfaces.size(); ++s) {
    const Surface& surface = scene.surfaces[s];
    names.insert(names.end(), surface.name.begin(), surface.name.end());
    names.push_back(0);
    numbers.insert(numbers.end(), {surface.area, surface.reflectance, surface.lost,
                                   static_cast<double>(surface.measuring), errorBound[s]});
  }
  const auto length = static_cast<std::uint32_t>(names.size());
  out.push_back(
      plainSection("surfaceNames", ElementType::kUint8, Encoding::kPlain, length, 1, std::move(names)));
  out.push_back(doubles("surfaces", numbers, kSurfaceColumns));
  std::vector<double> borders;
  for (const Surface& surface : scene.surfaces) borders.push_back(surface.border);
  if (std::any_of(borders.begin(), borders.end(), [](double border) { return border > 0; }))
    out.push_back(doubles("planeBorders", borders, 1));
}

void addPatches(const Patches& patches, std::vector<PlainSection>& out) {
  std::vector<std::uint32_t> neighbours;
  for (std::uint32_t p = 0; p < patches.rows(); ++p)
    for (std::uint32_t q : {patches.left[p], patches.up[p]}) neighbours.push_back(q == kNone ? 0 : p - q);
  out.push_back(integers("patchCenters", quantised(patches.center, kPositionUnit), 3));
  out.push_back(integers("patchNormals", quantised(patches.normal, kDirectionUnit), 3));
  out.push_back(floats("patchAreas", {patches.area.begin(), patches.area.end()}, 1));
  out.push_back(floats("patchReflectances", patches.reflectance, 1));
  out.push_back(integers("patchSurfaces", patches.surface, 1));
  out.push_back(integers("patchClusters", patches.cluster, 1));
  out.push_back(integers("patchNeighbours", neighbours, 2));
  if (!patches.covered.empty())
    out.push_back(integers("patchCovered", {patches.covered.begin(), patches.covered.end()}, 1));
}

void addSites(const std::vector<Site>& sites, std::vector<PlainSection>& out) {
  std::vector<double> numbers;
  for (const Site& site : sites) {
    for (const Vec3& v : {site.position, site.normal, site.axis})
      numbers.insert(numbers.end(), {v.x, v.y, v.z});
    numbers.push_back(site.size);
  }
  out.push_back(doubles("sites", numbers, kSiteColumns));
}

void addResponses(const Scene& scene, EncodedResponses& encoded,
                  const std::vector<ResponseReferences>& references, std::vector<PlainSection>& out) {
  const auto m = static_cast<std::uint32_t>(scene.sites.size());
  std::vector<float> scales;
  for (const ResponseScale& scale : encoded.scales) scales.insert(scales.end(), {scale.step, scale.floor});
  out.push_back(floats("responseScales", scales, 2 * static_cast<std::uint32_t>(scene.surfaces.size())));
  std::vector<std::uint32_t> before;
  for (std::uint32_t j = 0; j < m; ++j)
    for (const std::uint32_t i : references[j]) before.push_back(i == kNone ? 0 : j - i);
  out.push_back(integers("responseReferences", before, 2));
  const float bound = *std::max_element(encoded.errorBound.begin(), encoded.errorBound.end());
  for (std::uint32_t block = 0; block < encoded.blocks.size(); ++block) {
    const auto length = static_cast<std::uint32_t>(encoded.blocks[block].size());
    out.push_back(plainSection(numberedName("responses", block), ElementType::kUint8, Encoding::kPredicted,
                               length, 1, std::move(encoded.blocks[block]), bound));
  }
  // Each site has its own column here.
  std::vector<std::uint32_t> offsets(m + 1), columns(m);
  for (std::uint32_t j = 0; j <= m; ++j) offsets[j] = j;
  for (std::uint32_t j = 0; j < m; ++j) columns[j] = j;
  out.push_back(integers("responseOffsets", offsets, 1));
  out.push_back(integers("responseColumns", columns, 1));
  out.push_back(doubles("responseWeights", std::vector<double>(m, 1.0), 1));
}

/// Per surface: whether all its patches have one reflectance, so that exitance follows from illuminance.
std::vector<bool> uniformSurfaces(const Scene& scene) {
  std::vector<bool> uniform(scene.surfaces.size(), true);
  for (std::uint32_t p = 0; p < scene.patches.rows(); ++p) {
    const Surface& surface = scene.surfaces[scene.patches.surface[p]];
    if (std::abs(scene.patches.reflectance[p] - surface.reflectance) > 1e-6 * surface.reflectance)
      uniform[scene.patches.surface[p]] = false;
  }
  return uniform;
}

/// Steps of the responses, one a surface. On a surface of few patches finer steps are cheaper than what they
/// save: covariances that follow from its responses to the last unit need no correction.
std::vector<double> responseSteps(const Scene& scene) {
  const std::size_t m = scene.sites.size(), surfaces = scene.surfaces.size();
  std::vector<double> steps(surfaces, kResponseStep);
  if (!derivable(countsOf(scene))) return steps;
  std::vector<std::size_t> rows(surfaces);
  for (const std::uint32_t s : scene.patches.surface) ++rows[s];
  for (std::size_t s = 0; s < surfaces; ++s) {
    if (2 * rows[s] >= m) continue;  // a bit more for each value, a bit less for each correlation
    const SurfaceStatistics& statistics = scene.illuminance[s];
    std::vector<double> evenness;  // mean over standard deviation, of each site
    for (std::size_t j = 0; j < m; ++j)
      if (const double variance = statistics.covariance[j * m + j]; variance > 0)
        evenness.push_back(statistics.mean[j] / std::sqrt(variance));
    if (evenness.empty()) continue;
    std::nth_element(evenness.begin(), evenness.begin() + evenness.size() / 2, evenness.end());
    // What rounding does to a correlation: both columns err by step x mean / sqrt(12), at random, patch by
    // patch.
    const double noise =
        kResponseStep * evenness[evenness.size() / 2] / std::sqrt(6.0 * static_cast<double>(rows[s]));
    constexpr double kMostHalvings = 10;
    steps[s] /= std::exp2(std::clamp(std::ceil(std::log2(noise / kCorrelationUnit)), 0.0, kMostHalvings));
  }
  return steps;
}

void addCorrections(const Scene& scene, const Responses& stored, std::vector<PlainSection>& out) {
  const std::vector<bool> uniform = uniformSurfaces(scene);
  const auto rows = rowsOfSurfaces(scene.patches, static_cast<std::uint32_t>(scene.surfaces.size()));
  const auto add = [&](const char* name, std::uint32_t s, SurfaceStatistics& statistics,
                       const SurfaceStatistics& expected) {
    std::vector<std::uint8_t> bytes = encodeStatistics(statistics, expected);
    const auto length = static_cast<std::uint32_t>(bytes.size());
    out.push_back(plainSection(numberedName(name, s), ElementType::kUint8, Encoding::kCorrections, length, 1,
                               std::move(bytes), statisticsErrorBound()));
  };
  for (std::uint32_t s = 0; s < scene.surfaces.size(); ++s) {
    const SurfaceStatistics lit = storedStatistics(scene.patches, stored, Quantity::kIlluminance, rows[s]);
    SurfaceStatistics illuminance = scene.illuminance[s];
    add("illuminanceStatistics", s, illuminance, lit);
    if (scene.surfaces[s].measuring || uniform[s]) continue;
    SurfaceStatistics exitance = scene.exitance[s];
    add("exitanceStatistics", s, exitance,
        expectedStatistics(storedStatistics(scene.patches, stored, Quantity::kExitance, rows[s]), lit,
                           illuminance, scene.surfaces[s].reflectance));
  }
}

void addStatistics(const Scene& scene, std::vector<PlainSection>& out, EncodingReport* report) {
  const auto m = static_cast<std::uint32_t>(scene.sites.size());
  const std::vector<bool> uniform = uniformSurfaces(scene);
  std::vector<double> lit, reflected;
  for (std::uint32_t s = 0; s < scene.surfaces.size(); ++s) {
    const SurfaceStatistics& illuminance = scene.illuminance[s];
    lit.insert(lit.end(), illuminance.mean.begin(), illuminance.mean.end());
    out.push_back(encodeCovariance(numberedName("illuminanceCovariance", s), illuminance.covariance, m,
                                   kCovarianceTolerance));
    if (report)
      report->ranks.push_back(out.back().section.encoding == Encoding::kFactored ? out.back().section.rows
                                                                                 : 0);
    if (scene.surfaces[s].measuring || uniform[s]) {
      reflected.insert(reflected.end(), m, 0.0);
      continue;
    }
    const SurfaceStatistics& exitance = scene.exitance[s];
    reflected.insert(reflected.end(), exitance.mean.begin(), exitance.mean.end());
    out.push_back(encodeCovariance(numberedName("exitanceCovariance", s), exitance.covariance, m,
                                   kCovarianceTolerance));
  }
  out.push_back(doubles("illuminanceMeans", lit, m));
  out.push_back(doubles("exitanceMeans", reflected, m));
}

}  // namespace

std::string numberedName(std::string_view name, std::uint32_t number) {
  return number == 0 ? std::string(name) : std::string(name) + "." + std::to_string(number);
}

SceneCounts countsOf(const Scene& scene) {
  const auto m = static_cast<std::uint32_t>(scene.sites.size());
  return {scene.patches.count,
          scene.patches.rows() - scene.patches.count,
          scene.patches.clusterCount,
          m,
          m,
          static_cast<std::uint32_t>(scene.surfaces.size())};
}

bool derivable(const SceneCounts& counts) {
  return std::uint64_t{counts.rows()} * counts.sites * counts.sites <= kMaxDerivedProducts;
}

Result<std::vector<PlainSection>> encodeScene(const Scene& scene, EncodingReport* report) {
  const std::string fault = faultOf(scene);
  if (!fault.empty()) return Error{fault};
  std::vector<PlainSection> sections;
  const std::vector<ResponseReferences> references = nearestBefore(scene.sites);
  EncodedResponses encoded =
      encodeResponses(scene.responses, scene.patches, responseSteps(scene), references);
  addSurfaces(scene, encoded.errorBound, sections);
  addPatches(scene.patches, sections);
  addSites(scene.sites, sections);
  addResponses(scene, encoded, references, sections);
  if (derivable(countsOf(scene)))
    addCorrections(scene, encoded.stored, sections);
  else
    addStatistics(scene, sections, report);
  if (scene.lightOperator) {
    if (const Result<Done> encoded = encodeOperator(scene, sections); !encoded) return encoded.error();
  }
  if (report) report->responseRms = std::move(encoded.rms);
  return sections;
}

void putOperatorFirst(std::vector<PlainSection>& sections) {
  const auto isOfOperator = [](const PlainSection& part) { return isOperatorSection(part.section.name); };
  const auto isSites = [](const PlainSection& part) { return part.section.name == "sites"; };
  const auto behindSites = std::find_if(sections.begin(), sections.end(), isSites) + 1;
  std::stable_partition(behindSites, sections.end(), isOfOperator);
}

}  // namespace fiatlux
