// Hostile bytes at the scene file reader, then at everything that relies on what it let pass. Sections are
// taken out, changed as the numbers that they hold, and the file is put together again with its table and
// checksums right, as a forger would: random bytes alone would never come past a checksum.
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <optional>
#include <vector>

#include "core/base/random.h"
#include "core/scene/scene_file.h"
#include "core/scene/section_codec.h"
#include "core/session/session.h"
#include "core/transport/photometric_light.h"
#include "precompute/files/scene_io.h"
#include "tests/fuzz/one_line.h"

extern "C" std::size_t LLVMFuzzerMutate(std::uint8_t* data, std::size_t size, std::size_t largest);

namespace {

using Bytes = std::vector<std::uint8_t>;
using fiatlux::ElementType;
using fiatlux::Encoding;
using fiatlux::Random;

struct Parts {
  std::string identity;
  fiatlux::SceneCounts counts;
  std::vector<fiatlux::PlainSection> sections;
};

/// A sound file taken apart, every section inflated.
std::optional<Parts> partsOf(const Bytes& file) {
  const fiatlux::Result<fiatlux::SceneTable> table = fiatlux::readSceneTable(file);
  if (!table) return {};
  Parts parts{table->identity, table->counts, {}};
  for (const fiatlux::SceneSection& section : table->sections) {
    fiatlux::Result<Bytes> bytes = fiatlux::inflateSection(file, section);
    if (!bytes) return {};
    parts.sections.push_back({section, std::move(*bytes)});
  }
  return parts;
}

/// With sizes and checksums that fit the bytes; rows follow the number of bytes.
Bytes fileOf(Parts parts, bool deflate) {
  std::vector<fiatlux::StoredSection> stored;
  std::vector<fiatlux::PlainSection> plain;
  for (fiatlux::PlainSection& part : parts.sections) {
    const fiatlux::SceneSection& s = part.section;
    const std::size_t row = std::size_t{sizeOf(s.type)} * std::max(1u, s.columns);
    part.bytes.resize(part.bytes.size() / row * row);
    plain.push_back(fiatlux::plainSection(s.name, s.type, s.encoding,
                                          static_cast<std::uint32_t>(part.bytes.size() / row),
                                          std::max(1u, s.columns), std::move(part.bytes), s.errorBound));
  }
  if (deflate)
    return assembleSceneFile(parts.identity, parts.counts,
                             fiatlux::storeSections(plain, fiatlux::zlibDeflate));
  for (fiatlux::PlainSection& part : plain) stored.push_back({part.section, std::move(part.bytes)});
  return assembleSceneFile(parts.identity, parts.counts, stored);
}

template <class T>
T extremeOf(Random& random, std::initializer_list<T> values) {
  return *(values.begin() + random.below(static_cast<std::uint32_t>(values.size())));
}

std::uint32_t bitsOf(float value) {
  std::uint32_t bits;
  std::memcpy(&bits, &value, 4);
  return bits;
}

/// One number of a section becomes another, in the section's own code.
void changeNumber(fiatlux::PlainSection& part, Random& random) {
  const float anyFloat = extremeOf<float>(
      random, {0, -0.0f, 1, -1, 0.5f, 2, 1e-30f, 1e12f, 1e30f, 3e38f, NAN, INFINITY, -INFINITY, 1e-45f});
  const auto anyWord = extremeOf<std::uint32_t>(random, {0, 1, 2, 3, 7, 255, 65536, 1u << 24, 1u << 31, ~0u});
  const std::size_t count = part.bytes.size() / sizeOf(part.section.type);
  if (count == 0) return;
  const std::size_t at = random.below(static_cast<std::uint32_t>(count));
  if (part.section.type == ElementType::kFloat64) {
    const double value = anyFloat;
    std::memcpy(&part.bytes[8 * at], &value, 8);
  } else if (part.section.encoding == Encoding::kDeltaPlanes) {
    const std::uint32_t columns = std::max(1u, part.section.columns);
    std::vector<std::uint32_t> values = fiatlux::decodeDeltaPlanes(part.bytes, columns);
    if (values.empty()) return;
    std::uint32_t& value = values[at % values.size()];
    value = random.below(2) ? anyWord : value + extremeOf<std::uint32_t>(random, {1, ~0u, 2, ~1u});
    part.bytes = fiatlux::encodeDeltaPlanes(values, columns);
  } else if (part.section.encoding == Encoding::kPacked) {
    std::vector<std::uint32_t> values = fiatlux::decodePlanes(part.bytes);
    if (values.empty()) return;
    values[at % values.size()] = random.below(2) ? anyWord : bitsOf(anyFloat);
    part.bytes = fiatlux::encodePlanes(values);
  } else if (part.section.type == ElementType::kFloat32) {
    std::vector<float> values = fiatlux::decodeFloatPlanes(part.bytes);
    values[at] = anyFloat;
    part.bytes = fiatlux::encodeFloatPlanes(values);
  } else if (part.section.encoding == Encoding::kResponses && part.bytes.size() >= 4 && random.below(2)) {
    const std::uint32_t length = anyWord;  // of a stream
    std::memcpy(&part.bytes[at / 4 * 4 % std::min<std::size_t>(192, part.bytes.size() - 3)], &length, 4);
  } else {
    part.bytes[at] = static_cast<std::uint8_t>(random.next());
  }
}

void changeLine(fiatlux::SceneSection& line, Random& random) {
  switch (random.below(5)) {
    case 0:
      line.type = static_cast<ElementType>(random.below(4));
      return;
    case 1:
      line.encoding = static_cast<Encoding>(random.below(8));
      return;
    case 2:
      line.columns = extremeOf<std::uint32_t>(random, {1, 2, 3, 4, line.columns + 1, 2 * line.columns});
      return;
    case 3:
      line.errorBound = extremeOf<float>(random, {0, 1, 1e30f, NAN, -1});
      return;
    default:
      line.name += random.below(2) ? ".1" : "x";
      if (line.name.size() > 31) line.name = "x";
  }
}

void mutate(Parts& parts, Random& random) {
  fiatlux::PlainSection& part =
      parts.sections[random.below(static_cast<std::uint32_t>(parts.sections.size()))];
  const std::uint32_t way = random.below(20);
  if (way < 11) return changeNumber(part, random);
  if (way < 14) {
    const std::size_t size = part.bytes.size();
    part.bytes.resize(size + 64);
    part.bytes.resize(LLVMFuzzerMutate(part.bytes.data(), size, part.bytes.size()));
  } else if (way < 16) {
    std::uint32_t* counts[] = {&parts.counts.patches, &parts.counts.receivers, &parts.counts.clusters,
                               &parts.counts.sites,   &parts.counts.columns,   &parts.counts.surfaces};
    std::uint32_t& count = *counts[random.below(6)];
    count =
        extremeOf<std::uint32_t>(random, {0, 1, 2, count + 1, count - 1, 2 * count, 1u << 14, 1u << 21, ~0u});
  } else if (way < 18) {
    changeLine(part.section, random);
  } else if (way < 19 && parts.sections.size() > 1) {
    std::swap(part, parts.sections[random.below(static_cast<std::uint32_t>(parts.sections.size()))]);
  } else {
    parts.sections.erase(parts.sections.begin() + (&part - parts.sections.data()));
  }
}

void require(bool good, const char* what) {
  if (good) return;
  std::fprintf(stderr, "a scene file that was let in %s\n", what);
  std::abort();
}

/// What a page does with a room, on what the reader believed.
void use(fiatlux::Scene scene) {
  for (const float light : scene.responses.illuminance)
    require(light >= 0 && std::isfinite(light), "has wrong light");
  if (scene.lightOperator) {
    const std::vector<float> even(scene.patches.rows(), 1.0f);
    const fiatlux::ExchangeOperator exchange(scene.patches, scene.lightOperator->groups,
                                             scene.lightOperator->exchange);
    require(exchange.indirect(even, 1).size() == even.size(), "exchanges no light");
    (void)fiatlux::PhotometricLight(scene).direct({{0, fiatlux::lambertianOn(scene.sites[0])}});
  }
  fiatlux::Session session;
  session.adopt(std::move(scene));
  fiatlux::Intentions intentions;
  intentions.luminaires.count =
      std::min<std::uint32_t>(2, static_cast<std::uint32_t>(session.scene()->sites.size()));
  intentions.goals = {{fiatlux::Statistic::kSigma, fiatlux::Sense::kMinimize, 1, {}, {}}};
  intentions.constraints = {{fiatlux::Statistic::kMinimum, 1, fiatlux::kUnbounded, 1, {0}, {}}};
  require(bool(session.setIntentions(intentions)) && bool(session.start(1, nullptr)), "cannot be searched");
  (void)session.advance(50);
  const auto shown = session.incumbent();
  require(bool(shown), "shows nothing");
  for (const fiatlux::SurfaceReading& r : shown->surfaces)
    require(std::isfinite(r.mean) && std::isfinite(r.sigma) && std::isfinite(r.minimum) &&
                std::isfinite(r.maximum),
            "has light that is no number");
}

}  // namespace

extern "C" std::size_t LLVMFuzzerCustomMutator(std::uint8_t* data, std::size_t size, std::size_t largest,
                                               unsigned seed) {
  Random random(seed);
  std::optional<Parts> parts;
  if (random.below(10) > 0) parts = partsOf(Bytes(data, data + size));
  if (!parts || parts->sections.empty()) return LLVMFuzzerMutate(data, size, largest);
  for (std::uint32_t i = 0; i <= random.below(3) && !parts->sections.empty(); ++i) mutate(*parts, random);
  const Bytes file = fileOf(std::move(*parts), random.below(4) == 0);
  if (file.size() > largest) return LLVMFuzzerMutate(data, size, largest);
  std::memcpy(data, file.data(), file.size());
  return file.size();
}

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  fiatlux::Result<fiatlux::Scene> scene = fiatlux::readScene(Bytes(data, data + size));
  if (!scene) return fiatlux::fuzz::requireOneLine(scene.error().message), 0;
  use(std::move(*scene));
  return 0;
}
