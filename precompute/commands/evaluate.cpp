// fiatlux evaluate: what a layout does to the surfaces of a scene file.
#include <CLI/CLI.hpp>
#include <cstdio>
#include <memory>
#include <nlohmann/json.hpp>

#include "precompute/base/error.h"
#include "precompute/commands/commands.h"
#include "precompute/files/files_on_disk.h"
#include "precompute/files/layout_json.h"
#include "precompute/files/light_results.h"
#include "precompute/files/scene_io.h"
#include "precompute/files/terminal.h"

namespace fiatlux {
namespace {

struct EvaluateOptions {
  std::string scene, layout, patches;
  bool json = false;
};

void evaluate(const EvaluateOptions& options) {
  const LayoutFile file = orThrow(readLayoutFile(options.layout));
  const Scene scene = orThrow(readSceneFile(options.scene));
  std::vector<std::string> notes = file.notes;
  const Layout layout = orThrow(options.layout, layoutOnSites(file, scene, notes));
  for (const std::string& note : notes) printNote(options.layout + ": " + note);

  const LightResults results = lightResults(scene, layout);
  if (!options.patches.empty())
    writeFileAtomically(options.patches,
                        patchesCsv(scene.patches, scene.surfaces, illuminanceOf(scene, layout)));
  if (!options.json) {
    std::fputs(surfacesTable(results).c_str(), stdout);
    return;
  }
  nlohmann::ordered_json json = {{"identity", scene.identity}, {"surfaces", surfacesJson(results)}};
  json["all"] = surfaceJson(results.all);
  json["layout"] = layoutJson(layout, scene);
  double power = 0;
  for (double flux : layout.flux) power += layout.dimming * flux;
  json["power"] = power;
  std::puts(json.dump(2, ' ', false, nlohmann::json::error_handler_t::replace).c_str());
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
  command->add_flag("--json", options->json, "One JSON document on standard output");
  command->callback([options] { evaluate(*options); });
}

}  // namespace fiatlux
