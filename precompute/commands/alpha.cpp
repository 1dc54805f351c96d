// fiatlux alpha: the smallest alpha whose Chebyshev constraints keep every patch within its bounds (paper
// section 4).
#include <CLI/CLI.hpp>
#include <chrono>
#include <cstdio>
#include <memory>

#include "core/alpha/alpha_search.h"
#include "core/alpha/guarantees.h"
#include "core/transport/room_view.h"
#include "precompute/base/error.h"
#include "precompute/base/json_text.h"
#include "precompute/commands/commands.h"
#include "precompute/files/asked_search.h"
#include "precompute/files/files_on_disk.h"
#include "precompute/files/scene_io.h"
#include "precompute/files/solve_report.h"
#include "precompute/files/terminal.h"
#include "precompute/program/option_checks.h"

namespace fiatlux {
namespace {

using Json = nlohmann::ordered_json;

struct AlphaCommandOptions {
  std::string scene, intentions, output;
  AlphaOptions search;
  bool json = false;
};

const char* outcomeName(AlphaOutcome outcome) {
  switch (outcome) {
    case AlphaOutcome::kFound:
      return "found";
    case AlphaOutcome::kZeroSuffices:
      return "zero suffices";
    case AlphaOutcome::kTwoEmpty:
      return "region II empty";
    case AlphaOutcome::kNoLayout:
      return "no layout";
    case AlphaOutcome::kOutOfIterations:
      return "out of iterations";
    case AlphaOutcome::kRunning:
      return "running";
  }
  return "";
}

Json iterationJson(const AskedSearch& asked, const AlphaIteration& it) {
  return {{"alpha", it.alpha},
          {"region", regionName(it.region)},
          {"interval", {it.low, it.high}},
          {"bipartition", it.bipartition},
          {"mean", it.mean},
          {"sigma", it.sigma},
          {"min", it.minimum},
          {"max", it.maximum},
          {"phi", it.phi},
          {"layout", asked.layoutJson(it.layout)}};
}

/// The layout that answers, or the best there is instead; nullptr where there is none.
const Layout* layoutOf(const AlphaSearch& search) {
  if (search.solution()) return &search.solution()->layout;
  return search.fallback() ? &*search.fallback() : nullptr;
}

Json reportJson(const AskedSearch& asked, const AlphaSearch& search, double seconds) {
  Json report = {
      {"outcome", outcomeName(search.outcome())}, {"verdict", search.verdict()}, {"alpha", nullptr}};
  if (search.solution()) {
    report["alpha"] = search.solution()->alpha;
    report["phi"] = search.solution()->phi;
  } else if (search.fallback()) {
    report["feasibleBound"] = search.feasibleBound();
  }
  if (const Layout* layout = layoutOf(search)) {
    report["layout"] = asked.layoutJson(*layout);
    if (!layout->ties.empty())
      report["arrangement"] = arrangementJson(asked.intentions().luminaires.arrangement, *layout);
    report["surfaces"] = surfacesJson(asked.lightResults(*layout));
  }
  report["iterations"] = Json::array();
  for (const AlphaIteration& iteration : search.iterations())
    report["iterations"].push_back(iterationJson(asked, iteration));
  report["evaluations"] = search.evaluations();
  report["seconds"] = seconds;
  return report;
}

void printTable(const AlphaSearch& search) {
  std::printf("%9s  %-6s  %-18s  %10s  %10s  %10s  %10s\n", "alpha", "region", "interval", "mean", "sigma",
              "true min", "Phi");
  for (const AlphaIteration& it : search.iterations())
    std::printf("%9.4f  %-6s  [%7.4f, %7.4f]  %10.5g  %10.5g  %10.5g  %10.5g\n", it.alpha,
                regionName(it.region), it.low, it.high, it.mean, it.sigma, it.minimum, it.phi);
}

void findAlpha(const AlphaCommandOptions& options) {
  if (!options.output.empty()) orThrow(checkReplaceable(options.output));
  Scene room = orThrow(readSceneFile(options.scene));
  AskedSearch asked = orThrow(options.intentions,
                              AskedSearch::make(room, orThrow(readIntentionsFile(room, options.intentions))));
  if (!options.output.empty()) orThrow(asked.nameFilesFrom(options.output, options.intentions));
  const Intentions& intentions = asked.intentions();
  orThrow(options.intentions, checkAlphaIntentions(asked.scene(), intentions));
  PreparedScene prepared(asked.scene());
  const auto begin = std::chrono::steady_clock::now();
  AlphaSearch search(prepared, intentions, options.search);
  while (!search.done()) search.advance(1u << 16);
  const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  const Layout* layout = layoutOf(search);
  if (!options.output.empty() && layout)
    orThrow(replaceFile(options.output, jsonDocument(asked.layoutJson(*layout))));
  if (options.json) {
    std::fputs(jsonDocument(reportJson(asked, search, seconds)).c_str(), stdout);
    return;
  }
  printTable(search);
  std::printf("%s\n%llu evaluations, %.1f ms\n", printable(search.verdict(), 1000).c_str(),
              static_cast<unsigned long long>(search.evaluations()), 1e3 * seconds);
}

}  // namespace

void addAlphaCommand(CLI::App& app) {
  auto options = std::make_shared<AlphaCommandOptions>();
  AlphaOptions& search = options->search;
  CLI::App* command = app.add_subcommand(
      "alpha", "Find the smallest alpha that guarantees a minimum or maximum on every patch");
  command->add_option("scene", options->scene, "scene file (.flux)")->required();
  command
      ->add_option("--intentions", options->intentions, "intentions.json with a \"minimum\" or \"maximum\"")
      ->required();
  command->add_option("--delta-alpha", search.deltaAlpha, "stop when the interval is this narrow")
      ->check(numberFrom(1e-6, 1e3))
      ->capture_default_str();
  command
      ->add_option("--delta-phi", search.deltaPhi,
                   "stop when the goal changes by at most this share over it; 0 = never")
      ->check(numberFrom(0, 1))
      ->capture_default_str();
  command->add_option("--iterations", search.iterations, "stop after so many")
      ->check(wholeFrom(1, 10000))
      ->capture_default_str();
  command->add_option("--evaluations", search.evaluations, "trial layouts a run")
      ->check(wholeFrom(1, 100000000))
      ->capture_default_str();
  command->add_option("--runs", search.runs, "searches an iteration")
      ->check(wholeFrom(1, 1000))
      ->capture_default_str();
  command->add_option("--seed", search.seed, "of the first search")->check(aSeed())->capture_default_str();
  command->add_flag("--json", options->json, "one JSON document on standard output");
  command->add_option("-o,--output", options->output, "write the layout.json here");
  command->callback([options] { findAlpha(*options); });
}

}  // namespace fiatlux
