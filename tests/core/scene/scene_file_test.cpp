// Scene files (scene_sections, section_codec, checked_sections, scene_reader): there and back, and every way
// in which bytes can lie.
#include "core/scene/scene_file.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <string_view>

#include "core/scene/crc32.h"
#include "core/scene/scene_reader.h"
#include "core/scene/scene_sections.h"
#include "core/scene/section_codec.h"
#include "tests/core/scene/base64.h"
#include "tests/core/scene/golden_scene_v1.h"
#include "tests/core/scene/golden_scene_v2.h"
#include "tests/core/synthetic_scene.h"

namespace fiatlux {
namespace {

/// A file of stored (not deflated) sections; deflated ones are tested where an inflater is (precompute).
std::vector<std::uint8_t> fileOf(const Scene& scene, const std::vector<PlainSection>& plain) {
  std::vector<StoredSection> sections;
  for (const PlainSection& part : plain) sections.push_back({part.section, part.bytes});
  return assembleSceneFile(scene.identity, countsOf(scene), sections);
}

std::vector<std::uint8_t> fileOf(const Scene& scene) { return fileOf(scene, encodeScene(scene).value()); }

Result<Scene> read(std::span<const std::uint8_t> file) {
  Result<SceneReader> reader = SceneReader::open(file);
  if (!reader) return reader.error();
  for (std::uint32_t i = 0; i < reader->table().sections.size(); ++i) {
    const auto bytes = storedBytes(file, reader->table().sections[i]);
    if (!reader->needed(i)) continue;
    const Result<Done> provided = reader->provide(i, {bytes.begin(), bytes.end()});
    if (!provided) return provided.error();
  }
  return reader->finish();
}

std::string errorOf(std::span<const std::uint8_t> file) {
  const Result<Scene> scene = read(file);
  return scene ? "no error" : scene.error().message;
}

/// Writes `value` at `at` and mends the table's checksum, as a forger would.
template <class T>
std::vector<std::uint8_t> forged(std::vector<std::uint8_t> file, std::size_t at, T value) {
  std::memcpy(&file[at], &value, sizeof value);
  std::uint32_t sections;
  std::memcpy(&sections, &file[12], 4);
  std::memset(&file[60], 0, 4);
  const std::uint32_t crc = crc32Of({file.data(), std::min(file.size(), 64 + std::size_t{sections} * 80)});
  std::memcpy(&file[60], &crc, 4);
  return file;
}

/// The file of `scene` with one section's bytes changed and all its checksums right.
template <class Change>
std::string errorWith(const Scene& scene, const std::string& name, Change change) {
  std::vector<PlainSection> sections = encodeScene(scene).value();
  for (PlainSection& part : sections) {
    if (part.section.name != name) continue;
    change(part);
    const float bound = part.section.errorBound;
    part = plainSection(name, part.section.type, part.section.encoding, part.section.rows,
                        part.section.columns, part.bytes, bound);
  }
  return errorOf(fileOf(scene, sections));
}

using ::testing::Test;

TEST(Crc32, KnownAnswer) {
  const char* text = "123456789";
  EXPECT_EQ(crc32Of({reinterpret_cast<const std::uint8_t*>(text), 9}), 0xcbf43926u);
}

TEST(SceneFile, RoundTripKeepsEverythingButRounding) {
  const Scene scene = syntheticScene(40, 9);
  const Result<Scene> back = read(fileOf(scene));
  ASSERT_TRUE(back) << back.error().message;
  EXPECT_EQ(back->identity, scene.identity);
  ASSERT_EQ(back->surfaces.size(), 3u);
  EXPECT_EQ(back->surfaces[1].name, "wall \xc3\xa9");
  EXPECT_EQ(back->surfaces[1].patches, 480u);
  EXPECT_DOUBLE_EQ(back->surfaces[1].reflectance, scene.surfaces[1].reflectance);
  EXPECT_TRUE(back->surfaces[2].measuring);
  EXPECT_EQ(back->patches.count, scene.patches.count);
  EXPECT_EQ(back->patches.cluster, scene.patches.cluster);
  EXPECT_EQ(back->patches.left, scene.patches.left);
  EXPECT_EQ(back->patches.up, scene.patches.up);
  EXPECT_EQ(back->patches.reflectance, scene.patches.reflectance);
  for (std::uint32_t p = 0; p < scene.patches.rows(); ++p) {
    EXPECT_NEAR(length(back->patches.center[p] - scene.patches.center[p]), 0, 2e-5);
    EXPECT_NEAR(dot(back->patches.normal[p], scene.patches.normal[p]), 1, 1e-8);
    EXPECT_NEAR(back->patches.area[p], scene.patches.area[p], 1e-7 * scene.patches.area[p]);
  }
  ASSERT_EQ(back->sites.size(), 9u);
  EXPECT_EQ(back->sites[4].position.x, scene.sites[4].position.x);
  EXPECT_EQ(back->sites[4].size, 0.5);
}

TEST(SceneFile, StatisticsSurviveToATenThousandth) {
  const Scene scene = syntheticScene(64, 40);
  const Result<Scene> back = read(fileOf(scene));
  ASSERT_TRUE(back) << back.error().message;
  Random random(1);
  for (int trial = 0; trial < 1000; ++trial)
    for (std::uint32_t s = 0; s < 3; ++s)
      for (const bool exitance : {false, true}) {
        if (exitance && s == 2) continue;
        const SurfaceStatistics& a = (exitance ? scene.exitance : scene.illuminance)[s];
        const SurfaceStatistics& b = (exitance ? back->exitance : back->illuminance)[s];
        double mean[2] = {0, 0}, variance[2] = {0, 0};
        std::uint32_t sites[6];
        for (std::uint32_t& site : sites) site = random.below(40);
        for (std::uint32_t i : sites) {
          mean[0] += a.mean[i], mean[1] += b.mean[i];
          for (std::uint32_t j : sites)
            variance[0] += a.covariance[i * 40 + j], variance[1] += b.covariance[i * 40 + j];
        }
        ASSERT_NEAR(mean[1], mean[0], 1e-4 * mean[0]);
        ASSERT_NEAR(std::sqrt(variance[1]), std::sqrt(variance[0]), 1e-4 * std::sqrt(variance[0]));
      }
}

TEST(SceneFile, TheBorderOfAMeasuringPlaneIsKept) {
  Scene scene = syntheticScene(40, 9);
  EXPECT_FALSE(SceneReader::open(fileOf(scene))->table().find("planeBorders"));  // files without are as ever
  const auto plane = std::find_if(scene.surfaces.begin(), scene.surfaces.end(),
                                  [](const Surface& surface) { return surface.measuring; });
  plane->border = 0.35;
  const Result<Scene> back = read(fileOf(scene));
  ASSERT_TRUE(back) << back.error().message;
  for (std::size_t s = 0; s < scene.surfaces.size(); ++s)
    EXPECT_EQ(back->surfaces[s].border, scene.surfaces[s].border);
  plane->border = 0;
  scene.surfaces[0].border = 0.35;
  EXPECT_NE(errorOf(fileOf(scene)).find("no measuring plane has a border"), std::string::npos);
}

TEST(SceneFile, WhatIsCoveredIsKeptAndLeftOutOfStatistics) {
  Scene scene = syntheticScene(40, 9);
  EXPECT_EQ(errorWith(scene, "patchCovered", [](PlainSection&) {}), "no error");
  scene.patches.covered.assign(scene.patches.rows(), 0);
  for (std::uint32_t p = 0; p < 40; ++p) scene.patches.covered[p] = 1;  // five rows of the floor's eight
  scene.surfaces[0].area -= 40 * scene.patches.area[0];
  setStatistics(scene);
  const Result<Scene> back = read(fileOf(scene));
  ASSERT_TRUE(back) << back.error().message;
  EXPECT_EQ(back->patches.covered, scene.patches.covered);
  EXPECT_EQ(back->surfaces[0].patches, scene.surfaces[0].patches);
  const Layout layout{{0, 3, 8}, {1000, 2000, 500}, 1};
  const std::vector<float> light = illuminanceOf(scene, layout);
  for (const SurfaceSet& surfaces : {SurfaceSet{0}, SurfaceSet{0, 1}}) {
    const ExplicitStatistics exact = explicitStatistics(scene, light, surfaces);
    const MeanAndSigma read =
        meanAndSigmaOf(unionStatistics(*back, Quantity::kIlluminance, surfaces), layout);
    EXPECT_NEAR(read.mean, exact.mean, 1e-4 * exact.mean);
    EXPECT_NEAR(read.sigma, exact.sigma, 1e-4 * exact.sigma);
  }
  EXPECT_NE(errorWith(scene, "patchCovered", [](PlainSection& part) { part.bytes[0] = 4; }).find("neither"),
            std::string::npos);
  scene.patches.covered.assign(scene.patches.rows(), 1);
  EXPECT_NE(errorOf(fileOf(scene)).find("no patch that counts"), std::string::npos);
}

TEST(SceneFile, OldVersionsStayReadable) {
  const Scene scene = syntheticScene(2, 2);
  for (const char* golden : {kSceneFileVersion1, kSceneFileVersion2}) {
    const Result<Scene> back = read(fromBase64(golden));
    ASSERT_TRUE(back) << back.error().message;
    EXPECT_EQ(back->identity, "0123456789abcdef");
    EXPECT_EQ(back->surfaces[1].name, "wall \xc3\xa9");
    EXPECT_EQ(back->patches.count, 40u);
    EXPECT_EQ(back->patches.rows(), 44u);
    EXPECT_EQ(back->patches.left, scene.patches.left);
    EXPECT_EQ(back->sites[1].position.x, 0.375);
    // Numbers of the day it was written.
    EXPECT_NEAR(back->illuminance[0].mean[1], 0.033451896393671632, 1e-8 * 0.0335);
    EXPECT_NEAR(back->exitance[1].covariance[1], 0.00020802727938613465, 2e-6 * 0.000208);
    EXPECT_NEAR(back->responses.column(1)[5], 0.0345561281, 0.008 * 0.0335);
    EXPECT_NEAR(back->responses.column(0)[20], 0.0182332676, 0.0005);
  }
}

TEST(SceneFile, CutAnywhereIsRefused) {
  const std::vector<std::uint8_t> file = fileOf(syntheticScene(4, 2));
  for (std::size_t bytes = 0; bytes < file.size(); ++bytes)
    ASSERT_FALSE(read({file.data(), bytes})) << "cut after " << bytes;
  std::vector<std::uint8_t> longer = file;
  longer.push_back(0);
  EXPECT_FALSE(read(longer));
}

TEST(SceneFile, EveryFlippedBitIsRefused) {
  std::vector<std::uint8_t> file = fileOf(syntheticScene(4, 2));
  for (std::size_t i = 0; i < file.size(); ++i)
    for (int bit = 0; bit < 8; ++bit) {
      file[i] ^= static_cast<std::uint8_t>(1 << bit);
      ASSERT_FALSE(readSceneTable(file)) << "byte " << i << " bit " << bit;
      file[i] ^= static_cast<std::uint8_t>(1 << bit);
    }
  EXPECT_TRUE(read(file));
}

TEST(SceneFile, DamageIsNamed) {
  std::vector<std::uint8_t> file = fileOf(syntheticScene(4, 2));
  file.back() ^= 1;
  EXPECT_EQ(errorOf(file),
            "section illuminanceStatistics.2: checksum differs; the file is damaged: make it again with "
            "fiatlux precompute");
}

TEST(SceneFile, FutureVersionNamesBoth) {
  const std::string error = errorOf(forged<std::uint32_t>(fileOf(syntheticScene(4, 2)), 8, 7));
  EXPECT_NE(error.find("version 7"), std::string::npos) << error;
  EXPECT_NE(error.find("up to version 2"), std::string::npos) << error;
}

TEST(SceneFile, OtherFilesAreRefused) {
  const std::string html = "<!doctype html><title>404</title>";
  EXPECT_EQ(errorOf({reinterpret_cast<const std::uint8_t*>(html.data()), html.size()}),
            "not a Fiat Lux scene file: make one with fiatlux precompute");
}

TEST(SceneFile, HeaderIsCheckedBeforeItIsBelieved) {
  const std::vector<std::uint8_t> file = fileOf(syntheticScene(4, 2));
  const auto counts = [&](std::size_t field, std::uint32_t value) {
    return errorOf(forged(file, 32 + 4 * field, value));
  };
  EXPECT_NE(counts(0, 0xffffffffu).find("out of range"), std::string::npos);  // patches
  EXPECT_NE(counts(0, 0).find("out of range"), std::string::npos);
  EXPECT_NE(counts(2, 1000000).find("clusters of only"), std::string::npos);  // k > n
  EXPECT_NE(errorOf(forged(forged<std::uint32_t>(file, 32, 1 << 20), 40, 1 << 19)).find("over 2^32"),
            std::string::npos);
  EXPECT_NE(counts(3, 0).find("out of range"), std::string::npos);  // sites
  EXPECT_NE(counts(5, 0).find("out of range"), std::string::npos);  // surfaces
  EXPECT_NE(errorOf(forged<std::uint32_t>(file, 12, 0xffffffffu)).find("do not fit"), std::string::npos);
}

TEST(SceneFile, TableIsCheckedBeforeItIsBelieved) {
  const std::vector<std::uint8_t> file = fileOf(syntheticScene(4, 2));
  const std::size_t entry = 64 + 2 * 80;  // patchCenters
  const auto fault = [&](auto value, std::size_t field) {
    return errorOf(forged(file, entry + field, value));
  };
  EXPECT_NE(fault(std::uint64_t{100} << 20, 72).find("64 MB"), std::string::npos);
  EXPECT_NE(fault(std::uint32_t{0x80000000u}, 36).find("shape"), std::string::npos);
  EXPECT_NE(fault(std::uint64_t{1} << 63, 56).find("overlaps"), std::string::npos);
  EXPECT_NE(fault(std::uint64_t{0}, 56).find("overlaps"), std::string::npos);
  EXPECT_NE(fault(std::uint64_t{1}, 64).find("sizes differ"), std::string::npos);
  EXPECT_NE(fault(std::uint8_t{9}, 32).find("unknown type"), std::string::npos);
  EXPECT_NE(fault(std::uint8_t{7}, 0).find("plain text"), std::string::npos);
  EXPECT_NE(fault(std::nanf(""), 44).find("error bound"), std::string::npos);
}

TEST(SceneFile, RatiosOfABombAreRefused) {
  std::vector<std::uint8_t> file = fileOf(syntheticScene(4, 2));
  const std::size_t entry = 64 + 2 * 80;
  file = forged<std::uint8_t>(file, entry + 33, 1);                          // deflated, so it says
  file = forged<std::uint32_t>(file, entry + 36, (60u << 20) / 12);          // rows x 3 x 4 bytes
  file = forged<std::uint64_t>(file, entry + 72, (60u << 20) / 12 * 12ull);  // to 60 MB
  EXPECT_NE(errorOf(file).find("more than 200 times"), std::string::npos) << errorOf(file);
}

TEST(SceneFile, ValuesAreChecked) {
  const Scene scene = syntheticScene(4, 2);
  const auto poke = [](std::size_t at, auto value) {
    return [=](PlainSection& part) { std::memcpy(&part.bytes[at], &value, sizeof value); };
  };
  const auto nan = [](PlainSection& part) {
    part.bytes[part.bytes.size() - 1] = part.bytes[part.bytes.size() * 3 / 4 - 1] = 0xff;
  };
  EXPECT_NE(errorWith(scene, "sites", poke(0, std::nan(""))).find("section sites"), std::string::npos);
  const auto shorten = [](PlainSection& part) { part.bytes.resize(part.section.rows = 3); };
  EXPECT_NE(errorWith(scene, "illuminanceStatistics", shorten).find("length that the sites need"),
            std::string::npos);
  EXPECT_NE(errorWith(scene, "surfaces", poke(0, -1.0)).find("out of range"), std::string::npos);
  EXPECT_NE(errorWith(scene, "patchSurfaces", poke(0, std::uint8_t{40})).find("not there"),
            std::string::npos);
  EXPECT_NE(errorWith(scene, "patchClusters", poke(0, std::uint8_t{40})).find("cluster that is not there"),
            std::string::npos);
  EXPECT_NE(errorWith(scene, "patchNeighbours", poke(0, std::uint8_t{2})).find("neighbour"),
            std::string::npos);
  EXPECT_NE(errorWith(scene, "responseColumns", poke(0, std::uint8_t{40})).find("column"), std::string::npos);
  EXPECT_NE(errorWith(scene, "responseReferences", poke(3, std::uint8_t{40})).find("column"),
            std::string::npos);
  EXPECT_NE(errorWith(scene, "responses", shorten).find("section responses: "), std::string::npos);
  const auto empty = [](PlainSection& part) { part.bytes.resize(part.section.rows = 1); };
  EXPECT_NE(errorWith(scene, "responses", empty).find("too short"), std::string::npos);
  EXPECT_NE(errorWith(scene, "responseScales", nan).find("section responseScales"), std::string::npos);
  EXPECT_NE(errorWith(scene, "patchAreas", nan).find("section patchAreas"), std::string::npos);
  const auto unname = [](PlainSection& part) { part.bytes[5] = 'x'; };
  EXPECT_NE(errorWith(scene, "surfaceNames", unname).find("fewer names"), std::string::npos);
}

TEST(SceneFile, MissingSectionIsNamed) {
  const Scene scene = syntheticScene(4, 2);
  std::vector<PlainSection> sections = encodeScene(scene).value();
  sections.erase(sections.begin() + 3);
  EXPECT_NE(errorOf(fileOf(scene, sections)).find("section patchNormals: it is missing"), std::string::npos);
}

TEST(SceneFile, SitesMayShareColumns) {
  const Scene scene = syntheticScene(8, 3);
  std::vector<PlainSection> sections = encodeScene(scene).value();
  for (PlainSection& part : sections)
    if (part.section.name == "responseWeights") {
      const double half = 0.5;
      std::memcpy(&part.bytes[8], &half, 8);
      part = plainSection("responseWeights", part.section.type, part.section.encoding, 3, 1, part.bytes);
    }
  const Result<Scene> back = read(fileOf(scene, sections));
  ASSERT_TRUE(back) << back.error().message;
  const Result<Scene> plain = read(fileOf(scene));
  for (std::uint32_t p = 0; p < scene.patches.rows(); ++p) {
    EXPECT_FLOAT_EQ(back->responses.column(1)[p], 0.5f * plain->responses.column(1)[p]);
    EXPECT_EQ(back->responses.column(2)[p], plain->responses.column(2)[p]);
  }
}

/// The file of a scene whose sites share columns as given: `weights[i]` of column `columns[i]`, from
/// `offsets[j]` on for site j.
std::vector<std::uint8_t> fileWithWeights(const Scene& scene, const std::vector<std::uint32_t>& offsets,
                                          const std::vector<std::uint32_t>& columns,
                                          const std::vector<double>& weights) {
  std::vector<PlainSection> sections = encodeScene(scene).value();
  const auto bytesOf = [](const auto& values) {
    const auto* from = reinterpret_cast<const std::uint8_t*>(values.data());
    return std::vector<std::uint8_t>(from, from + values.size() * sizeof values[0]);
  };
  const auto rows = static_cast<std::uint32_t>(weights.size());
  for (PlainSection& part : sections) {
    const SceneSection& s = part.section;
    if (s.name == "responseOffsets")
      part = plainSection(s.name, s.type, s.encoding, s.rows, 1, encodeDeltaPlanes(offsets, 1));
    else if (s.name == "responseColumns")
      part = plainSection(s.name, s.type, s.encoding, rows, 1, encodeDeltaPlanes(columns, 1));
    else if (s.name == "responseWeights")
      part = plainSection(s.name, s.type, s.encoding, rows, 1, bytesOf(weights));
  }
  return fileOf(scene, sections);
}

TEST(SceneFile, WeightsThatWouldTakeMinutesOrGoBeyondNumbersAreRefused) {
  const Scene scene = syntheticScene(200, 2);  // 4400 rows
  constexpr std::uint32_t kMany = 300000;
  EXPECT_NE(errorOf(fileWithWeights(scene, {0, kMany, kMany}, std::vector<std::uint32_t>(kMany, 0),
                                    std::vector<double>(kMany, 1e-9)))
                .find("patches x weights is over 2^30"),
            std::string::npos);
  EXPECT_NE(errorOf(fileWithWeights(scene, {0, 1, 2}, {0, 1}, {1, 1e30})).find("out of range"),
            std::string::npos);
  EXPECT_EQ(errorOf(fileWithWeights(scene, {0, 2, 3}, {0, 1, 1}, {0.5, 0.5, 1})), "no error");
}

TEST(SceneFile, LightBeyondNumbersIsRefused) {
  Scene scene = syntheticScene(4, 2);
  scene.illuminance[0].mean[0] = 1e25;
  EXPECT_NE(errorOf(fileOf(scene)).find("section illuminanceStatistics: a value is out of range"),
            std::string::npos);
  scene = syntheticScene(4, 2);
  scene.exitance[1].mean[0] = 1e25;
  EXPECT_NE(errorOf(fileOf(scene)).find("section exitanceStatistics.1: a value is out of range"),
            std::string::npos);
}

/// So many sites and patches that deriving their statistics would take long; all of them dark, but for one
/// surface's mean.
Scene unwieldyScene() {
  constexpr std::uint32_t kSites = 600;
  Scene scene = syntheticScene(543, 1);
  scene.sites.resize(kSites, scene.sites[0]);
  scene.responses.sites = kSites;
  scene.responses.illuminance.assign(std::size_t{kSites} * scene.patches.rows(), 0);
  for (auto* set : {&scene.illuminance, &scene.exitance})
    for (SurfaceStatistics& statistics : *set)
      if (!statistics.mean.empty())
        statistics = {std::vector<double>(kSites), std::vector<double>(kSites * kSites)};
  scene.illuminance[2].mean[7] = 0.25;
  return scene;
}

TEST(SceneFile, WhatWouldTakeLongToDeriveIsStoredWhole) {
  const Scene scene = unwieldyScene();
  ASSERT_FALSE(derivable(countsOf(scene)));
  const Result<Scene> back = read(fileOf(scene));
  ASSERT_TRUE(back) << back.error().message;
  EXPECT_EQ(back->illuminance[2].mean[7], 0.25);
  EXPECT_EQ(back->illuminance[1].covariance.size(), 360000u);

  const auto poke = [](PlainSection& part) {
    const double huge = 1e25;
    std::memcpy(&part.bytes[0], &huge, 8);
  };
  EXPECT_NE(errorWith(scene, "illuminanceMeans", poke).find("out of range"), std::string::npos);
  // The same as corrections: refused before a product is formed.
  std::vector<PlainSection> sections = encodeScene(scene).value();
  sections.push_back(
      plainSection("illuminanceStatistics", ElementType::kUint8, Encoding::kCorrections, 4, 1, {0, 0, 0, 0}));
  EXPECT_NE(errorOf(fileOf(scene, sections)).find("too long to derive"), std::string::npos);
}

TEST(SceneFile, NamesOfAMegabyteAreRefused) {
  Scene scene = syntheticScene(4, 2);
  scene.surfaces[0].name = std::string(5 << 20, 'n');
  EXPECT_NE(errorOf(fileOf(scene)).find("a name is too long"), std::string::npos);
}

}  // namespace
}  // namespace fiatlux
