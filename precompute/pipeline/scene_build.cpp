// Encode, read back, compare: no scene file leaves unmeasured.
#include "precompute/pipeline/scene_build.h"

#include <algorithm>
#include <cmath>

#include "core/base/random.h"
#include "core/scene/covariance_codec.h"
#include "core/scene/scene_reader.h"
#include "core/scene/scene_sections.h"
#include "core/scene/section_codec.h"
#include "precompute/base/parallel.h"

namespace fiatlux {
namespace {

const std::string kNotReadBack = "the scene file just made cannot be read back (";

constexpr std::uint32_t kTrialLayouts = 1000, kTrialLuminaires = 6, kTrialSeed = 2024;

constexpr double kDarkShare = 1e-3;  // of the room's mean: errors of what is darker do not matter

double relative(double stored, double exact, double least) {
  return std::abs(stored - exact) / std::max({std::abs(exact), least, 1e-300});
}

/// Widens `errors` by what a layout shows of one surface. `roomMean`: over all surfaces.
void compare(const SurfaceStatistics& exact, const SurfaceStatistics& stored, const Layout& layout,
             double roomMean, FileErrors& errors) {
  const MeanAndSigma truth = meanAndSigmaOf(exact, layout), read = meanAndSigmaOf(stored, layout);
  if (!(truth.mean > 0)) return;
  const double least = kDarkShare * roomMean;
  errors.mean = std::max(errors.mean, relative(read.mean, truth.mean, least));
  // note: a surface that is evenly lit to rounding (a single patch, say) has no sigma to be wrong about.
  double squares = 0;
  for (std::uint32_t i : layout.sites) squares += exact.mean[i] * exact.mean[i];
  if (truth.sigma * truth.sigma < 1e-18 * squares) return;
  errors.sigma = std::max(errors.sigma, relative(read.sigma, truth.sigma, least));
}

/// Mean of a quantity over all surfaces of a room that are no measuring planes, for a layout.
double roomMeanOf(const Scene& scene, const std::vector<SurfaceStatistics>& statistics,
                  const Layout& layout) {
  double flux = 0, area = 0;
  for (std::size_t s = 0; s < scene.surfaces.size(); ++s) {
    if (scene.surfaces[s].measuring) continue;
    for (std::size_t i = 0; i < layout.sites.size(); ++i)
      flux += scene.surfaces[s].area * layout.dimming * layout.flux[i] * statistics[s].mean[layout.sites[i]];
    area += scene.surfaces[s].area;
  }
  return area > 0 ? flux / area : 0;
}

/// Of statistics by random layouts, of patch light by the encoder's own report.
FileErrors errorsOf(const Scene& exact, const Scene& stored, std::vector<float> responseRms) {
  FileErrors errors;
  Random random(kTrialSeed);
  const auto m = static_cast<std::uint32_t>(exact.sites.size());
  const std::uint32_t count = std::min(kTrialLuminaires, m);
  Layout layout{std::vector<std::uint32_t>(count), std::vector<double>(count, 1.0), 1};
  for (std::uint32_t trial = 0; trial < kTrialLayouts; ++trial) {
    for (std::uint32_t& site : layout.sites) site = random.below(m);
    const double illuminance = roomMeanOf(exact, exact.illuminance, layout),
                 exitance = roomMeanOf(exact, exact.exitance, layout);
    for (std::size_t s = 0; s < exact.surfaces.size(); ++s) {
      compare(exact.illuminance[s], stored.illuminance[s], layout, illuminance, errors);
      if (!exact.surfaces[s].measuring)
        compare(exact.exitance[s], stored.exitance[s], layout, exitance, errors);
    }
  }
  std::sort(responseRms.begin(), responseRms.end());
  if (!responseRms.empty()) {
    errors.patchRmsMedian = responseRms[responseRms.size() / 2];
    errors.patchRmsWorst = responseRms.back();
  }
  return errors;
}

/// Y in blocks of columns, V as what is needed to rebuild it, and the k x k covariances of -Y.
void addPaper(const Scene& scene, const PaperTransport& paper, std::vector<PlainSection>& sections) {
  const std::uint32_t n = scene.patches.count, k = scene.patches.clusterCount;
  const std::uint32_t perBlock =
      std::max<std::uint32_t>(1, static_cast<std::uint32_t>(kMaxInflatedBytes / 4 / n));
  for (std::uint32_t first = 0, block = 0; first < k; first += perBlock, ++block) {
    const std::uint32_t width = std::min(perBlock, k - first);
    std::vector<float> columns;
    columns.reserve(std::size_t{n} * width);
    for (std::uint32_t p = 0; p < n; ++p) {
      const float* row = &paper.y[std::size_t{p} * k + first];
      columns.insert(columns.end(), row, row + width);
    }
    sections.push_back(plainSection(numberedName("Y", block), ElementType::kFloat32, Encoding::kFloatPlanes,
                                    n, width, encodeFloatPlanes(columns)));
  }
  // V_qc = A_q / A_c for the cluster c of q (patchClusters).
  std::vector<double> clusterArea(k);
  for (std::uint32_t q = 0; q < n; ++q) clusterArea[scene.patches.cluster[q]] += scene.patches.area[q];
  std::vector<float> v;
  for (std::uint32_t q = 0; q < n; ++q)
    v.push_back(static_cast<float>(scene.patches.area[q] / clusterArea[scene.patches.cluster[q]]));
  sections.push_back(
      plainSection("V", ElementType::kFloat32, Encoding::kFloatPlanes, n, 1, encodeFloatPlanes(v)));
  for (std::uint32_t s = 0; s < paper.exitance.size(); ++s) {
    const SurfaceStatistics& statistics = paper.exitance[s];
    if (statistics.mean.empty()) continue;
    const std::vector<float> mean(statistics.mean.begin(), statistics.mean.end());
    sections.push_back(plainSection(numberedName("clusterMean", s), ElementType::kFloat32,
                                    Encoding::kFloatPlanes, 1, k, encodeFloatPlanes(mean)));
    sections.push_back(encodeCovariance(numberedName("clusterCovariance", s), statistics.covariance, k,
                                        kCovarianceTolerance));
  }
}

PlainSection bytesSection(const char* name, std::vector<std::uint8_t> bytes) {
  const auto size = static_cast<std::uint32_t>(bytes.size());
  return plainSection(name, ElementType::kUint8, Encoding::kPlain, size, 1, std::move(bytes));
}

/// What a reader will make of a file of these sections.
Result<Scene> readBack(const Scene& scene, const std::vector<PlainSection>& sections) {
  std::vector<StoredSection> stored;
  for (const PlainSection& plain : sections) stored.push_back({plain.section, plain.bytes});
  Result<SceneReader> reader = SceneReader::open(assembleSceneFile(scene.identity, countsOf(scene), stored));
  if (!reader) return reader.error();
  for (std::uint32_t i = 0; i < sections.size(); ++i) {
    if (!reader->needed(i) && !reader->ofOperator(i)) continue;
    const Result<Done> provided = reader->provide(i, sections[i].bytes);
    if (!provided) return provided.error();
  }
  return reader->finish();
}

StoredSection storeSection(const PlainSection& plain, const Deflate& deflate) {
  // note: a very even section would look like a bomb to the reader.
  const auto looksLikeBomb = [&](const std::vector<std::uint8_t>& bytes) {
    return plain.bytes.size() > kFreeInflatedBytes && plain.bytes.size() / kMaxInflationRatio > bytes.size();
  };
  StoredSection stored{plain.section, deflate(plain.bytes, DeflateKind::kUsual)};
  if (looksLikeBomb(stored.bytes)) stored.bytes = deflate(plain.bytes, DeflateKind::kHuffman);
  stored.section.codec = Codec::kDeflate;
  if (stored.bytes.empty() || stored.bytes.size() >= plain.bytes.size()) {
    stored.section.codec = Codec::kStored;
    stored.bytes = plain.bytes;
  }
  return stored;
}

}  // namespace

std::vector<StoredSection> storeSections(const std::vector<PlainSection>& sections, const Deflate& deflate,
                                         unsigned threads) {
  std::vector<StoredSection> stored(sections.size());
  parallelFor(sections.size(), threads,
              [&](std::size_t i) { stored[i] = storeSection(sections[i], deflate); });
  return stored;
}

Scene sceneOf(const Room& room, Transport&& transport, const std::string& identity) {
  Scene scene;
  scene.identity = identity;
  scene.patches = room.patches;
  scene.surfaces = room.surfaces;
  scene.sites = room.sites;
  for (std::size_t s = 0; s < scene.surfaces.size(); ++s) scene.surfaces[s].lost = transport.lost[s];
  scene.responses = std::move(transport.responses);
  // note: float sums of refinement steps may end a hair below zero where it is dark.
  for (float& value : scene.responses.illuminance) value = std::max(0.0f, value);
  scene.errorBound.assign(scene.surfaces.size(), 0);
  scene.illuminance = std::move(transport.illuminance);
  scene.exitance = std::move(transport.exitance);
  scene.lightOperator = std::move(transport.lightOperator);
  return scene;
}

Result<EncodedScene> encodeSceneFile(const Scene& scene, std::vector<std::uint8_t> picture,
                                     const std::optional<PaperTransport>& paper,
                                     const std::optional<OpeningLight>& opening, const Deflate& deflate,
                                     unsigned threads) {
  EncodingReport report;
  Result<std::vector<PlainSection>> sections = encodeScene(scene, &report);
  if (!sections) return sections.error();
  if (paper) addPaper(scene, *paper, sections.value());
  if (opening && opening->ofTypes) putOperatorFirst(*sections);
  std::vector<PlainSection> early;
  if (opening)
    early = encodeOpening(scene.patches, static_cast<std::uint32_t>(scene.surfaces.size()), *opening);
  if (!picture.empty()) early.push_back(bytesSection("room", std::move(picture)));
  insertEarly(*sections, std::move(early));
  for (const PlainSection& section : sections.value())
    if (section.bytes.size() > kMaxInflatedBytes)
      return Error{"section " + section.section.name + " would be larger than " +
                   std::to_string(kMaxInflatedBytes >> 20) + " MB: use larger patches or smaller pictures"};
  EncodedScene encoded;
  encoded.identity = scene.identity;
  encoded.counts = countsOf(scene);
  encoded.ranks = std::move(report.ranks);

  // What will be written is read back and measured before the provenance is added that tells so, and
  // meanwhile deflated, which changes nothing for who inflates it.
  std::string notRead;
  const auto measure = [&] {
    if (const Result<Scene> back = readBack(scene, *sections); back)
      encoded.errors = errorsOf(scene, *back, std::move(report.responseRms));
    else
      notRead = back.error().message;
  };
  const auto store = [&] { encoded.sections = storeSections(*sections, deflate, std::max(2u, threads) - 1); };
  parallelFor(2, threads, [&](std::size_t i) { i == 0 ? measure() : store(); });
  if (!notRead.empty()) return Error{kNotReadBack + notRead + ")"};
  return encoded;
}

Result<std::vector<std::uint8_t>> closeSceneFile(EncodedScene scene, const std::string& provenance,
                                                 const Deflate& deflate) {
  std::vector<PlainSection> last;
  last.push_back(bytesSection("provenance", {provenance.begin(), provenance.end()}));
  insertEarly(scene.sections, storeSections(last, deflate));
  std::vector<std::uint8_t> file = assembleSceneFile(scene.identity, scene.counts, scene.sections);
  const Result<SceneTable> table = readSceneTable(file);
  if (!table) return Error{kNotReadBack + table.error().message + ")"};
  return file;
}

}  // namespace fiatlux
