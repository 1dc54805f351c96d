// The light at the front of a file: there before the rest, as it was, and refused where it cannot be.
#include "core/scene/opening_light.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstring>

#include "core/scene/scene_reader.h"
#include "core/scene/scene_sections.h"
#include "tests/core/synthetic_scene.h"

namespace fiatlux {
namespace {

const Layout kLayout{{1, 6}, {1000, 2500}, 0.75};

std::vector<PlainSection> openingOf(const Scene& scene) {
  return encodeOpening(scene.patches, 3, {kLayout, illuminanceOf(scene, kLayout)});
}

/// A reader that has been given the early sections of a file with this opening, and nothing else.
Result<SceneReader> readerOf(const Scene& scene, std::vector<PlainSection> opening) {
  std::vector<PlainSection> sections = encodeScene(scene).value();
  insertEarly(sections, std::move(opening));
  std::vector<StoredSection> stored;
  for (const PlainSection& part : sections) stored.push_back({part.section, part.bytes});
  const std::vector<std::uint8_t> file = assembleSceneFile(scene.identity, countsOf(scene), stored);
  Result<SceneReader> reader =
      SceneReader::openHead(std::span(file).first(sceneHeadBytes(file)), file.size());
  if (!reader) return reader;
  for (std::uint32_t i = 0; i < sections.size(); ++i) {
    if (!reader->early(i)) continue;
    const Result<Done> provided = reader->provide(i, sections[i].bytes);
    if (!provided) return provided.error();
  }
  return reader;
}

std::string faultOf(const Scene& scene, const std::vector<PlainSection>& opening) {
  Result<SceneReader> reader = readerOf(scene, opening);
  const Result<Done> read = reader ? reader->readOutline() : Result<Done>(reader.error());
  return read ? "no fault" : read.error().message;
}

TEST(OpeningLight, IsThereBeforeTheRest) {
  const Scene scene = syntheticScene(40, 9);
  Result<SceneReader> reader = readerOf(scene, openingOf(scene));
  ASSERT_TRUE(reader) << reader.error().message;
  ASSERT_TRUE(reader->readOutline());
  EXPECT_EQ(reader->outline()->patches.center.size(), scene.patches.rows());
  EXPECT_EQ(reader->outline()->sites.size(), 9u);
  const OpeningLight& opening = *reader->opening();
  EXPECT_EQ(opening.layout.sites, kLayout.sites);
  EXPECT_EQ(opening.layout.flux, kLayout.flux);
  EXPECT_EQ(opening.layout.dimming, kLayout.dimming);
  const std::vector<float> exact = illuminanceOf(scene, kLayout);
  for (std::uint32_t s = 0; s < 3; ++s) {
    const double mean = explicitStatistics(scene, exact, {s}).mean;
    for (std::uint32_t p = 0; p < scene.patches.rows(); ++p) {
      if (scene.patches.surface[p] == s) {
        ASSERT_NEAR(opening.illuminance[p], exact[p], 0.008 * mean) << p;
      }
    }
  }
  EXPECT_FALSE(reader->finish()) << "the responses have not been provided";
}

TEST(OpeningLight, AFileNeedHaveNone) {
  const Scene scene = syntheticScene(4, 2);
  Result<SceneReader> reader = readerOf(scene, {});
  ASSERT_TRUE(reader && reader->readOutline());
  EXPECT_EQ(reader->opening(), nullptr);
}

TEST(OpeningLight, WhatCannotBeIsRefused) {
  const Scene scene = syntheticScene(40, 9);
  const auto poked = [&](std::size_t index, auto value) {
    std::vector<PlainSection> opening = openingOf(scene);
    PlainSection& part = opening[index];
    std::memcpy(&part.bytes[16], &value, sizeof value);
    part = plainSection(part.section.name, part.section.type, part.section.encoding, part.section.rows,
                        part.section.columns, part.bytes);
    return faultOf(scene, opening);
  };
  EXPECT_EQ(faultOf(scene, openingOf(scene)), "no fault");
  for (const double site : {9.0, 6.0, 0.5})
    EXPECT_NE(poked(0, site).find("section openingLayout: a site is not there"), std::string::npos) << site;
  EXPECT_NE(poked(0, std::nan("")).find("openingLayout"), std::string::npos);
  std::vector<PlainSection> cut = openingOf(scene);
  cut[2] = plainSection("openingLight", ElementType::kUint8, Encoding::kPredicted, 1, 1, {0});
  EXPECT_NE(faultOf(scene, cut).find("section openingLight: it is too short"), std::string::npos);
  cut.pop_back();
  EXPECT_EQ(faultOf(scene, cut), "no fault") << "without its light the rest is nothing that is looked for";
}

TEST(SceneHead, TellsWhatTheWholeFileTells) {
  const Scene scene = syntheticScene(4, 2);
  const Result<std::vector<PlainSection>> sections = encodeScene(scene);
  ASSERT_TRUE(sections) << sections.error().message;
  std::vector<StoredSection> stored;
  for (const PlainSection& part : *sections) stored.push_back({part.section, part.bytes});
  const std::vector<std::uint8_t> file = assembleSceneFile(scene.identity, countsOf(scene), stored);
  const std::span<const std::uint8_t> head = std::span(file).first(sceneHeadBytes(file));
  const Result<SceneTable> table = readSceneHead(head, file.size());
  ASSERT_TRUE(table) << table.error().message;
  EXPECT_EQ(table->sections.size(), readSceneTable(file)->sections.size());
  for (std::size_t bytes = 0; bytes < head.size(); ++bytes)
    ASSERT_FALSE(readSceneHead(head.first(bytes), file.size())) << bytes;
  EXPECT_FALSE(readSceneHead(head, file.size() + 1));
}

}  // namespace
}  // namespace fiatlux
