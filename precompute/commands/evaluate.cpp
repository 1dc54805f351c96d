// fiatlux evaluate: what a layout does to the surfaces of a scene file.
#include <CLI/CLI.hpp>
#include <cstdio>
#include <memory>
#include <nlohmann/json.hpp>

#include "core/scene/calculation_grid.h"
#include "core/scene/zones.h"
#include "precompute/base/error.h"
#include "precompute/base/json_text.h"
#include "precompute/commands/commands.h"
#include "precompute/files/files_on_disk.h"
#include "precompute/files/layout_json.h"
#include "precompute/files/light_results.h"
#include "precompute/files/photometric_layout.h"
#include "precompute/files/scene_io.h"
#include "precompute/files/terminal.h"

namespace fiatlux {
namespace {

struct EvaluateOptions {
  std::string scene, layout, patches;
  bool json = false, directOnly = false;
};

/// The first few, and how many there are beyond them.
void printNotes(const std::string& path, const std::vector<std::string>& notes) {
  constexpr std::size_t kMost = 10;
  for (std::size_t i = 0; i < notes.size() && i < kMost; ++i) printNote("warning: " + path + ": " + notes[i]);
  if (notes.size() > kMost)
    printNote("warning: " + path + ": " + std::to_string(notes.size() - kMost) + " more like these");
}

void evaluate(const EvaluateOptions& options) {
  LayoutFile file = orThrow(readLayoutFile(options.layout));
  file.directOnly |= options.directOnly;
  if (!file.planes.empty() && file.directOnly)
    throw CommandError(options.layout + ": \"planes\" are told of all light; drop them or \"quantity\"");
  Scene scene = orThrow(readSceneFile(options.scene));
  std::vector<std::string> notes;
  const Layout layout = orThrow(options.layout, layoutOnSites(file, scene, notes));

  const bool photometric = hasPhotometry(file) || file.directOnly;
  std::vector<float> light = photometric
                                 ? orThrow(options.scene, photometricIlluminance(file, layout, scene, notes))
                                 : illuminanceOf(scene, layout);
  printNotes(options.layout, notes);
  std::vector<float> asItWas = light;  // note: paint changes nothing of direct light
  orThrow(options.layout, paintScene(file.paint, scene, file.directOnly ? asItWas : light));
  const std::vector<Observer> observers = observersFor(file.observers, scene.patches);
  std::vector<ObserverReading> seen;
  if (!observers.empty())
    seen =
        orThrow(options.layout, observerReadings(file, layout, scene, observers,
                                                 file.directOnly ? std::vector<float>(light.size()) : light));
  std::vector<PlaneReading> planes;
  if (!file.planes.empty()) planes = orThrow(options.layout, planeReadings(file, layout, scene, light));
  const std::vector<Zone> zones = orThrow(options.layout, zonesOf(scene, file.taskAreas));
  orThrow(options.layout, takeZones(scene, zones));
  const LightResults results =
      photometric || !file.paint.empty() ? lightResults(scene, light) : lightResults(scene, layout);
  if (!options.patches.empty())
    orThrow(replaceFile(options.patches, patchesCsv(scene.patches, scene.surfaces, light)));
  const std::vector<GridReading> grids = readGrids(scene, light);
  if (!options.json) {
    std::fputs((surfacesTable(results) + "\n" + gridLines(scene.surfaces, grids) +
                observersText(observers, seen) + planesText(scene.surfaces, planes))
                   .c_str(),
               stdout);
    return;
  }
  nlohmann::ordered_json json = {{"identity", scene.identity}, {"surfaces", surfacesJson(results)}};
  json["all"] = surfaceJson(results.all);
  json["grids"] = gridsJson(scene.surfaces, grids);
  json["layout"] = layoutJson(layout, scene);
  json["directOnly"] = file.directOnly;
  double power = 0;
  for (double flux : layout.flux) power += layout.dimming * flux;
  json["power"] = power;
  if (!observers.empty()) json["observers"] = observersJson(observers, seen);
  if (!planes.empty()) json["planes"] = planesJson(scene.surfaces, planes);
  std::fputs(jsonDocument(json).c_str(), stdout);
}

}  // namespace

void addEvaluateCommand(CLI::App& app) {
  auto options = std::make_shared<EvaluateOptions>();
  CLI::App* command = app.add_subcommand("evaluate", "What a layout does to the surfaces of a scene file");
  command->add_option("scene", options->scene, "Scene file (.flux)")->required();
  command
      ->add_option("--layout", options->layout, "Luminaires (layout.json); positions take the nearest site")
      ->required();
  command->add_option("--patches", options->patches, "Write the light of every patch to this .csv");
  command->add_flag("--direct-only", options->directOnly, "No reflections (emergency lighting)");
  command->add_flag("--json", options->json, "One JSON document on standard output");
  command->callback([options] { evaluate(*options); });
}

}  // namespace fiatlux
