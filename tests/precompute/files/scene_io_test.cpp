// Deflated sections: there and back, bombs and lies.
#include "precompute/files/scene_io.h"

#include <gtest/gtest.h>
#include <zlib.h>

#include "core/scene/scene_reader.h"
#include "core/scene/scene_sections.h"
#include "tests/core/synthetic_scene.h"

namespace fiatlux {
namespace {

std::vector<std::uint8_t> fileOf(const Scene& scene) {
  return assembleSceneFile(scene.identity, countsOf(scene),
                           storeSections(encodeScene(scene).value(), zlibDeflate));
}

TEST(SceneIo, DeflatedFileRoundTrips) {
  const Scene scene = syntheticScene(40, 9);
  const Result<Scene> back = readScene(fileOf(scene));
  ASSERT_TRUE(back) << back.error().message;
  EXPECT_EQ(back->patches.cluster, scene.patches.cluster);
  EXPECT_EQ(back->surfaces[1].name, scene.surfaces[1].name);
}

TEST(SceneIo, EveryFlippedByteIsRefused) {
  std::vector<std::uint8_t> file = fileOf(syntheticScene(4, 2));
  for (std::size_t i = 0; i < file.size(); ++i) {
    file[i] ^= 0x10;
    ASSERT_FALSE(readScene(file)) << "byte " << i;
    file[i] ^= 0x10;
  }
}

TEST(SceneIo, VeryEvenSectionsStayWithinTheRatio) {
  // 8 MB of zeros would shrink a thousandfold.
  std::vector<PlainSection> sections;
  sections.push_back(plainSection("zeros", ElementType::kUint8, Encoding::kPlain, 8 << 20, 1,
                                  std::vector<std::uint8_t>(8 << 20)));
  const std::vector<StoredSection> stored = storeSections(sections, zlibDeflate);
  EXPECT_GE(stored[0].bytes.size() * kMaxInflationRatio, std::size_t{8} << 20);
  const Scene scene = syntheticScene(4, 2);
  const std::vector<std::uint8_t> file = assembleSceneFile(scene.identity, countsOf(scene), stored);
  const Result<SceneTable> table = readSceneTable(file);
  ASSERT_TRUE(table) << table.error().message;
  EXPECT_TRUE(inflateSection(file, table->sections[0]));
}

/// A section that says `claimed` bytes and deflates `actual` zeros.
Result<std::vector<std::uint8_t>> inflateLie(std::uint32_t claimed, std::uint32_t actual) {
  const std::vector<std::uint8_t> zeros(actual);
  uLongf size = compressBound(actual);
  std::vector<std::uint8_t> packed(size);
  compress2(packed.data(), &size, zeros.data(), actual, 9);
  packed.resize(size);
  StoredSection section{plainSection("lie", ElementType::kUint8, Encoding::kPlain, claimed, 1,
                                     std::vector<std::uint8_t>(claimed))
                            .section,
                        packed};
  section.section.codec = Codec::kDeflate;
  const Scene scene = syntheticScene(4, 2);
  const std::vector<std::uint8_t> file = assembleSceneFile(scene.identity, countsOf(scene), {section});
  const Result<SceneTable> table = readSceneTable(file);
  if (!table) return table.error();
  return inflateSection(file, table->sections[0]);
}

TEST(SceneIo, InflatesToExactlyTheDeclaredSize) {
  EXPECT_TRUE(inflateLie(1000, 1000));
  EXPECT_FALSE(inflateLie(1000, 1001));
  EXPECT_FALSE(inflateLie(1000, 999));
  // A bomb: little that would become 200 MB, said to be 1 MB.
  EXPECT_FALSE(inflateLie(1 << 20, 200 << 20));
  // The same, admitted: refused by its table before a byte is inflated.
  const auto admitted = inflateLie(60 << 20, 60 << 20);
  ASSERT_FALSE(admitted);
  EXPECT_NE(admitted.error().message.find("200 times"), std::string::npos);
}

}  // namespace
}  // namespace fiatlux
