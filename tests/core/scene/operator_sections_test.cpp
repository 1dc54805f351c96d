// A light operator (light_operator) in a file, and its numbers in bytes (exchange_codec,
// surface_exchange_codec, visibility_codec; older_operator_codec): there and back, absent in older files, and
// refused where it lies.
#include "core/scene/operator_sections.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "core/scene/exchange_codec.h"
#include "core/scene/older_operator_codec.h"
#include "core/scene/scene_reader.h"
#include "core/scene/scene_sections.h"
#include "core/scene/surface_exchange_codec.h"
#include "core/scene/visibility_codec.h"
#include "tests/core/operator_scene.h"
#include "tests/core/scene/base64.h"
#include "tests/core/scene/golden_operator_v8.h"

namespace fiatlux {
namespace {

using ::testing::HasSubstr;

Result<Scene> readBack(const Scene& scene, const std::vector<PlainSection>& plain, bool withOperator = true) {
  std::vector<StoredSection> sections;
  for (const PlainSection& part : plain) sections.push_back({part.section, part.bytes});
  const std::vector<std::uint8_t> file = assembleSceneFile(scene.identity, countsOf(scene), sections);
  Result<SceneReader> reader = SceneReader::open(file);
  if (!reader) return reader.error();
  for (std::uint32_t i = 0; i < plain.size(); ++i) {
    if (!reader->needed(i) && !(withOperator && reader->ofOperator(i))) continue;
    const Result<Done> provided = reader->provide(i, plain[i].bytes);
    if (!provided) return provided.error();
  }
  return reader->finish();
}

/// What reading says once `change` has had its way with the bytes of one section.
template <class Change>
std::string errorWith(const std::string& name, Change change) {
  const Scene scene = operatorScene(8, 3);
  std::vector<PlainSection> plain = encodeScene(scene).value();
  for (PlainSection& part : plain) {
    if (part.section.name != name) continue;
    change(part.bytes);
    const SceneSection s = part.section;
    const auto rows = static_cast<std::uint32_t>(part.bytes.size() / sizeOf(s.type) / s.columns);
    part = plainSection(s.name, s.type, s.encoding, rows, s.columns, std::move(part.bytes));
  }
  const Result<Scene> back = readBack(scene, plain);
  return back ? "no error" : back.error().message;
}

TEST(OperatorSections, ComeBackWithinTheirSteps) {
  const Scene scene = operatorScene(8, 3);
  const Result<Scene> back = readBack(scene, encodeScene(scene).value());
  ASSERT_TRUE(back) << back.error().message;
  ASSERT_TRUE(back->lightOperator);
  const LightOperator &in = *scene.lightOperator, &out = *back->lightOperator;
  EXPECT_EQ(out.visibility.steps.size(), in.visibility.steps.size());
  EXPECT_EQ(out.charts.ofRow, in.charts.ofRow);
  EXPECT_EQ(out.groups.ofRow, in.groups.ofRow);
  EXPECT_EQ(out.groups.barriers, in.groups.barriers);
  EXPECT_EQ(out.groups.count, in.groups.count);
  EXPECT_EQ(out.groups.total, in.groups.total);
  ASSERT_EQ(out.charts.frames.size(), in.charts.frames.size());
  EXPECT_DOUBLE_EQ(out.charts.frames[1].cellU, 0.25);
  EXPECT_EQ(out.exchange.offset, in.exchange.offset);
  EXPECT_EQ(out.exchange.group, in.exchange.group);

  const std::vector<double> area = areasOf(scene.patches, in.groups);
  ASSERT_EQ(out.exchange.means.size(), in.exchange.means.size());
  for (std::uint32_t c = 0; c < in.groups.total; ++c)
    for (std::uint32_t d = 0; d < in.groups.count; ++d) {
      const std::size_t at = std::size_t{c} * in.groups.count + d;
      const double unit = std::sqrt(area[c] * area[d]);
      EXPECT_NEAR(std::sqrt(out.exchange.means[at] * unit), std::sqrt(in.exchange.means[at] * unit),
                  0.501 * kExchangeMeanStep);
    }
  for (std::uint32_t p = 0; p < scene.patches.rows(); ++p)
    for (std::uint32_t i = in.exchange.offset[p]; i < in.exchange.offset[p + 1]; ++i)
      EXPECT_NEAR(out.exchange.rest[i], in.exchange.rest[i],
                  0.501 * kExchangeRestStep / std::sqrt(scene.patches.area[p] * area[in.exchange.group[i]]));
}

TEST(OperatorSections, ChartsKeepTwelveBitsWhateverTheirSize) {
  Scene scene = operatorScene(8, 3);
  const double c = std::cos(0.3), s = std::sin(0.3);
  const Charts::Frame tilted{{c, s, 0}, {-s * s, c * s, c}, 0.1234567, 33.333333};
  const Charts::Frame noise{{c + 1e-7, s, -0.0}, {-s * s, c * s, c}, 0.1234567 + 1e-8, 33.333333 - 1e-6};
  std::vector<Charts::Frame>& frames = scene.lightOperator->charts.frames;
  frames[1] = tilted, frames[2] = noise;
  const Result<Scene> back = readBack(scene, encodeScene(scene).value());
  ASSERT_TRUE(back) << back.error().message;
  const Charts::Frame &read = back->lightOperator->charts.frames[1],
                      &alike = back->lightOperator->charts.frames[2];
  EXPECT_LT(length(read.uAxis - tilted.uAxis), 3e-4);
  EXPECT_LT(length(read.vAxis - tilted.vAxis), 3e-4);
  EXPECT_NEAR(read.cellU / tilted.cellU, 1, 1.0 / 4096);
  EXPECT_NEAR(read.cellV / tilted.cellV, 1, 1.0 / 4096);
  EXPECT_EQ(length(read.uAxis - alike.uAxis), 0) << "noise of the vertices is gone";
  EXPECT_EQ(read.cellU, alike.cellU);
  EXPECT_EQ(read.cellV, alike.cellV);
}

TEST(OperatorSections, EncodingWhatWasDecodedChangesNothing) {
  const Scene scene = operatorScene(8, 3);
  const Result<Scene> once = readBack(scene, encodeScene(scene).value());
  ASSERT_TRUE(once);
  const Patches& patches = once->patches;
  const LightOperator& op = *once->lightOperator;
  LightOperator again = op;
  const auto means = encodeExchangeMeans(patches, op.groups, op.exchange);
  const auto rest = encodeExchangeRest(patches, op.groups, op.exchange);
  ASSERT_EQ(decodeExchangeMeans(means, patches, op.groups, again.exchange), "");
  ASSERT_EQ(decodeExchangeRest(rest, patches, op.groups, again.exchange), "");
  EXPECT_EQ(again.exchange.means, op.exchange.means);
  EXPECT_EQ(again.exchange.rest, op.exchange.rest);
}

/// With shapes of patches and means over surfaces, which older files do not have.
Scene newerScene() {
  Scene scene = operatorScene(8, 3);
  LightOperator& op = *scene.lightOperator;
  const auto surfaces = static_cast<std::uint32_t>(scene.surfaces.size());
  for (std::uint32_t p = 0; p < scene.patches.rows(); ++p)
    op.charts.aspect.push_back(static_cast<std::int8_t>(p % 9 == 0 ? static_cast<int>(p % 255) - 127 : 0));
  op.surfaces.surfaces = surfaces;
  for (std::uint32_t p = 0; p < scene.patches.count; ++p)
    for (std::uint32_t s = 0; s < surfaces; ++s)
      op.surfaces.means.push_back(
          (p + s) % 50 == 0 ? 0.0f : static_cast<float>(0.01 * (s + 1) * std::exp(std::sin(0.3 * p))));
  return scene;
}

TEST(OperatorSections, ShapesAndMeansOverSurfacesComeBack) {
  const Scene scene = newerScene();
  const Result<Scene> back = readBack(scene, encodeScene(scene).value());
  ASSERT_TRUE(back) << back.error().message;
  const LightOperator &in = *scene.lightOperator, &out = *back->lightOperator;
  EXPECT_EQ(out.charts.aspect, in.charts.aspect);
  EXPECT_EQ(out.surfaces.surfaces, in.surfaces.surfaces);
  ASSERT_EQ(out.surfaces.means.size(), in.surfaces.means.size());
  for (std::size_t i = 0; i < in.surfaces.means.size(); ++i) {
    if (in.surfaces.means[i] == 0)
      EXPECT_EQ(out.surfaces.means[i], 0);
    else
      EXPECT_NEAR(std::log(out.surfaces.means[i] / in.surfaces.means[i]), 0, 0.51 * 3 * kSurfaceExchangeStep);
  }
  // Coded again they are the same.
  SurfaceExchange again{out.surfaces.surfaces, {}};
  ASSERT_EQ(decodeSurfaceExchange(encodeSurfaceExchange(scene.patches, out.surfaces), scene.patches, again),
            "");
  for (std::size_t i = 0; i < again.means.size(); ++i)
    EXPECT_NEAR(again.means[i], out.surfaces.means[i], 1e-6f * out.surfaces.means[i]);
}

/// Sections of the newer scene as files of method 8 have them.
std::vector<PlainSection> olderSections() {
  std::vector<PlainSection> plain = encodeScene(newerScene()).value();
  const auto put = [&](const char* name, const char* base64, Encoding encoding, double step) {
    for (PlainSection& part : plain) {
      if (part.section.name != name) continue;
      const std::vector<std::uint8_t> bytes = fromBase64(base64);
      const auto length = static_cast<std::uint32_t>(bytes.size());
      part = plainSection(name, ElementType::kUint8, encoding, length, 1, bytes, static_cast<float>(step));
    }
  };
  put("siteVisibility", kOlderVisibility, Encoding::kPlain, 0);
  put("exchange", kOlderExchange, Encoding::kStepped, 2.5e-3f);
  put("exchangeRest", kOlderRest, Encoding::kStepped, 3e-3f);
  put("surfaceExchange", kOlderSurfaceExchange, Encoding::kStepped, 0.03f);
  return plain;
}

TEST(OperatorSections, FilesOfMethod8AreReadAsEver) {
  const Scene scene = newerScene();
  const Result<Scene> back = readBack(scene, olderSections());
  ASSERT_TRUE(back) << back.error().message;
  const LightOperator &in = *scene.lightOperator, &out = *back->lightOperator;
  EXPECT_EQ(out.visibility.steps, in.visibility.steps);
  const std::vector<double> area = areasOf(scene.patches, in.groups);
  for (std::uint32_t c = 0; c < in.groups.total; ++c)
    for (std::uint32_t d = 0; d < in.groups.count; ++d) {
      const std::size_t at = std::size_t{c} * in.groups.count + d;
      const double unit = std::sqrt(area[c] * area[d]);
      EXPECT_NEAR(std::sqrt(out.exchange.means[at] * unit), std::sqrt(in.exchange.means[at] * unit),
                  0.501 * 2.5e-3);
    }
  ASSERT_EQ(out.exchange.group, in.exchange.group);
  for (std::uint32_t p = 0; p < scene.patches.rows(); ++p)
    for (std::uint32_t i = in.exchange.offset[p]; i < in.exchange.offset[p + 1]; ++i)
      EXPECT_NEAR(out.exchange.rest[i], in.exchange.rest[i],
                  0.501 * 3e-3 / std::sqrt(scene.patches.area[p] * area[in.exchange.group[i]]));
  ASSERT_EQ(out.surfaces.means.size(), in.surfaces.means.size());
  for (std::size_t i = 0; i < in.surfaces.means.size(); ++i)
    EXPECT_NEAR(out.surfaces.means[i], in.surfaces.means[i], 0.05 * in.surfaces.means[i]);
}

TEST(OperatorSections, TheOldestFilesCountTheirExchangeInTheirOwnSteps) {
  std::vector<PlainSection> plain = olderSections();
  const Scene newer = readBack(newerScene(), plain).value();
  std::erase_if(plain, [](const PlainSection& part) {
    return part.section.name == "chartAspects" || part.section.name == "surfaceExchange";
  });
  for (PlainSection& part : plain)
    if (part.section.name.starts_with("exchange"))
      part.section.encoding = Encoding::kPlain, part.section.errorBound = 0;
  const Result<Scene> back = readBack(newerScene(), plain);
  ASSERT_TRUE(back) << back.error().message;
  const LightOperator &old = *back->lightOperator, &now = *newer.lightOperator;
  EXPECT_TRUE(old.charts.aspect.empty());
  EXPECT_EQ(old.surfaces.surfaces, 0u);
  const double means = std::pow(kOldestExchangeStep / 2.5e-3, 2), rest = kOldestExchangeStep / 3e-3;
  for (std::size_t i = 0; i < now.exchange.means.size(); ++i)
    EXPECT_NEAR(old.exchange.means[i], means * now.exchange.means[i], 1e-6 * now.exchange.means[i]);
  ASSERT_EQ(old.exchange.rest.size(), now.exchange.rest.size());
  for (std::size_t i = 0; i < now.exchange.rest.size(); ++i)
    EXPECT_NEAR(old.exchange.rest[i], rest * now.exchange.rest[i], 1e-6 * std::abs(now.exchange.rest[i]));
}

TEST(OperatorSections, SharesInAnyStepsComeBackWithinHalfOfOne) {
  const Scene scene = operatorScene(8, 6);
  const SiteVisibility& in = scene.lightOperator->visibility;
  const auto bytes = encodeVisibility(scene.patches, scene.sites, in, 0, in.sites);
  SiteVisibility out = in, again = in;
  ASSERT_EQ(decodeVisibility(bytes, scene.patches, scene.sites, 0, in.sites, out), "");
  const double half = 0.5 * SiteVisibility::kSteps / kStoredShares + 0.5;
  for (std::size_t i = 0; i < in.steps.size(); ++i) EXPECT_NEAR(out.steps[i], in.steps[i], half);
  // Coded again they are the same; blocks of sites know nothing of one another.
  EXPECT_EQ(encodeVisibility(scene.patches, scene.sites, out, 0, in.sites), bytes);
  for (const std::uint32_t first : {0u, 3u})
    ASSERT_EQ(decodeVisibility(encodeVisibility(scene.patches, scene.sites, in, first, first + 3),
                               scene.patches, scene.sites, first, first + 3, again),
              "");
  EXPECT_EQ(again.steps, out.steps);
}

TEST(OperatorSections, RestsOfAnyKindComeBack) {
  Scene scene = operatorScene(8, 3);
  LightOperator& op = *scene.lightOperator;
  std::mt19937 random(7);
  const std::vector<double> area = areasOf(scene.patches, op.groups);
  op.exchange.offset.assign(1, 0), op.exchange.group.clear(), op.exchange.rest.clear();
  for (std::uint32_t p = 0; p < scene.patches.rows(); ++p) {
    for (std::uint32_t d = 0; d < op.groups.count; ++d) {
      if (random() % (p % 7 + 1) != 0) continue;
      const double unit = std::sqrt(scene.patches.area[p] * area[d]);
      const int number = static_cast<int>(random() % (p % 11 == 0 ? 2000 : 3)) + 1;
      op.exchange.group.push_back(d);
      op.exchange.rest.push_back(
          static_cast<float>((random() % 2 ? 1 : -1) * number * kExchangeRestStep / unit));
    }
    op.exchange.offset.push_back(static_cast<std::uint32_t>(op.exchange.group.size()));
  }
  Exchange back;
  ASSERT_EQ(decodeExchangeRest(encodeExchangeRest(scene.patches, op.groups, op.exchange), scene.patches,
                               op.groups, back),
            "");
  EXPECT_EQ(back.offset, op.exchange.offset);
  EXPECT_EQ(back.group, op.exchange.group);
  for (std::size_t i = 0; i < back.rest.size(); ++i)
    EXPECT_NEAR(back.rest[i], op.exchange.rest[i], 1e-5 * std::abs(op.exchange.rest[i]));
}

TEST(OperatorSections, RefusesStepsOfNoSize) {
  const Scene scene = newerScene();
  for (const char* name : {"siteVisibility", "exchange", "exchangeRest", "surfaceExchange"}) {
    std::vector<PlainSection> plain = encodeScene(scene).value();
    for (PlainSection& part : plain)
      if (part.section.name == name) part.section.errorBound = 0;
    const Result<Scene> back = readBack(scene, plain);
    ASSERT_FALSE(back) << name;
    EXPECT_THAT(back.error().message, HasSubstr(std::string(name) + ": it has no steps"));
  }
}

TEST(OperatorSections, MayComeBeforeTheResponsesAndStatisticsBehindAll) {
  const Scene scene = operatorScene(8, 3);
  const std::vector<PlainSection> usual = encodeScene(scene).value();
  std::vector<PlainSection> plain = usual;
  putOperatorFirst(plain);
  EXPECT_EQ(plain.size(), usual.size());
  std::vector<StoredSection> sections;
  for (const PlainSection& part : plain) sections.push_back({part.section, part.bytes});
  const std::vector<std::uint8_t> file = assembleSceneFile(scene.identity, countsOf(scene), sections);
  Result<SceneReader> opened =
      SceneReader::openHead(std::span(file).first(sceneHeadBytes(file)), file.size());
  ASSERT_TRUE(opened) << opened.error().message;
  SceneReader& reader = *opened;
  const auto give = [&](auto wanted) {
    for (std::uint32_t i = 0; i < plain.size(); ++i) {
      if (!wanted(i)) continue;
      EXPECT_TRUE(reader.provide(i, plain[i].bytes)) << plain[i].section.name;
    }
  };
  const auto before = [&](std::uint32_t i) { return !reader.early(i) && !reader.ofStatistics(i); };
  give([&](std::uint32_t i) { return reader.early(i); });
  ASSERT_TRUE(reader.readOutline());
  // As they come: the operator, then the responses.
  std::uint32_t lastOfOperator = 0, firstOfOthers = static_cast<std::uint32_t>(plain.size());
  for (std::uint32_t i = 0; i < plain.size(); ++i) {
    if (reader.ofOperator(i)) lastOfOperator = i;
    if (before(i) && !reader.ofOperator(i)) firstOfOthers = std::min(firstOfOthers, i);
  }
  EXPECT_LT(lastOfOperator, firstOfOthers);
  give(before);
  Result<std::unique_ptr<Scene>> made = reader.finishLight();
  ASSERT_TRUE(made) << made.error().message;
  Scene* light = made->get();
  EXPECT_TRUE(light->illuminance.empty());
  const Scene all = readBack(scene, usual).value();
  EXPECT_EQ(light->responses.illuminance, all.responses.illuminance);
  EXPECT_EQ(light->lightOperator->visibility.steps, all.lightOperator->visibility.steps);
  EXPECT_EQ(light->lightOperator->exchange.means, all.lightOperator->exchange.means);
  give([&](std::uint32_t i) { return reader.ofStatistics(i); });
  ASSERT_TRUE(reader.finishStatistics(*light));
  ASSERT_EQ(light->illuminance.size(), all.illuminance.size());
  for (std::size_t s = 0; s < all.illuminance.size(); ++s) {
    EXPECT_EQ(light->illuminance[s].mean, all.illuminance[s].mean);
    EXPECT_EQ(light->illuminance[s].covariance, all.illuminance[s].covariance);
    EXPECT_EQ(light->exitance[s].covariance, all.exitance[s].covariance);
  }
}

TEST(OperatorSections, OlderFilesHaveNone) {
  const Scene scene = syntheticScene(4, 2);
  const Result<Scene> back = readBack(scene, encodeScene(scene).value());
  ASSERT_TRUE(back) << back.error().message;
  EXPECT_FALSE(back->lightOperator);
}

TEST(OperatorSections, ArePassedOverWhereNobodyWantsThem) {
  const Scene scene = operatorScene(8, 3);
  const Result<Scene> back = readBack(scene, encodeScene(scene).value(), false);
  ASSERT_TRUE(back) << back.error().message;
  EXPECT_FALSE(back->lightOperator);
  EXPECT_EQ(back->responses.sites, 3u);
}

TEST(OperatorSections, AllOrNothing) {
  const Scene scene = operatorScene(8, 3);
  for (const char* name : {"siteVisibility", "charts", "chartFrames", "groups", "exchange", "exchangeRest"}) {
    std::vector<PlainSection> plain = encodeScene(scene).value();
    std::erase_if(plain, [&](const PlainSection& part) { return part.section.name == name; });
    const Result<Scene> back = readBack(scene, plain);
    ASSERT_FALSE(back) << name;
    EXPECT_NE(back.error().message.find(std::string(name) + ": it is missing"), std::string::npos)
        << back.error().message;
  }
}

TEST(OperatorSections, RefusesWhatDoesNotFit) {
  using Bytes = std::vector<std::uint8_t>;
  const auto cut = [](Bytes& bytes) { bytes.pop_back(); };
  const auto longer = [](Bytes& bytes) { bytes.push_back(1); };
  for (const char* name : {"siteVisibility", "exchange", "exchangeRest"}) {
    EXPECT_NE(errorWith(name, cut), "no error") << name;
    EXPECT_NE(errorWith(name, longer), "no error") << name;
    EXPECT_NE(errorWith(name, [](Bytes& bytes) { bytes.clear(); }), "no error") << name;
  }
}

TEST(OperatorSections, WhateverIsDecodedIsInRange) {
  Scene scene = operatorScene(8, 3);
  LightOperator& op = *scene.lightOperator;
  std::mt19937 random(5);
  int refused = 0;
  for (int trial = 0; trial < 200; ++trial) {
    std::vector<std::uint8_t> bytes(trial % 40);
    for (std::uint8_t& byte : bytes) byte = static_cast<std::uint8_t>(random());
    refused +=
        !decodeVisibility(bytes, scene.patches, scene.sites, 0, op.visibility.sites, op.visibility).empty();
    for (const std::uint8_t step : op.visibility.steps) ASSERT_LE(step, SiteVisibility::kSteps);
    refused += !decodeExchangeMeans(bytes, scene.patches, op.groups, op.exchange).empty();
    for (const float mean : op.exchange.means) ASSERT_TRUE(mean >= 0 && std::isfinite(mean));
    decodeExchangeRest(bytes, scene.patches, op.groups, op.exchange);
    for (const float rest : op.exchange.rest) ASSERT_TRUE(std::isfinite(rest));
    SurfaceExchange surfaces{2, {}};
    refused += !decodeSurfaceExchange(bytes, scene.patches, surfaces).empty();
    for (const float mean : surfaces.means) ASSERT_TRUE(mean >= 0 && std::isfinite(mean));
  }
  EXPECT_GT(refused, 300);
}

TEST(OperatorSections, RefusesLabelsOfNothing) {
  const auto labels = [](const char* name, std::uint32_t columns, std::size_t at, std::uint32_t value) {
    return errorWith(name, [=](std::vector<std::uint8_t>& bytes) {
      std::vector<std::uint32_t> values = decodeDeltaPlanes(bytes, columns);
      values[at] = value;
      bytes = encodeDeltaPlanes(values, columns);
    });
  };
  EXPECT_THAT(labels("charts", 1, 5, 3), HasSubstr("a chart that is not there"));
  EXPECT_THAT(labels("groups", 2, 0, 1u << 30), HasSubstr("out of range"));
  EXPECT_THAT(labels("groups", 2, 1, 4), HasSubstr("out of range"));
  EXPECT_THAT(labels("groups", 2, 0, 100), HasSubstr("a receiver is in a group of patches"));
  EXPECT_THAT(labels("groups", 2, 350, 100), HasSubstr("a group is empty"));  // of the last row
}

}  // namespace
}  // namespace fiatlux
