// The pipeline in parts makes the file that it makes as a whole, however rows and blocks are split
// (light_part, interreflection).
#include "precompute/pipeline/scene_parts.h"

#include <gtest/gtest.h>

#include "precompute/light/forward_light.h"
#include "precompute/light/light_part.h"
#include "tests/precompute/pipeline/box_model.h"

namespace fiatlux {
namespace {

using testing::boxModel;
using testing::plainHost;

SceneOptions exchangeOptions() {
  SceneOptions options = testing::quickOptions();
  options.transport.exchange = true;
  return options;
}

SceneParts openedBox() {
  auto parts = SceneParts::open(boxModel(), exchangeOptions(), plainHost());
  EXPECT_TRUE(parts) << parts.error().message;
  return std::move(*parts);
}

TEST(SceneParts, AreTheWholeWhoeverCastsThem) {
  const auto whole = makeScene(boxModel(), exchangeOptions(), plainHost());
  ASSERT_TRUE(whole);
  SceneParts first = openedBox(), second = openedBox();
  const std::uint32_t rows = first.room().patches.rows();
  for (std::uint32_t at = 0, turn = 0; at < rows; at += 70, ++turn) {
    const std::uint32_t count = std::min(70u, rows - at);
    const auto part = (turn % 2 == 0 ? first : second).cast(at, count);
    ASSERT_TRUE(part) << part.error().message;
    ASSERT_TRUE(first.add(*part));
    ASSERT_TRUE(second.add(*part));
  }
  const auto blocks = first.prepare();
  ASSERT_TRUE(blocks) << blocks.error().message;
  EXPECT_GT(*blocks, 2u);  // of sites and of groups
  EXPECT_EQ(second.prepare().value(), *blocks);
  for (std::uint32_t block = *blocks; block-- > 0;) {
    const auto part = (block % 2 == 0 ? first : second).solve(block);
    ASSERT_TRUE(part) << part.error().message;
    ASSERT_TRUE(first.join(*part));
  }
  const auto made = first.assemble();
  ASSERT_TRUE(made) << made.error().message;
  EXPECT_EQ(made->file, whole->file);
  EXPECT_EQ(made->report.identity, whole->report.identity);
}

TEST(SceneParts, LightLuminairesAsTheForwardTruthDoes) {
  SceneParts parts = openedBox();
  const Luminaire square = luminaireOf(parts.room().sites[7]);
  EXPECT_EQ(parts.light({square}).error().message, "parts of the light are missing");
  ASSERT_TRUE(parts.add(parts.cast(0, parts.room().patches.rows()).value()));
  for (std::uint32_t block = parts.prepare().value(); block-- > 0;)
    ASSERT_TRUE(parts.join(parts.solve(block).value()));
  ASSERT_TRUE(parts.assemble());

  std::vector<Luminaire> hung(17, square);  // more than are solved together
  for (std::size_t j = 0; j < hung.size(); ++j) {
    hung[j] = luminaireOf(parts.room().sites[j]);
    hung[j].flux = 500 + 100.0 * static_cast<double>(j);
  }
  const auto opened = openRoom(boxModel(), exchangeOptions().room, plainHost());
  ASSERT_TRUE(opened);
  ForwardOptions options;
  options.rays = exchangeOptions().transport.rays;
  for (const std::size_t count : {std::size_t{2}, hung.size()}) {
    const std::vector<Luminaire> some(hung.begin(), hung.begin() + static_cast<std::ptrdiff_t>(count));
    const auto columns = parts.light(some);
    ASSERT_TRUE(columns) << columns.error().message;
    const auto truth = computeForwardLight(opened->room, opened->tracer, some, options);
    ASSERT_TRUE(truth);
    const std::size_t rows = truth->illuminance.size();
    ASSERT_EQ(columns->size(), rows * count);
    for (std::size_t p = 0; p < rows; ++p) {
      double sum = 0;
      for (std::size_t j = 0; j < count; ++j) sum += (*columns)[j * rows + p];
      EXPECT_NEAR(sum, truth->illuminance[p], 1e-4 * truth->illuminance[p]) << p;
    }
  }
}

TEST(SceneParts, WantAllRowsOfOneRoom) {
  SceneParts parts = openedBox();
  const auto part = parts.cast(0, 10);
  ASSERT_TRUE(part);
  ASSERT_TRUE(parts.add(*part));
  EXPECT_EQ(parts.prepare().error().message, "parts of the light are missing");
  EXPECT_EQ(parts.assemble().error().message, "parts of the light are missing");

  std::vector<std::uint8_t> cut(part->begin(), part->end() - 1), elsewhere = *part;
  EXPECT_EQ(parts.add(cut).error().message, "a part of the light is damaged");
  elsewhere[3] = 1;  // the first row: 2^24
  EXPECT_EQ(parts.add(elsewhere).error().message, "a part of the light is of another room");
}

TEST(SceneParts, WantAllBlocksOfOneRoom) {
  SceneParts parts = openedBox();
  ASSERT_TRUE(parts.add(parts.cast(0, parts.room().patches.rows()).value()));
  const std::uint32_t blocks = parts.prepare().value();
  const std::vector<std::uint8_t> first = parts.solve(0).value();
  ASSERT_TRUE(parts.join(first));
  EXPECT_EQ(parts.assemble().error().message, "parts of the light are missing");

  const std::vector<std::uint8_t> cut(first.begin(), first.end() - 1);
  EXPECT_EQ(parts.join(cut).error().message, "a part of the light is damaged");
  for (const std::uint32_t block : {blocks - 1, blocks}) {
    std::vector<std::uint8_t> elsewhere = first;
    elsewhere[0] = static_cast<std::uint8_t>(block);
    EXPECT_EQ(parts.join(elsewhere).error().message, "a part of the light is of another room");
  }
}

TEST(LightPart, ComesBackAsItWas) {
  LightPart part{7,
                 {{{0.25f, 0.5f}, {{3, 0.125f}}, {{1, 5, -6}}, 0.1f}, {{0, 1}, {}, {}, 0}},
                 {1, 2, 3, 4},
                 {5, 6, 7, 8}};
  const auto read = decodeLightPart(encodeLightPart(part), 2, 2, true);
  ASSERT_TRUE(read) << read.error().message;
  EXPECT_EQ(read->first, 7u);
  ASSERT_EQ(read->rows.size(), 2u);
  EXPECT_EQ(read->rows[0].u, part.rows[0].u);
  EXPECT_EQ(read->rows[0].near, part.rows[0].near);
  EXPECT_EQ(read->rows[0].slopes, part.rows[0].slopes);
  EXPECT_EQ(read->rows[0].lost, part.rows[0].lost);
  EXPECT_EQ(read->direct, part.direct);
  EXPECT_EQ(read->visible, part.visible);
  EXPECT_FALSE(decodeLightPart(encodeLightPart(part), 3, 2, true));
  EXPECT_FALSE(decodeLightPart(encodeLightPart(part), 2, 2, false));
  EXPECT_FALSE(decodeLightPart({}, 2, 2, true));
}

TEST(SolvedPart, ComesBackAsItWas) {
  const SolvedPart part{3, {{1, 2}, {0.5}, {{4, 5, 6}, {{7, 8, 9}}}, {10, 11}}};
  const auto read = decodeSolvedPart(encodeSolvedPart(part));
  ASSERT_TRUE(read) << read.error().message;
  EXPECT_EQ(read->block, 3u);
  EXPECT_EQ(read->solved.illuminance, part.solved.illuminance);
  EXPECT_EQ(read->solved.squares, part.solved.squares);
  EXPECT_EQ(read->solved.exchange.means, part.solved.exchange.means);
  ASSERT_EQ(read->solved.exchange.rest.size(), 1u);
  EXPECT_EQ(read->solved.exchange.rest[0].group, 8u);
  EXPECT_EQ(read->solved.surfaces, part.solved.surfaces);
  EXPECT_FALSE(decodeSolvedPart({}));
}

}  // namespace
}  // namespace fiatlux
