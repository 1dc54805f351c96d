// Every section against the counts, then every value against its range; only then does it become part of a
// Scene.
#include "core/scene/scene_reader.h"

#include <algorithm>
#include <cmath>
#include <set>
#include <span>

#include "core/scene/checked_sections.h"
#include "core/scene/covariance_codec.h"
#include "core/scene/crc32.h"
#include "core/scene/operator_sections.h"
#include "core/scene/response_codec.h"
#include "core/scene/response_sections.h"
#include "core/scene/scene_sections.h"
#include "core/scene/statistics_codec.h"
#include "core/scene/stored_statistics.h"

namespace fiatlux {
namespace {

constexpr double kHuge = 1e30;  // of anything physical in a file
// Of light in a file, lx for 1 lm: sums and squares of what is below stay finite, as floats too.
constexpr double kLargestWeight = 1e6;
constexpr double kBrightestPatch = kBrightestMean * (1 << 24);  // responses count up to 2^24 steps
constexpr std::size_t kLongestName = 1000;                      // bytes; the writer cuts names far below
constexpr double kWidestBorder = 1e6;                           // m

void readSurfaces(CheckedSections& in, const SceneCounts& counts, Scene& scene) {
  const std::vector<std::uint8_t> names =
      in.take("surfaceNames", ElementType::kUint8, Encoding::kPlain, CheckedSections::kAnyRows, 1);
  const std::vector<double> numbers = in.doubles("surfaces", counts.surfaces, kSurfaceColumns, 0, kHuge);
  if (!in.ok()) return;
  std::set<std::string> seen = {"all"};
  auto from = names.begin();
  for (std::uint32_t s = 0; s < counts.surfaces; ++s) {
    const auto to = std::find(from, names.end(), 0);
    if (to == names.end()) return in.fail("surfaceNames", "there are fewer names than surfaces");
    const double* row = &numbers[s * kSurfaceColumns];
    Surface surface;
    surface.name.assign(from, to);
    surface.area = row[0], surface.reflectance = row[1], surface.lost = row[2],
    surface.measuring = row[3] != 0;
    if (surface.name.size() > kLongestName) return in.fail("surfaceNames", "a name is too long");
    if (surface.name.empty() || !seen.insert(surface.name).second)
      return in.fail("surfaceNames", "a name is empty, reserved or there twice");
    if (!(row[0] > 0) || row[1] > 1 || row[2] > 1 || row[3] > 1)
      return in.fail("surfaces", "a value is out of range");
    scene.errorBound.push_back(static_cast<float>(row[4]));
    scene.surfaces.push_back(std::move(surface));
    from = to + 1;
  }
  if (from != names.end()) in.fail("surfaceNames", "there are more names than surfaces");
}

/// Absent in files whose measuring planes have none.
void readBorders(CheckedSections& in, const SceneCounts& counts, Scene& scene) {
  if (!in.has("planeBorders")) return;
  const std::vector<double> borders = in.doubles("planeBorders", counts.surfaces, 1, 0, kWidestBorder);
  for (std::uint32_t s = 0; in.ok() && s < counts.surfaces; ++s) {
    if (borders[s] > 0 && !scene.surfaces[s].measuring)
      return in.fail("planeBorders", "a surface that is no measuring plane has a border");
    scene.surfaces[s].border = borders[s];
  }
}

/// Absent in files where everything counts.
void readCovered(CheckedSections& in, const SceneCounts& counts, Scene& scene) {
  if (!in.has("patchCovered")) return;
  Patches& patches = scene.patches;
  const std::vector<std::uint32_t> covered = in.integers("patchCovered", patches.rows(), 1);
  if (!in.ok()) return;
  if (std::any_of(covered.begin(), covered.end(), [](std::uint32_t flag) { return flag > 1; }))
    return in.fail("patchCovered", "a patch is neither covered nor not");
  patches.covered.assign(covered.begin(), covered.end());
  for (const std::vector<std::uint32_t>& rows : rowsOfSurfaces(patches, counts.surfaces))
    if (rows.empty()) return in.fail("patchCovered", "a surface has no patch that counts");
}

void readPatchLabels(CheckedSections& in, const SceneCounts& counts, Scene& scene) {
  Patches& patches = scene.patches;
  const std::uint32_t rows = counts.rows();
  patches.surface = in.integers("patchSurfaces", rows, 1);
  patches.cluster = in.integers("patchClusters", counts.patches, 1);
  const std::vector<std::uint32_t> before = in.integers("patchNeighbours", rows, 2);
  if (!in.ok()) return;
  for (std::uint32_t p = 0; p < rows; ++p) {
    if (patches.surface[p] >= counts.surfaces)
      return in.fail("patchSurfaces", "a patch is on a surface that is not there");
    if (before[2 * p] > p || before[2 * p + 1] > p)
      return in.fail("patchNeighbours", "a neighbour is not there");
    Surface& surface = scene.surfaces[patches.surface[p]];
    if (surface.measuring != (p >= counts.patches))
      return in.fail("patchSurfaces", "patches and receivers are on the wrong surfaces");
    ++surface.patches;
  }
  for (std::uint32_t label : patches.cluster)
    if (label >= counts.clusters)
      return in.fail("patchClusters", "a patch is in a cluster that is not there");
  for (const Surface& surface : scene.surfaces)
    if (surface.patches == 0) return in.fail("patchSurfaces", "a surface has no patch");
  readCovered(in, counts, scene);
  patches.left.resize(rows), patches.up.resize(rows);
  for (std::uint32_t p = 0; p < rows; ++p) {
    patches.left[p] = before[2 * p] > 0 ? p - before[2 * p] : kNone;
    patches.up[p] = before[2 * p + 1] > 0 ? p - before[2 * p + 1] : kNone;
  }
}

void readPatches(CheckedSections& in, const SceneCounts& counts, Scene& scene) {
  Patches& patches = scene.patches;
  const std::uint32_t rows = counts.rows();
  patches.count = counts.patches;
  patches.clusterCount = counts.clusters;
  const std::vector<std::uint32_t> centers = in.integers("patchCenters", rows, 3);
  const std::vector<std::uint32_t> normals = in.integers("patchNormals", rows, 3);
  const std::vector<float> areas = in.floats("patchAreas", Encoding::kFloatPlanes, rows, 1, 0, kHuge);
  patches.reflectance = in.floats("patchReflectances", Encoding::kFloatPlanes, rows, 1, 0, 1);
  if (!in.ok()) return;
  const auto vectorAt = [](const std::vector<std::uint32_t>& v, std::uint32_t p, double unit) {
    const auto at = [&](int i) { return unit * static_cast<std::int32_t>(v[3 * p + i]); };
    return Vec3{at(0), at(1), at(2)};
  };
  patches.area.assign(areas.begin(), areas.end());
  for (std::uint32_t p = 0; p < rows; ++p) {
    if (!(areas[p] > 0)) return in.fail("patchAreas", "a patch has no area");
    patches.center.push_back(vectorAt(centers, p, kPositionUnit));
    patches.normal.push_back(normalized(vectorAt(normals, p, kDirectionUnit)));
  }
  readPatchLabels(in, counts, scene);
}

void readSites(CheckedSections& in, const SceneCounts& counts, Scene& scene) {
  const std::vector<double> numbers = in.doubles("sites", counts.sites, kSiteColumns, -kHuge, kHuge);
  if (!in.ok()) return;
  for (std::uint32_t j = 0; j < counts.sites; ++j) {
    const double* v = &numbers[j * kSiteColumns];
    const Site site{{v[0], v[1], v[2]}, {v[3], v[4], v[5]}, {v[6], v[7], v[8]}, v[9]};
    const bool unit = std::abs(length(site.normal) - 1) < 1e-3 && std::abs(length(site.axis) - 1) < 1e-3;
    if (!unit || !(site.size > 0)) return in.fail("sites", "a site has no size or direction");
    scene.sites.push_back(site);
  }
}

/// Site responses = columns x responseWeights.
void readResponses(CheckedSections& in, const SceneCounts& counts, ResponseSections& sections, Scene& scene) {
  const std::uint32_t rows = counts.rows();
  std::vector<float> columns = sections.columns(in, counts, scene.patches);
  const std::vector<std::uint32_t> offsets = in.integers("responseOffsets", counts.sites + 1ull, 1);
  if (!in.ok()) return;
  const std::uint32_t entries = offsets.back();
  const std::vector<std::uint32_t> column = in.integers("responseColumns", entries, 1);
  const std::vector<double> weight = in.doubles("responseWeights", entries, 1, 0, kLargestWeight);
  if (!in.ok()) return;
  if (std::uint64_t{rows} * entries > kMaxResponseProducts)
    return in.fail("responseWeights", "patches x weights is over 2^30");
  if (offsets[0] != 0 || !std::is_sorted(offsets.begin(), offsets.end()))
    return in.fail("responseOffsets", "the offsets do not ascend");
  bool identity = counts.columns == counts.sites && entries == counts.sites;
  for (std::uint32_t i = 0; i < entries; ++i) {
    if (column[i] >= counts.columns) return in.fail("responseColumns", "a column is not there");
    identity = identity && offsets[i] == i && column[i] == i && weight[i] == 1;
  }
  scene.responses.rows = rows;
  scene.responses.sites = counts.sites;
  if (identity) {
    scene.responses.illuminance = std::move(columns);
    return;
  }
  std::vector<float>& mixed = scene.responses.illuminance;
  mixed.assign(std::size_t{rows} * counts.sites, 0);
  for (std::uint32_t j = 0; j < counts.sites; ++j)
    for (std::uint32_t i = offsets[j]; i < offsets[j + 1]; ++i)
      for (std::uint32_t p = 0; p < rows; ++p)
        mixed[std::size_t{j} * rows + p] +=
            static_cast<float>(weight[i] * columns[std::size_t{column[i]} * rows + p]);
  if (std::any_of(mixed.begin(), mixed.end(), [](float light) { return !(light <= kBrightestPatch); }))
    in.fail("responseWeights", "light is out of range");
}

void readCovariance(CheckedSections& in, const std::string& name, std::uint32_t m,
                    std::vector<double>& covariance) {
  if (!in.has(name)) return in.fail(name, "it is missing");
  const std::vector<std::uint8_t> bytes = in.takeAny(name);
  if (!in.ok()) return;
  const std::string fault = decodeCovariance(in.line(name), bytes, m, covariance);
  if (!fault.empty()) in.fail(name, fault);
}

/// One reflectance on the whole surface: exitance is that times illuminance.
SurfaceStatistics reflected(SurfaceStatistics illuminance, double reflectance) {
  for (double& v : illuminance.mean) v *= reflectance;
  for (double& v : illuminance.covariance) v *= reflectance * reflectance;
  return illuminance;
}

void readCorrections(CheckedSections& in, const SceneCounts& counts, Scene& scene) {
  if (!derivable(counts)) return in.fail("illuminanceStatistics", "it would take too long to derive");
  const auto rows = rowsOfSurfaces(scene.patches, counts.surfaces);
  const auto read = [&](const std::string& name, const SurfaceStatistics& expected,
                        SurfaceStatistics& statistics) {
    const std::vector<std::uint8_t> bytes =
        in.take(name, ElementType::kUint8, Encoding::kCorrections, CheckedSections::kAnyRows, 1);
    if (!in.ok()) return;
    const std::string fault = decodeStatistics(bytes, expected, kBrightestMean, statistics);
    if (!fault.empty()) in.fail(name, fault);
  };
  for (std::uint32_t s = 0; in.ok() && s < counts.surfaces; ++s) {
    const Surface& surface = scene.surfaces[s];
    const auto stored = [&](Quantity quantity) {
      return storedStatistics(scene.patches, scene.responses, quantity, rows[s]);
    };
    const SurfaceStatistics lit = stored(Quantity::kIlluminance);
    read(numberedName("illuminanceStatistics", s), lit, scene.illuminance[s]);
    if (surface.measuring || !in.ok()) continue;
    const std::string name = numberedName("exitanceStatistics", s);
    if (!in.has(name))
      scene.exitance[s] = reflected(scene.illuminance[s], surface.reflectance);
    else
      read(name,
           expectedStatistics(stored(Quantity::kExitance), lit, scene.illuminance[s], surface.reflectance),
           scene.exitance[s]);
  }
}

void readCovariances(CheckedSections& in, const SceneCounts& counts, Scene& scene) {
  const std::uint32_t m = counts.sites;
  const std::vector<double> lit = in.doubles("illuminanceMeans", counts.surfaces, m, 0, kBrightestMean);
  const std::vector<double> leaving = in.doubles("exitanceMeans", counts.surfaces, m, 0, kBrightestMean);
  for (std::uint32_t s = 0; in.ok() && s < counts.surfaces; ++s) {
    SurfaceStatistics& illuminance = scene.illuminance[s];
    SurfaceStatistics& exitance = scene.exitance[s];
    illuminance.mean.assign(lit.begin() + std::size_t{s} * m, lit.begin() + (s + 1) * std::size_t{m});
    readCovariance(in, numberedName("illuminanceCovariance", s), m, illuminance.covariance);
    if (scene.surfaces[s].measuring || !in.ok()) continue;
    const std::string name = numberedName("exitanceCovariance", s);
    if (in.has(name)) {
      exitance.mean.assign(leaving.begin() + std::size_t{s} * m, leaving.begin() + (s + 1) * std::size_t{m});
      readCovariance(in, name, m, exitance.covariance);
    } else {
      exitance = reflected(illuminance, scene.surfaces[s].reflectance);
    }
  }
}

void readStatistics(CheckedSections& in, const SceneCounts& counts, Scene& scene) {
  scene.illuminance.resize(counts.surfaces);
  scene.exitance.resize(counts.surfaces);
  if (in.has("illuminanceStatistics"))
    readCorrections(in, counts, scene);
  else
    readCovariances(in, counts, scene);
}

/// Of a section that may be one of several: their names differ by a number.
bool isAmong(std::span<const std::string_view> names, std::string_view section) {
  return std::find(names.begin(), names.end(), section.substr(0, section.find('.'))) != names.end();
}

}  // namespace

Result<SceneReader> SceneReader::open(std::span<const std::uint8_t> file) {
  Result<SceneTable> table = readSceneTable(file);
  if (!table) return table.error();
  return SceneReader(std::move(table.value()));
}

Result<SceneReader> SceneReader::openHead(std::span<const std::uint8_t> head, std::uint64_t fileBytes) {
  Result<SceneTable> table = readSceneHead(head, fileBytes);
  if (!table) return table.error();
  return SceneReader(std::move(table.value()));
}

bool SceneReader::early(std::uint32_t section) const {
  constexpr std::string_view kEarly[] = {
      "surfaceNames",      "surfaces",      "planeBorders",  "patchCenters",    "patchNormals", "patchAreas",
      "patchReflectances", "patchSurfaces", "patchClusters", "patchNeighbours", "patchCovered", "sites",
      "openingLayout",     "openingScales", "openingLight"};
  const std::string_view name = table_.sections[section].name;
  return std::find(std::begin(kEarly), std::end(kEarly), name) != std::end(kEarly);
}

bool SceneReader::needed(std::uint32_t section) const {
  constexpr std::string_view kLight[] = {"responses",       "responseScales",  "responseReferences",
                                         "responseOffsets", "responseColumns", "responseWeights"};
  return early(section) || isAmong(kLight, table_.sections[section].name) || ofStatistics(section);
}

bool SceneReader::ofStatistics(std::uint32_t section) const {
  constexpr std::string_view kStatistics[] = {"illuminanceMeans",      "exitanceMeans",
                                              "illuminanceCovariance", "exitanceCovariance",
                                              "illuminanceStatistics", "exitanceStatistics"};
  return isAmong(kStatistics, table_.sections[section].name);
}

bool SceneReader::ofOperator(std::uint32_t section) const {
  return isOperatorSection(table_.sections[section].name);
}

/// Not while only a part of it is, and not once it has been decoded.
bool SceneReader::isOperatorThere() const {
  bool isThere = false;
  for (std::uint32_t i = 0; i < bytes_.size(); ++i) {
    if (!ofOperator(i)) continue;
    if (bytes_[i].empty()) return false;
    isThere = true;
  }
  return isThere;
}

Result<Done> SceneReader::verify(std::uint32_t section, std::span<const std::uint8_t> bytes) const {
  if (section >= table_.sections.size()) return Error{"there is no section " + std::to_string(section)};
  const SceneSection& line = table_.sections[section];
  if (bytes.size() != line.inflatedBytes) return faultIn(line.name, "its size differs");
  if (crc32Of(bytes) != line.inflatedCrc) return faultIn(line.name, "checksum differs");
  return Done{};
}

Result<Done> SceneReader::provide(std::uint32_t section, std::vector<std::uint8_t> bytes) {
  const Result<Done> verified = verify(section, bytes);
  if (!verified) return verified.error();
  bytes_[section] = std::move(bytes);
  if (!outline_) return Done{};
  CheckedSections in(table_, bytes_);
  responses_->advance(in, table_.counts, outline_->patches);
  if (in.ok() && isOperatorThere()) readOperator(in, table_.counts, *outline_);
  if (!in.ok()) return in.fault();
  return Done{};
}

Result<Done> SceneReader::readOutline() {
  CheckedSections in(table_, bytes_);
  const SceneCounts& counts = table_.counts;
  Scene scene;
  scene.identity = table_.identity;
  readSurfaces(in, counts, scene);
  readBorders(in, counts, scene);
  if (in.ok()) readPatches(in, counts, scene);
  if (in.ok()) readSites(in, counts, scene);
  if (in.ok() && in.has("openingLight"))
    opening_ = readOpening(in, scene.patches, counts.surfaces, counts.sites);
  if (!in.ok()) return in.fault();
  outline_ = std::make_unique<Scene>(std::move(scene));
  responses_ = std::make_unique<ResponseSections>();
  return Done{};
}

Result<Scene> SceneReader::finish() {
  const Result<std::unique_ptr<Scene>> scene = finishLight();
  if (!scene) return scene.error();
  const Result<Done> read = finishStatistics(**scene);
  if (!read) return read.error();
  return std::move(**scene);
}

Result<std::unique_ptr<Scene>> SceneReader::finishLight() {
  if (!outline_) {
    const Result<Done> read = readOutline();
    if (!read) return read.error();
  }
  CheckedSections in(table_, bytes_);
  readResponses(in, table_.counts, *responses_, *outline_);
  responses_.reset();
  std::unique_ptr<Scene> scene = std::move(outline_);
  if (in.ok()) readOperator(in, table_.counts, *scene);
  if (!in.ok()) return in.fault();
  return scene;
}

Result<Done> SceneReader::finishStatistics(Scene& scene) {
  CheckedSections in(table_, bytes_);
  readStatistics(in, table_.counts, scene);
  if (!in.ok()) return in.fault();
  return Done{};
}

Result<Done> SceneReader::finishOperator(Scene& scene) {
  CheckedSections in(table_, bytes_);
  readOperator(in, table_.counts, scene);
  if (!in.ok()) return in.fault();
  return Done{};
}

}  // namespace fiatlux
