// fiatlux light: the forward truth. Luminaires anywhere, no mount, no scene file, refined until converged.
#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstdio>
#include <memory>
#include <nlohmann/json.hpp>

#include "core/transport/room_view.h"
#include "precompute/base/error.h"
#include "precompute/base/json_text.h"
#include "precompute/commands/commands.h"
#include "precompute/commands/light_report.h"
#include "precompute/files/command_host.h"
#include "precompute/files/files_on_disk.h"
#include "precompute/files/layout_json.h"
#include "precompute/light/measuring_grid.h"
#include "precompute/program/room_command_options.h"

namespace fiatlux {
namespace {

constexpr double kMuchLost = 0.01;  // of the light, directly: worth a warning

struct LightOptions {
  std::string source, layout, points, patches;
  RoomOptions room;
  ForwardOptions forward;
  bool json = false, grid = false, verbose = false;
};

std::vector<MeasuringPoint> pointsOf(const LightOptions& options) {
  if (options.points.empty()) return {};
  const std::vector<std::uint8_t> bytes = orThrow(readFileBytes(options.points));
  return orThrow(options.points, parsePoints(std::string(bytes.begin(), bytes.end())));
}

/// The options for a room that a layout is known for: what its luminaires light is a part of it.
RoomOptions roomOptions(const LightOptions& options, const LayoutFile& file) {
  RoomOptions room = options.room;
  room.requireSites = std::any_of(file.luminaires.begin(), file.luminaires.end(),
                                  [](const LayoutEntry& entry) { return entry.site && !entry.free; });
  room.rays = options.forward.rays;
  for (const LayoutEntry& entry : file.luminaires)
    if (entry.free) room.luminaires.push_back(*entry.free);
  return room;
}

void warnOf(const LightOptions& options, const ForwardLight& light) {
  if (light.residual > options.forward.tolerance) {
    char line[120];
    std::snprintf(line, sizeof line,
                  "warning: %.2g %% of the reflected light is still missing after %u steps, and results are "
                  "off by about as much",
                  100 * light.residual, light.steps);
    printNote(line);
  }
  if (light.energy.lostDirect > kMuchLost * light.energy.emitted)
    printNote("warning: " + options.layout +
              ": more than 1 % of the light leaves the room or meets backs at once; does a luminaire hang "
              "outside, or within something?");
}

void light(LightOptions options) {
  // Everything that may be refused at once, before an hour of work.
  const LayoutFile file = orThrow(readLayoutFile(options.layout));
  options.forward.directOnly |= file.directOnly;
  if (!file.planes.empty() && options.forward.directOnly)
    throw CommandError(options.layout + ": \"planes\" are told of all light; drop them or \"quantity\"");
  if (!file.taskAreas.empty())
    throw CommandError(options.layout + ": \"taskAreas\" are of a scene file; give them to fiatlux evaluate");
  std::vector<MeasuringPoint> points = pointsOf(options);
  if (!options.patches.empty()) orThrow(checkReplaceable(options.patches));

  TerminalProgress progress;
  const Host host = commandHost(options.source, options.forward.threads, progress, options.verbose);
  options.forward.progress = &progress;
  const ModelFile model = orThrow(options.source, modelAt(options.source));
  auto [source, room, tracer] = orThrow(options.source, openRoom(model, roomOptions(options, file), host));
  setReflectance(orThrow(options.layout, paintOnLeaves(file.paint, room.surfaces)), room.patches,
                 room.surfaces);
  const std::vector<Luminaire> luminaires = orThrow(options.layout, freeLuminaires(file, room.sites));

  const double before = progress.total();
  const std::vector<Observer> observers = observersFor(file.observers, room.patches);
  if (!observers.empty()) orThrow(options.layout, checkLuminousAreas(luminaires));
  const std::vector<PlaneWish> wishes = orThrow(options.layout, planeWishes(file.planes, room.surfaces));
  const ForwardLight light =
      orThrow(options.source, computeForwardLight(room, tracer, luminaires, options.forward));
  LightReport report{room, light, options.forward.directOnly, std::move(points), {}, {}, {}, {}, {}, 0};
  report.seconds = progress.total() - before;

  // Read what was asked for off the light.
  PointOptions reading;
  reading.seed = options.forward.seed;
  reading.threads = options.forward.threads;
  const std::vector<float> radiosity = report.directOnly ? std::vector<float>{} : light.radiosity;
  report.readings = readPoints(room, tracer, report.points, luminaires, radiosity, reading);
  report.observers = observers;
  report.seen = observerReadings(room, tracer, report.observers, luminaires, radiosity, reading);
  report.planes =
      orThrow(options.layout, planeReadings(room, tracer, wishes, luminaires, radiosity, reading));
  if (options.grid) report.grids = readGrids(room, tracer, luminaires, radiosity, light.illuminance, reading);
  progress.clear();
  warnOf(options, light);
  if (!options.patches.empty())
    orThrow(replaceFile(options.patches, patchesCsv(room.patches, room.surfaces, light.illuminance)));
  if (!options.json) return printLightReport(report);
  std::fputs(jsonDocument(lightReportJson(report)).c_str(), stdout);
}

}  // namespace

void addLightCommand(CLI::App& app) {
  auto o = std::make_shared<LightOptions>();
  CLI::App* command =
      app.add_subcommand("light", "What luminaires anywhere do to a room, refined until converged");
  addRoomOptions(*command, o->source, o->room, {o->forward.rays, o->forward.seed, o->forward.threads},
                 o->verbose);
  command->add_option("--layout", o->layout, "Luminaires, free or on the room's sites (layout.json)")
      ->required();
  command->add_option("--points", o->points, "Read the light at the points x,y,z,nx,ny,nz of this .csv");
  command->add_option("--patches", o->patches, "Write the light of every patch to this .csv");
  command->add_flag("--grid", o->grid,
                    "E_m, E_min and U_o on the EN 12464-1 grid of floors and measuring planes");
  command->add_flag("--direct-only", o->forward.directOnly, "No reflections (emergency lighting)");
  command->add_flag("--json", o->json, "One JSON document on standard output");
  command->callback([o] { light(*o); });
}

}  // namespace fiatlux
