// The native half of the test that a search takes the same path natively and as Wasm, bit by bit:
//   session_trajectory write FILE           a small made-up scene as a .flux file, its sections deflated
//   session_trajectory write-operator FILE  the same with a light operator
//   session_trajectory write-operator-first FILE  that before the responses
//   session_trajectory run FILE SEED LUX    searches of the wishes below; one JSON line an incumbent
// tests/wasm/trajectory.test.ts asks the same of the Wasm module.
#include <cinttypes>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <utility>
#include <vector>

#include "core/scene/opening_light.h"
#include "core/scene/scene_sections.h"
#include "tests/core/operator_scene.h"
#include "tests/wasm/open_file.h"

namespace fiatlux {
namespace {

using Bytes = std::vector<std::uint8_t>;

StoredSection deflated(PlainSection plain) {
  uLongf size = compressBound(plain.bytes.size());
  StoredSection stored{plain.section, Bytes(size)};
  if (compress2(stored.bytes.data(), &size, plain.bytes.data(), plain.bytes.size(), 9) != Z_OK)
    fail("deflate");
  stored.bytes.resize(size);
  stored.section.codec = Codec::kDeflate;
  return stored;
}

PlainSection textSection(const char* name, const char* text) {
  const auto size = static_cast<std::uint32_t>(std::strlen(text));
  return plainSection(name, ElementType::kUint8, Encoding::kPlain, 1, size, Bytes(text, text + size));
}

void write(const char* path, bool withOperator, bool operatorFirst) {
  const Scene scene = withOperator ? operatorScene(64, 40) : syntheticScene(64, 40);
  auto sections = encodeScene(scene);
  if (!sections) fail(sections.error().message);
  if (operatorFirst) putOperatorFirst(*sections);
  const Layout layout{{3, 17}, {1000, 2000}, 0.5};
  std::vector<PlainSection> early = encodeOpening(scene.patches, 3, {layout, illuminanceOf(scene, layout)});
  early.push_back(textSection("room", "glTF stands here"));
  early.push_back(textSection("provenance", "{\"rays\": 1024}"));
  insertEarly(*sections, std::move(early));
  std::vector<StoredSection> stored;
  for (PlainSection& section : *sections) stored.push_back(deflated(std::move(section)));
  const Bytes file = assembleSceneFile(scene.identity, countsOf(scene), stored);
  std::ofstream(path, std::ios::binary).write(reinterpret_cast<const char*>(file.data()), file.size());
}

/// The wishes of trajectory.test.ts: even light everywhere; much light on the first surface while the second
/// stays within bounds; little power with a true minimum and a common dimming, on luminaires apart from each
/// other.
std::vector<Intentions> wishes(double lux) {
  Intentions even, bright, thrifty;
  even.luminaires = {4, 0, {1000}, 1, 1, {}, {}, 0, {}};
  even.goals = {{Statistic::kSigma, Sense::kMinimize, 1, {}, {}}};
  bright.luminaires = {5, 0, {800}, 1, 1, {3}, {0, 1}, 0, {}};
  bright.goals = {{Statistic::kMean, Sense::kMaximize, 1, {0}, {}}};
  bright.constraints = {{Statistic::kMean, -kUnbounded, lux, 1, {1}, {}},
                        {Statistic::kChebyshev, lux / 10, kUnbounded, 2, {1}, {}}};
  thrifty.luminaires = {3, 0, {2000}, 0.1, 1, {}, {}, 1, {}};
  thrifty.goals = {{Statistic::kPower, Sense::kMinimize, 1, {}, {}},
                   {Statistic::kSigma, Sense::kMinimize, 0.5, {0}, {}}};
  thrifty.constraints = {{Statistic::kMean, lux / 2, kUnbounded, 1, {0}, {}},
                         {Statistic::kMinimum, lux / 20, kUnbounded, 1, {0}, {}}};
  return {even, bright, thrifty};
}

void run(const char* path, std::uint32_t seed, double lux) {
  Session session;
  openFile(session, path);
  int wish = 0;
  for (const Intentions& intentions : wishes(lux)) {
    requireDone(session.setIntentions(intentions));
    requireDone(session.start(seed, nullptr));
    for (std::uint32_t slice : {1u, 10u, 89u, 900u, 4000u, 5000u}) {
      const SearchProgress progress = session.advance(slice);
      const Shown shown = *session.incumbent();
      std::printf("{\"wish\": %d, \"evaluations\": %" PRIu64 ", \"foundAt\": %" PRIu64
                  ", \"violation\": %.17g, \"goal\": %.17g, \"dimming\": %.17g, \"sites\": [",
                  wish, progress.evaluations, progress.foundAt, progress.evaluation.violation,
                  progress.evaluation.goal, shown.layout.dimming);
      const char* comma = "";
      for (std::uint32_t site : shown.layout.sites) std::printf("%s%u", std::exchange(comma, ", "), site);
      std::printf("]}\n");
    }
    ++wish;
  }
}

}  // namespace
}  // namespace fiatlux

int main(int count, char** arguments) {
  const auto is = [&](const char* command) { return count > 1 && std::strcmp(arguments[1], command) == 0; };
  if (count == 3 && (is("write") || is("write-operator") || is("write-operator-first")))
    fiatlux::write(arguments[2], !is("write"), is("write-operator-first"));
  else if (count == 5 && std::strcmp(arguments[1], "run") == 0)
    fiatlux::run(arguments[2], std::strtoul(arguments[3], nullptr, 10), std::strtod(arguments[4], nullptr));
  else
    fiatlux::fail("usage: write FILE | write-operator FILE | write-operator-first FILE | run FILE SEED LUX");
  return 0;
}
