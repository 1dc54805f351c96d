// fiatlux experiments: section 5 of the paper as a report with plots and raw runs, made again by one command.
#include "precompute/experiments/experiments.h"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "precompute/base/error.h"
#include "precompute/commands/commands.h"
#include "precompute/files/files_on_disk.h"
#include "precompute/files/scene_io.h"
#include "precompute/files/surface_names.h"
#include "precompute/files/terminal.h"
#include "precompute/program/option_checks.h"

namespace fiatlux {
namespace {

struct ExperimentsOptions {
  std::string scene = "public/scenes/e-corridor.flux", folder = "docs", wall = "yellow wall";
  std::uint32_t runs = 20, evaluations = 25000;
  bool byPairs = false;
};

/// The pictures of the room that `npm run pictures` left beside the plots, named after the experiments.
std::string roomPictures(const std::filesystem::path& folder) {
  std::vector<std::string> names;
  for (const auto& entry : std::filesystem::directory_iterator(folder))
    if (entry.path().extension() == ".jpg") names.push_back(entry.path().stem().string());
  if (names.empty()) return "";
  std::sort(names.begin(), names.end());
  std::string section =
      "\n## The room in each experiment\n\nSeen by the app; `npm run pictures` takes them again.\n\n";
  for (const std::string& name : names)
    section += "**" + name + "**\n\n![" + name + "](experiments/" + name + ".jpg)\n\n";
  return section;
}

/// Refuses scenes on which the experiments cannot be run.
void checkScene(const ExperimentsOptions& options, const Scene& scene, const SurfaceSet& wall) {
  if (scene.sites.size() < 7)
    throw CommandError(options.scene + ": fewer than seven sites; the experiments place six luminaires");
  for (const std::uint32_t s : wall)
    if (scene.surfaces[s].measuring)
      throw CommandError(options.scene + ": \"" + options.wall +
                         "\" is a measuring plane; name a wall with --wall");
}

void runParts(Experiments& e) {
  const std::pair<const char*, void (*)(Experiments&)> parts[] = {{"dispersion", experimentDispersion},
                                                                  {"intentions", experimentIntentions},
                                                                  {"chebyshev", experimentChebyshev},
                                                                  {"alpha", experimentAlpha},
                                                                  {"speed", experimentSpeed}};
  TerminalProgress progress;
  for (const auto& [name, part] : parts) {
    progress.begin(name);
    part(e);
  }
}

/// The parts' reports, whose pictures lie beside them, as seen from the folder above.
std::string withPictures(std::string report) {
  const std::string folder = "experiments/";
  for (std::size_t at = 0; (at = report.find(".svg)", at)) != std::string::npos; at += folder.size() + 5)
    report.insert(report.rfind('(', at) + 1, folder);
  return report;
}

std::string reportOf(const ExperimentsOptions& options, const Experiments& e,
                     const std::filesystem::path& plots) {
  const Scene& scene = e.prepared.scene();
  std::string table = "| figure | paper | here | why they differ |\n|---|---|---|---|\n";
  for (const std::string& row : e.comparison) table += row + "\n";
  return "# The paper's experiments, run again\n\nMade by `fiatlux experiments" +
         std::string(options.byPairs ? " --pairs" : "") + "` on " +
         std::filesystem::path(options.scene).filename().string() + " (" +
         std::to_string(scene.patches.count) + " patches, " + std::to_string(scene.patches.clusterCount) +
         " clusters, " + std::to_string(scene.sites.size()) +
         " sites). The paper's room is not published: ours meets all counts that it "
         "prints, not its dimensions, so shares and "
         "ratios are compared, not absolute values. Raw runs: "
         "[experiments/runs.csv](experiments/runs.csv). Times are processor times of this machine.\n\n" +
         table + "\n" + withPictures(e.report) + roomPictures(plots);
}

void runExperiments(const ExperimentsOptions& options) {
  const Scene scene = orThrow(readSceneFile(options.scene));
  PreparedScene prepared(scene);
  Experiments e{prepared, orThrow(surfacesNamed(scene, {options.wall}))};
  e.runs = options.runs;
  e.evaluations = options.evaluations;
  e.byPairs = options.byPairs;
  checkScene(options, scene, e.wall);

  const std::filesystem::path folder = options.folder, plots = folder / "experiments";
  std::error_code failure;
  std::filesystem::create_directories(plots, failure);
  if (failure) throw CommandError(plots.string() + ": cannot be made; choose another folder with -o");

  runParts(e);
  for (const auto& [name, svg] : e.pictures) orThrow(replaceFile((plots / name).string(), svg));
  orThrow(replaceFile((plots / "runs.csv").string(), e.rows));
  orThrow(replaceFile((folder / "experiments.md").string(), reportOf(options, e, plots)));
}

}  // namespace

void addExperimentsCommand(CLI::App& app) {
  auto options = std::make_shared<ExperimentsOptions>();
  CLI::App* command =
      app.add_subcommand("experiments", "Run the paper's section 5 and write a report with plots");
  command->add_option("-o,--output", options->folder, "folder for experiments.md and experiments/")
      ->capture_default_str();
  command->add_option("--scene", options->scene, "scene file (.flux)")->capture_default_str();
  command->add_option("--wall", options->wall, "the surface that plays the yellow wall")
      ->capture_default_str();
  command->add_option("--runs", options->runs, "seeds a problem")
      ->check(wholeFrom(1, 1000))
      ->capture_default_str();
  command->add_option("--evaluations", options->evaluations, "trial layouts a run")
      ->check(wholeFrom(1, 10000000))
      ->capture_default_str();
  command->add_flag("--pairs", options->byPairs,
                    "prove how near to the best possible they are by pairs of luminaires, too (minutes)");
  command->callback([options] { runExperiments(*options); });
}

}  // namespace fiatlux
