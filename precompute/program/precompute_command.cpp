// fiatlux precompute: glTF in, scene file out.
#include "precompute/program/precompute_command.h"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <memory>

#include "core/search/layout_search.h"
#include "core/search/prepared_scene.h"
#include "precompute/base/error.h"
#include "precompute/files/asked_search.h"
#include "precompute/files/command_host.h"
#include "precompute/files/files_on_disk.h"
#include "precompute/files/intentions_json.h"
#include "precompute/files/named_files.h"
#include "precompute/program/option_checks.h"
#include "precompute/program/room_command_options.h"

namespace fiatlux {
namespace {

constexpr int kUselessStatus = 3;  // a file is written, and nobody should rely on it

struct PrecomputeOptions {
  std::string source, output, opening;
  bool verbose = false;
  SceneOptions scene;
};

/// Where the scene goes; refuses what could not be written, and the room itself.
std::string outputOf(const PrecomputeOptions& options) {
  const std::string output = !options.output.empty()
                                 ? options.output
                                 : std::filesystem::path(options.source).replace_extension(".flux").string();
  std::error_code none;
  if (std::filesystem::equivalent(options.source, output, none))
    throw CommandError(output + ": this is the room itself; pass another file to --output");
  orThrow(checkReplaceable(output));
  return output;
}

void printReport(const std::string& output, const MadeScene& scene, double seconds) {
  const SceneReport& r = scene.report;
  std::printf("%s: %u patches, %u clusters, %u sites, %u surfaces, %.2f MB, identity %s, %.1f s\n",
              output.c_str(), r.patches, r.clusters, r.sites, r.surfaces,
              static_cast<double>(scene.file.size()) / 1e6, r.identity.c_str(), seconds);
  std::printf(
      "light lost %.3f %%, residual %.2g, statistics within %.2g, patch light within %.2f %% RMS (median)\n",
      100 * std::max(0.0, 1 - r.balance.absorbed), r.residuals.empty() ? 0.0 : r.residuals.back(),
      std::max(r.errors.mean, r.errors.sigma), 100 * r.errors.patchRmsMedian);
}

/// What a short search finds for the intentions of --opening, which are there in a file, or as text that
/// names photometric files from the working folder.
Result<OpeningLight> openingLight(const std::string& option, const Scene& scene) {
  Result<IntentionsFile> asked = option.front() == '{'
                                     ? parseIntentionsFile(scene, option, filesBeside("./", "working folder"))
                                     : readIntentionsFile(scene, option);
  if (!asked) return Error{"--opening: " + asked.error().message};
  if (!asked->intentions.observers.empty())
    return Error{"--opening: it knows no observers; leave \"ugr\" out"};
  if (!asked->paint.empty()) return Error{"--opening: a room opens in its own paint; leave \"paint\" out"};
  Scene room = scene;  // note: candidates are made of a room that may change
  const Result<AskedSearch> search = AskedSearch::make(room, std::move(*asked));
  if (!search) return Error{"--opening: " + search.error().message};
  constexpr std::uint32_t kEvaluations = 100000;
  PreparedScene prepared(search->scene());
  LayoutSearch found(prepared, search->intentions(), 1);
  found.advance(kEvaluations);
  const Layout layout = found.incumbent();
  return OpeningLight{search->onSites(layout), illuminanceOf(search->scene(), layout), search->isOfTypes()};
}

void precompute(PrecomputeOptions options) {
  const std::string output = outputOf(options);
  const std::string& opening = options.opening;
  if (!opening.empty()) {
    // What is missing is told before the work, not after.
    if (opening.front() != '{') orThrow(readFileBytes(opening));
    options.scene.opening = [&](const Scene& scene) { return openingLight(opening, scene); };
  }
  TerminalProgress progress;
  const Host host = commandHost(options.source, options.scene.transport.threads, progress, options.verbose);
  const ModelFile model = orThrow(options.source, modelAt(options.source));
  const MadeScene scene = orThrow(options.source, makeScene(model, options.scene, host));
  orThrow(replaceFile(output, scene.file));
  progress.clear();
  printReport(output, scene, progress.total());
  if (scene.report.useless.empty()) return;
  printNote(output + ": this is of little use: " + scene.report.useless);
  throw CLI::RuntimeError(kUselessStatus);
}

}  // namespace

void addPrecomputeCommand(CLI::App& app) {
  auto o = std::make_shared<PrecomputeOptions>();
  RoomOptions& room = o->scene.room;
  TransportOptions& transport = o->scene.transport;
  CLI::App* command = app.add_subcommand("precompute", "glTF in, scene file out");
  addRoomOptions(*command, o->source, room, {transport.rays, transport.seed, transport.threads}, o->verbose);
  command->add_option("-o,--output", o->output, "The scene file (.flux; default: the room's name)");
  command->add_option("--cluster", room.cluster, "Patches on a cluster's edge")
      ->check(wholeFrom(1, 64))
      ->capture_default_str();
  command
      ->add_option("--refine", transport.refine,
                   "Most refinement steps after the low-rank answer; fewer where 0.1 % is left")
      ->check(wholeFrom(0, 100))
      ->capture_default_str();
  command->add_flag("--paper", transport.paper,
                    "The paper's formulation to the letter, with Y, V and k x k covariances");
  command->add_option("--opening", o->opening,
                      "Intentions (a file, or its text) whose light is to be seen while the rest is loading");
  transport.exchange = true;
  command->add_flag("!--no-exchange", transport.exchange,
                    "Leave out what other photometries need: visible shares and the exchange of light");
  command->callback([o] { precompute(*o); });
}

}  // namespace fiatlux
