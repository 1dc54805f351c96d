// Responses that are decoded as they arrive: the same numbers as at the end, and a broken block is told at
// once.
#include "core/scene/response_sections.h"

#include <gtest/gtest.h>

#include "core/scene/scene_reader.h"
#include "core/scene/scene_sections.h"
#include "tests/core/synthetic_scene.h"

namespace fiatlux {
namespace {

struct Parts {
  std::vector<PlainSection> sections;
  SceneReader reader;
};

/// A reader of the head alone, before anything has been provided.
Parts partsOf(const Scene& scene, std::vector<PlainSection> sections) {
  std::vector<StoredSection> stored;
  for (const PlainSection& part : sections) stored.push_back({part.section, part.bytes});
  const std::vector<std::uint8_t> file = assembleSceneFile(scene.identity, countsOf(scene), stored);
  Result<SceneReader> reader =
      SceneReader::openHead(std::span(file).first(sceneHeadBytes(file)), file.size());
  return {std::move(sections), std::move(reader.value())};
}

void provideEarly(Parts& parts) {
  for (std::uint32_t i = 0; i < parts.sections.size(); ++i) {
    if (!parts.reader.early(i)) continue;
    ASSERT_TRUE(parts.reader.provide(i, parts.sections[i].bytes));
  }
  ASSERT_TRUE(parts.reader.readOutline());
}

TEST(ResponseSections, AreTheSameAsTheyArriveAndAtTheEnd) {
  const Scene scene = syntheticScene(400, 60);
  Parts arriving = partsOf(scene, encodeScene(scene).value());
  Parts whole = partsOf(scene, arriving.sections);
  provideEarly(arriving);
  SceneReader moved = std::move(arriving.reader);
  for (std::uint32_t i = 0; i < arriving.sections.size(); ++i) {
    if (!whole.reader.needed(i)) continue;
    ASSERT_TRUE(whole.reader.provide(i, whole.sections[i].bytes));
    if (moved.early(i)) continue;
    ASSERT_TRUE(moved.provide(i, arriving.sections[i].bytes));
  }
  const Result<Scene> one = moved.finish(), other = whole.reader.finish();
  ASSERT_TRUE(one) << one.error().message;
  ASSERT_TRUE(other) << other.error().message;
  EXPECT_EQ(one->responses.illuminance, other->responses.illuminance);
  for (std::size_t s = 0; s < one->illuminance.size(); ++s)
    EXPECT_EQ(one->illuminance[s].covariance, other->illuminance[s].covariance) << s;
}

TEST(ResponseSections, ABrokenBlockIsToldWhenItComes) {
  const Scene scene = syntheticScene(400, 60);
  std::vector<PlainSection> sections = encodeScene(scene).value();
  for (PlainSection& part : sections) {
    if (part.section.name != "responses") continue;
    part = plainSection(part.section.name, part.section.type, part.section.encoding, part.section.rows + 1,
                        part.section.columns, std::vector<std::uint8_t>(part.bytes.size() + 1, 0xff));
  }
  Parts parts = partsOf(scene, std::move(sections));
  provideEarly(parts);
  std::string fault;
  for (std::uint32_t i = 0; fault.empty() && i < parts.sections.size(); ++i) {
    if (!parts.reader.needed(i) || parts.reader.early(i)) continue;
    const Result<Done> provided = parts.reader.provide(i, parts.sections[i].bytes);
    if (!provided) fault = parts.sections[i].section.name + ": " + provided.error().message;
  }
  EXPECT_NE(fault.find("responses: section responses: a value is out of range"), std::string::npos) << fault;
}

TEST(ResponseSections, WhatWasNotProvidedIsNamed) {
  const Scene scene = syntheticScene(40, 9);
  Parts parts = partsOf(scene, encodeScene(scene).value());
  provideEarly(parts);
  for (std::uint32_t i = 0; i < parts.sections.size(); ++i) {
    const std::string& name = parts.sections[i].section.name;
    if (!parts.reader.needed(i) || parts.reader.early(i) || name == "responses") continue;
    ASSERT_TRUE(parts.reader.provide(i, parts.sections[i].bytes)) << name;
  }
  const Result<Scene> read = parts.reader.finish();
  ASSERT_FALSE(read);
  EXPECT_NE(read.error().message.find("section responses: it was not provided"), std::string::npos)
      << read.error().message;
}

}  // namespace
}  // namespace fiatlux
