// fiatlux solve: the best layout that a search finds for a file of intentions.
#include <CLI/CLI.hpp>
#include <chrono>
#include <cstdio>
#include <memory>

#include "core/base/short_number.h"
#include "core/bound/layout_bound.h"
#include "core/scene/surface_names.h"
#include "core/search/eased.h"
#include "core/search/layout_search.h"
#include "core/search/start_layout.h"
#include "core/transport/room_view.h"
#include "precompute/base/error.h"
#include "precompute/base/json_text.h"
#include "precompute/commands/commands.h"
#include "precompute/files/asked_search.h"
#include "precompute/files/files_on_disk.h"
#include "precompute/files/observers_json.h"
#include "precompute/files/planes_json.h"
#include "precompute/files/scene_io.h"
#include "precompute/files/solve_report.h"
#include "precompute/program/option_checks.h"

namespace fiatlux {
namespace {

using Json = nlohmann::ordered_json;
using Clock = std::chrono::steady_clock;

constexpr double kRounding = 1e-9;  // %: what dimming to an aim leaves of it

struct SolveOptions {
  std::string scene, intentions, output;
  std::uint64_t seed = 1;
  std::uint32_t runs = 1, evaluations = 25000;
  bool bound = false, json = false;
};

struct Run {
  Layout layout;
  Evaluation evaluation;
  std::uint64_t seed = 0, evaluations = 0;
  double seconds = 0;
};

struct Runs {
  std::vector<Run> all;
  std::size_t best = 0;
  std::unique_ptr<LayoutSearch> search;  // of the best
};

void advance(LayoutSearch& search, const Intentions& intentions, std::uint32_t evaluations) {
  constexpr std::uint32_t kSlice = 1u << 20;
  for (std::uint32_t left = evaluations; left > 0; left -= std::min(left, kSlice))
    search.advance(std::min(left, kSlice));
  const bool tryAll = intentions.luminaires.arrangement.rule == Rule::kField;
  while (tryAll && !search.isProved()) search.advance(kSlice);
}

/// What a search has found; where that misses a bound, the best for the goals that misses it by hardly more.
Layout settled(PreparedScene& prepared, const Intentions& intentions, const LayoutSearch& search,
               const SolveOptions& options) {
  const Layout found = search.incumbent();
  if (search.evaluation().violation == 0 || intentions.goals.empty()) return found;
  const Intentions eased = easedToReach(intentions, constraintReadings(prepared, intentions, found));
  LayoutSearch further(prepared, eased, options.seed, &found);
  advance(further, intentions, options.evaluations);
  const Evaluation& reached = further.evaluation();
  return reached.violation == 0 && reached.goal < search.evaluation().goal ? further.incumbent() : found;
}

/// All regular fields are tried, however many; every other search spends its evaluations.
Runs search(PreparedScene& prepared, const Intentions& intentions, const SolveOptions& options) {
  Runs runs;
  for (std::uint32_t r = 0; r < options.runs; ++r) {
    const auto begin = Clock::now();
    auto search = std::make_unique<LayoutSearch>(prepared, intentions, options.seed + r);
    advance(*search, intentions, options.evaluations);
    const double seconds = std::chrono::duration<double>(Clock::now() - begin).count();
    runs.all.push_back({settled(prepared, intentions, *search, options), search->evaluation(),
                        options.seed + r, search->evaluations(), seconds});
    if (r > 0 && !isBetter(search->evaluation(), runs.search->evaluation())) continue;
    runs.best = r;
    runs.search = std::move(search);
  }
  return runs;
}

Json runJson(PreparedScene& prepared, const AskedSearch& asked, const Run& run) {
  const Layout& layout = run.layout;
  const Intentions& intentions = asked.intentions();
  const Shown shown = shownOf(prepared, intentions, layout);
  Json json = {{"seed", run.seed}, {"layout", asked.layoutJson(layout)}};
  if (!layout.ties.empty()) json["arrangement"] = arrangementJson(intentions.luminaires.arrangement, layout);
  json["surfaces"] = surfacesJson(asked.lightResults(layout));
  json["grids"] = gridsJson(asked.room().surfaces, readGrids(asked.room(), shown.illuminance));
  json["goal"] = goalJson(shown);
  json["violations"] = violationsJson(prepared.scene(), intentions, shown);
  if (!intentions.observers.empty()) json["observers"] = observersJson(intentions.observers, shown.observers);
  if (!shown.planes.empty()) json["planes"] = planesJson(asked.room().surfaces, shown.planes);
  json["evaluations"] = run.evaluations;
  json["seconds"] = run.seconds;
  return json;
}

std::string goalLine(const Scene& scene, const Intentions& intentions, const Shown& shown, std::size_t g) {
  const Goal& goal = intentions.goals[g];
  const StatisticTraits& traits = traitsOf(goal.statistic);
  const bool near = goal.sense == Sense::kNear;
  const Quantity quantity = quantityOf(intentions, goal);
  std::string line = near ? "" : goal.sense == Sense::kMinimize ? "least " : "most ";
  if (quantity == Quantity::kDirect && traits.needsSurfaces) line += "direct ";
  line += traits.name;
  if (traits.needsSurfaces) line += " of " + surfaceSetName(scene, goal.surfaces);
  if (traits.needsOver) line += " over " + surfaceSetName(scene, goal.over);
  if (near) {
    const double off = 100 * shown.goals[g];  // %
    return line + " near " + valueText(scene, goal.target, goal.statistic, quantity) + ": " +
           shortNumber(off < kRounding ? 0 : off, kReportDigits) + " % off";
  }
  return line + ": " + valueText(scene, shown.goals[g], goal.statistic, quantity);
}

void printRun(PreparedScene& prepared, const AskedSearch& asked, const Run& run) {
  const Scene& scene = asked.scene();
  const Intentions& intentions = asked.intentions();
  const Layout& layout = run.layout;
  const Shown shown = shownOf(prepared, intentions, layout);
  std::printf("seed %llu, %llu evaluations, %.2f ms\n", static_cast<unsigned long long>(run.seed),
              static_cast<unsigned long long>(run.evaluations), 1e3 * run.seconds);
  for (std::size_t g = 0; g < shown.goals.size(); ++g)
    std::printf("  %s\n", goalLine(scene, intentions, shown, g).c_str());
  for (std::size_t c = 0; c < shown.constraints.size(); ++c)
    std::printf("  %s\n", constraintLine(scene, intentions, shown, c).c_str());
  if (!layout.ties.empty())
    std::printf("  %s\n", arrangementLine(intentions.luminaires.arrangement, layout).c_str());
  std::fputs(
      (observersText(intentions.observers, shown.observers) + planesText(asked.room().surfaces, shown.planes))
          .c_str(),
      stdout);
  if (layout.dimming != 1)
    std::printf("  dimmed to %s\n", shortNumber(layout.dimming, kReportDigits).c_str());
  for (std::size_t i = 0; i < layout.sites.size(); ++i)
    std::printf("  %s\n", asked.luminaireLine(layout, i).c_str());
}

/// What is proved about the best possible goal: its bound in the goal's unit, and how far the best run is
/// from it at most.
Json boundJson(PreparedScene& prepared, const Intentions& intentions, const LayoutSearch& best) {
  const auto begin = Clock::now();
  LayoutBound bound(prepared, intentions, best);
  while (!bound.done()) bound.advance(1u << 12);
  const std::optional<double> within = bound.within(best.evaluation());
  if (!within) return nullptr;
  const Layout reference{spreadSites(prepared, intentions.luminaires), {}, 1};
  const double factor =
      intentions.goals.size() == 1 ? Objective(prepared, intentions, reference).goalFactor(0) : 1.0;
  return {{"goal", bound.goal() / factor},
          {"within", *within},
          {"kind", kBoundKindNames[static_cast<std::size_t>(bound.kind())]},
          {"seconds", std::chrono::duration<double>(Clock::now() - begin).count()}};
}

void printBound(const Json& bound) {
  if (bound.is_null())
    std::printf("nothing is proved about the best possible for these intentions\n");
  else
    std::printf(
        "proved by %s in %.3g s: no layout reaches a goal beyond %s; the best found is within %.3g %% of the "
        "best "
        "possible\n",
        bound["kind"].get<std::string>().c_str(), bound["seconds"].get<double>(),
        shortNumber(bound["goal"].get<double>(), kReportDigits).c_str(), 100 * bound["within"].get<double>());
}

void solve(const SolveOptions& options) {
  if (!options.output.empty()) orThrow(checkReplaceable(options.output));
  Scene room = orThrow(readSceneFile(options.scene));
  AskedSearch asked = orThrow(options.intentions,
                              AskedSearch::make(room, orThrow(readIntentionsFile(room, options.intentions))));
  if (!options.output.empty()) orThrow(asked.nameFilesFrom(options.output, options.intentions));
  const Intentions& intentions = asked.intentions();
  PreparedScene prepared(asked.scene());
  const Runs runs = search(prepared, intentions, options);
  Json report = {{"runs", Json::array()}};
  if (options.bound) report["bound"] = boundJson(prepared, intentions, *runs.search);
  if (options.json) {
    for (const Run& run : runs.all) report["runs"].push_back(runJson(prepared, asked, run));
  } else {
    for (const Run& run : runs.all) printRun(prepared, asked, run);
    if (options.bound) printBound(report["bound"]);
  }
  if (!options.output.empty())
    orThrow(replaceFile(options.output, jsonDocument(asked.layoutJson(runs.all[runs.best].layout))));
  if (options.json) std::fputs(jsonDocument(report).c_str(), stdout);
}

}  // namespace

void addSolveCommand(CLI::App& app) {
  auto options = std::make_shared<SolveOptions>();
  CLI::App* command =
      app.add_subcommand("solve", "Place the luminaires so that the light does what the intentions say");
  command->add_option("scene", options->scene, "scene file (.flux)")->required();
  command->add_option("--intentions", options->intentions, "intentions.json")->required();
  command->add_option("--seed", options->seed, "of the first run; the others count on")
      ->check(aSeed())
      ->capture_default_str();
  command->add_option("--runs", options->runs, "independent searches")
      ->check(wholeFrom(1, 100000))
      ->capture_default_str();
  command->add_option("--evaluations", options->evaluations, "trial layouts a run")
      ->check(wholeFrom(1, 4000000000u))
      ->capture_default_str();
  command->add_flag("--bound", options->bound,
                    "prove how far from the best possible it is at most (takes seconds to a minute)");
  command->add_flag("--json", options->json, "one JSON document on standard output");
  command->add_option("-o,--output", options->output, "write the best layout.json here");
  command->callback([options] { solve(*options); });
}

}  // namespace fiatlux
