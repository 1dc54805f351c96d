// A hall of 60 x 40 x 10 m under m candidates, natively or as Wasm: what statistics of its floor and of all
// of it cost in either form (core/search/prepared_scene.h), and how long a first layout of many luminaires
// takes. Prints one JSON object; bench.mjs makes rows of it.
//   hall_bench CANDIDATES [factor|covariance]      without a form: what such a search takes
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <ctime>
#include <fstream>
#include <numbers>
#include <string>

#ifdef __EMSCRIPTEN__
#include <emscripten/heap.h>
#endif

#include "core/search/evaluator.h"
#include "core/search/layout_search.h"
#include "core/search/start_layout.h"
#include "tests/core/synthetic_scene.h"

namespace fiatlux {
namespace {

constexpr double kWidth = 60, kDepth = 40, kHeight = 10;  // m
constexpr std::uint32_t kPlaces = 500, kFirst = 30'000;   // of luminaires; evaluations before a first answer

/// ms of this process alone; as Wasm, of the wall.
double now() { return 1e3 * static_cast<double>(std::clock()) / CLOCKS_PER_SEC; }

/// The most memory that there has been, MB: of the process, or of the Wasm module.
double peakMegabytes() {
#ifdef __EMSCRIPTEN__
  return static_cast<double>(emscripten_get_heap_size()) / 1e6;
#else
  std::ifstream status("/proc/self/status");
  for (std::string line; std::getline(status, line);)
    if (line.rfind("VmHWM:", 0) == 0) return std::atof(line.c_str() + 6) * 1024 / 1e6;
  return 0;
#endif
}

/// Of candidate j: cos^n about an aim that leans from the vertical, the more ways hang on one place the more
/// of them.
struct Beam {
  Vec3 position, axis;
  double exponent;
};

Beam beamOf(std::uint32_t j, std::uint32_t count) {
  const std::uint32_t places = std::min(kPlaces, count), place = j % places, way = j / places;
  const std::uint32_t across = 25, row = place / across, column = place % across;
  const double turn = 2.4 * way, lean = way == 0 ? 0 : 0.6;
  return {{(column + 0.5) * kWidth / across, kHeight - 0.5, (row + 0.5) * kDepth * across / places},
          {lean * std::cos(turn), -1, lean * std::sin(turn)},
          way % 2 == 0 ? 2.0 : 8.0};
}

Scene hall(std::uint32_t candidates) {
  Scene scene;
  addGrid(scene, "floor", {0, 0, 0}, {0, 0, 1}, {1, 0, 0}, 40, 60, 1, 0.3f, false);
  addGrid(scene, "ceiling", {0, kHeight, 0}, {1, 0, 0}, {0, 0, 1}, 60, 40, 1, 0.5f, false);
  addGrid(scene, "long walls", {0, 0, 0}, {1, 0, 0}, {0, 1, 0}, 60, 20, 1, 0.5f, false);
  addGrid(scene, "short walls", {0, 0, 0}, {0, 1, 0}, {0, 0, 1}, 20, 40, 1, 0.5f, false);
  const Patches& patches = scene.patches;
  scene.responses = {patches.rows(), candidates, {}};
  scene.responses.illuminance.reserve(std::size_t{patches.rows()} * candidates);
  for (std::uint32_t j = 0; j < candidates; ++j) {
    const Beam beam = beamOf(j, candidates);
    scene.sites.push_back({beam.position, {0, -1, 0}, {1, 0, 0}, 1});
    const Vec3 axis = normalized(beam.axis);
    for (std::uint32_t p = 0; p < patches.rows(); ++p) {
      const Vec3 way = patches.center[p] - beam.position;
      const double d2 = dot(way, way) + 0.2, d = std::sqrt(d2);
      const double leaving = std::max(0.0, dot(way, axis) / d), coming = -dot(way, patches.normal[p]) / d;
      const double direct = coming > 0 ? std::pow(leaving, beam.exponent) * coming / d2 : 0;
      scene.responses.illuminance.push_back(static_cast<float>(direct + 2e-4 + 2e-3 / (20 + d2)));
    }
  }
  scene.errorBound.assign(scene.surfaces.size(), 0);
  scene.illuminance = meanRows(patches, scene.surfaces.size(), scene.responses, Quantity::kIlluminance);
  return scene;
}

/// Even light on the floor, not too little of it, and the spread of the whole hall bounded.
Intentions evenFloor(std::uint32_t count) {
  Intentions intentions;
  intentions.luminaires.count = count;
  intentions.luminaires.flux = {20'000};
  intentions.luminaires.minDistance = 1e-3;
  intentions.goals = {{Statistic::kSigma, Sense::kMinimize, 1, {0}, {}}};
  intentions.constraints = {{Statistic::kMean, 300, kUnbounded, 1, {0}, {}},
                            {Statistic::kSigma, 0, 1000, 1, {}, {}}};
  return intentions;
}

/// Nanoseconds a trial of one moved luminaire, mean and sigma of one set.
double deltaMove(PreparedScene& prepared, const SurfaceSet& surfaces, std::uint32_t count) {
  Intentions intentions = evenFloor(count);
  intentions.goals[0].surfaces = surfaces;
  intentions.constraints.clear();
  Evaluator evaluator(prepared, intentions);
  Random random(2);
  evaluator.load(randomSites(prepared, intentions.luminaires, random));
  std::vector<std::uint32_t> candidates(48);
  std::uint64_t trials = 0;
  const double begin = now();
  while (now() - begin < 200) {
    for (std::uint32_t& candidate : candidates) candidate = random.below(prepared.candidateCount());
    Trial best{{}, 0, {-1, 0, 1}};  // nothing is better
    evaluator.tryMoves(random.below(count), candidates.data(), 48, best);
    trials += 48;
  }
  return (now() - begin) * 1e6 / static_cast<double>(trials);
}

void run(std::uint32_t candidates, VarianceForm form) {
  const std::uint32_t count = std::min(200u, candidates / 4);
  const Scene scene = hall(candidates);
  const double sceneMegabytes = peakMegabytes();
  PreparedScene prepared(scene, form);
  // As the page does: a search begins, and answers after so many evaluations.
  const double begin = now();
  const auto floor = prepared.statistics(Quantity::kIlluminance, {0});
  const auto all = prepared.statistics(Quantity::kIlluminance, {});
  const double made = now();
  LayoutSearch search(prepared, evenFloor(count), 1, nullptr);
  search.advance(kFirst);
  const double first = now();
  std::printf(
      "{\"candidates\": %u, \"patches\": %u, \"luminaires\": %u, \"form\": \"%s\", \"statistics_ms\": %.1f, "
      "\"first_layout_ms\": %.1f, \"delta_floor_ns\": %.1f, \"delta_all_ns\": %.1f, \"goal\": %.6f, "
      "\"violation\": %.6f, \"scene_mb\": %.0f, \"peak_mb\": %.0f}\n",
      candidates, scene.patches.rows(), count, all->factor ? "factor" : "covariance", made - begin,
      first - begin, deltaMove(prepared, {0}, count), deltaMove(prepared, {}, count),
      search.evaluation().goal, search.evaluation().violation, sceneMegabytes, peakMegabytes());
}

}  // namespace
}  // namespace fiatlux

int main(int count, char** arguments) {
  using fiatlux::VarianceForm;
  if (count < 2) {
    std::fprintf(stderr, "usage: hall_bench CANDIDATES [factor|covariance]\n");
    return 2;
  }
  VarianceForm form = VarianceForm::kBySize;
  if (count > 2)
    form = std::strcmp(arguments[2], "factor") == 0 ? VarianceForm::kFactor : VarianceForm::kCovariance;
  fiatlux::run(static_cast<std::uint32_t>(std::atoi(arguments[1])), form);
  return 0;
}
