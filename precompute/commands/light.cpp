// fiatlux light: the forward truth. Luminaires anywhere, no mount, no scene file, refined until converged.
#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstdio>
#include <memory>
#include <nlohmann/json.hpp>

#include "precompute/base/error.h"
#include "precompute/commands/commands.h"
#include "precompute/commands/room_command_options.h"
#include "precompute/files/files_on_disk.h"
#include "precompute/files/layout_json.h"
#include "precompute/files/light_results.h"
#include "precompute/files/terminal.h"
#include "precompute/geometry/build_room.h"
#include "precompute/geometry/room_options.h"
#include "precompute/gltf/source_scene.h"
#include "precompute/light/forward_light.h"
#include "precompute/light/lost_rays.h"
#include "precompute/light/measuring_grid.h"
#include "precompute/light/point_light.h"

namespace fiatlux {
namespace {

using Json = nlohmann::ordered_json;

struct LightOptions {
  std::string source, layout, points, patches;
  RoomOptions room;
  ForwardOptions forward;
  bool json = false, grid = false;
};

Room readRoom(const LightOptions& options, Progress& progress) {
  progress.update("reading", 0);
  const SourceScene source = orThrow(options.source, readSourceScene(options.source, options.room.scale));
  Room room = orThrow(options.source, buildRoom(source, options.room));
  progress.clear();
  for (const std::string& warning : room.warnings) printNote("warning: " + options.source + ": " + warning);
  return room;
}

Json pointsJson(const std::vector<MeasuringPoint>& points, const std::vector<PointReading>& readings) {
  Json json = Json::array();
  for (std::size_t i = 0; i < points.size(); ++i) {
    const auto& [p, n] = points[i];
    const PointReading& r = readings[i];
    json.push_back(
        {{"position", {p.x, p.y, p.z}},
         {"normal", {n.x, n.y, n.z}},
         {"direct", r.direct},
         {"total", r.total},
         {"cylindrical", r.cylindrical},
         {"vertical",
          {{"+x", r.vertical[0]}, {"-x", r.vertical[1]}, {"+z", r.vertical[2]}, {"-z", r.vertical[3]}}}});
  }
  return json;
}

struct GridResult {
  MeasuringGrid grid;
  double mean = 0, least = 0;
};

std::vector<GridResult> readGrids(const Room& room, const RayTracer& tracer,
                                  const std::vector<Luminaire>& luminaires,
                                  const std::vector<float>& radiosity, PointOptions options) {
  options.spatial = false;
  std::vector<GridResult> results;
  for (MeasuringGrid& grid : measuringGrids(room)) {
    const std::vector<PointReading> readings =
        readPoints(tracer, grid.points, luminaires, radiosity, options);
    GridResult result{std::move(grid), 0, readings[0].total};
    for (const PointReading& reading : readings) {
      result.mean += reading.total / static_cast<double>(readings.size());
      result.least = std::min(result.least, reading.total);
    }
    results.push_back(std::move(result));
  }
  return results;
}

Json gridsJson(const Room& room, const std::vector<GridResult>& grids) {
  Json json = Json::array();
  for (const auto& [grid, mean, least] : grids) {
    json.push_back({{"surface", room.surfaces[grid.surface].name},
                    {"points", grid.points.size()},
                    {"spacing", grid.spacing},
                    {"rim", grid.rim},
                    {"mean", mean},
                    {"min", least},
                    {"uniformity", mean > 0 ? least / mean : 0}});
  }
  return json;
}

Json energyJson(const EnergyBalance& energy) {
  return {{"emitted", energy.emitted},
          {"absorbed", energy.absorbed},
          {"lostDirect", energy.lostDirect},
          {"lostReflected", energy.lostReflected},
          {"imbalance", energy.imbalance}};
}

Json lostJson(const Room& room, const ForwardLight& light) {
  Json json = Json::array();
  for (std::size_t s = 0; s < room.surfaces.size(); ++s) {
    json.push_back({{"name", room.surfaces[s].name}, {"lost", light.lost[s]}});
  }
  return json;
}

void printReport(const Room& room, const ForwardLight& light, const LightResults& results) {
  std::fputs(surfacesTable(results).c_str(), stdout);
  const EnergyBalance& e = light.energy;
  std::printf(
      "\n%u patches of about %.3g m (sigma, least and uniformity depend on that size); residual %.2g after "
      "%u steps\n",
      room.patches.count, room.patchSize, light.residual, light.steps);
  std::printf(
      "energy: %.6g lm emitted = %.6g absorbed + %.6g lost directly + %.6g lost after reflection %+.3g (%.2f "
      "%%)\n",
      e.emitted, e.absorbed, e.lostDirect, e.lostReflected, e.imbalance,
      e.emitted > 0 ? 100 * e.imbalance / e.emitted : 0.0);
  for (std::size_t s = 0; s < room.surfaces.size(); ++s) {
    if (light.lost[s] < 0.0005) continue;
    std::printf("lost from %s: %.2f %% of its rays\n", printable(room.surfaces[s].name).c_str(),
                100 * light.lost[s]);
  }
}

void printGrids(const Room& room, const std::vector<GridResult>& grids) {
  for (const auto& [grid, mean, least] : grids) {
    std::printf(
        "grid on %s: %zu points, spacing at most %.2f m, rim %.1f m: E_m %.4g lx, E_min %.4g lx, U_o %.3f\n",
        printable(room.surfaces[grid.surface].name).c_str(), grid.points.size(), grid.spacing, grid.rim, mean,
        least, mean > 0 ? least / mean : 0.0);
  }
}

Json reportJson(const Room& room, const ForwardLight& light, const LightResults& results) {
  return {{"surfaces", surfacesJson(results)},
          {"all", surfaceJson(results.all)},
          {"patches", room.patches.count},
          {"patchSize", room.patchSize},
          {"residual", light.residual},
          {"steps", light.steps},
          {"energy", energyJson(light.energy)},
          {"lost", lostJson(room, light)},
          {"seconds", light.seconds}};
}

void warnOf(const LightOptions& options, const ForwardLight& light) {
  if (light.residual > options.forward.tolerance) {
    char line[120];
    std::snprintf(line, sizeof line, "warning: not converged, residual %.2g after %u steps", light.residual,
                  light.steps);
    printNote(line);
  }

  if (light.energy.lostDirect > 0.01 * light.energy.emitted)
    printNote("warning: " + options.layout +
              ": more than 1 % of the light leaves the room or meets backs at once; does a luminaire hang "
              "outside, or within something?");
}

void light(LightOptions options) {
  const LayoutFile file = orThrow(readLayoutFile(options.layout));
  for (const std::string& note : file.notes) printNote(options.layout + ": " + note);
  std::vector<MeasuringPoint> points;
  if (!options.points.empty()) {
    const std::vector<std::uint8_t> bytes = readFileBytes(options.points);
    points = orThrow(options.points, parsePoints(std::string(bytes.begin(), bytes.end())));
  }
  if (!options.patches.empty()) checkWritable(options.patches);
  Progress progress;
  options.forward.progress = [&](const char* stage, double fraction) { progress.update(stage, fraction); };
  options.room.requireSites = std::any_of(file.luminaires.begin(), file.luminaires.end(),
                                          [](const LayoutEntry& entry) { return entry.site && !entry.free; });
  options.room.rays = options.forward.rays;
  for (const LayoutEntry& entry : file.luminaires)
    if (entry.free) options.room.luminaires.push_back(*entry.free);
  const Room room = readRoom(options, progress);
  const std::vector<Luminaire> luminaires = orThrow(options.layout, freeLuminaires(file, room.sites));

  const RayTracer tracer = orThrow(options.source, RayTracer::build(room));
  for (const std::string& warning : warningsOfLostRays(room, tracer))
    printNote("warning: " + options.source + ": " + warning);
  ForwardLight light =
      orThrow(options.source, computeForwardLight(room, tracer, luminaires, options.forward));
  PointOptions pointOptions;
  pointOptions.seed = options.forward.seed;
  pointOptions.threads = options.forward.threads;
  const std::vector<float> radiosity = options.forward.directOnly ? std::vector<float>{} : light.radiosity;
  const std::vector<PointReading> readings = readPoints(tracer, points, luminaires, radiosity, pointOptions);
  std::vector<GridResult> grids;
  if (options.grid) grids = readGrids(room, tracer, luminaires, radiosity, pointOptions);
  progress.clear();
  warnOf(options, light);
  const LightResults results = lightResults(room.patches, room.surfaces, light.illuminance);
  if (!options.patches.empty()) {
    writeFileAtomically(options.patches, patchesCsv(room.patches, room.surfaces, light.illuminance));
  }
  if (!options.json) {
    printReport(room, light, results);
    printGrids(room, grids);
    if (!points.empty()) std::printf("\n%s", pointsCsv(points, readings).c_str());
    return;
  }
  Json json = reportJson(room, light, results);
  json["directOnly"] = options.forward.directOnly;
  if (!options.points.empty()) json["points"] = pointsJson(points, readings);
  if (options.grid) json["grids"] = gridsJson(room, grids);
  std::puts(json.dump(2, ' ', false, Json::error_handler_t::replace).c_str());
}

}  // namespace

void addLightCommand(CLI::App& app) {
  auto o = std::make_shared<LightOptions>();
  CLI::App* command =
      app.add_subcommand("light", "What luminaires anywhere do to a room, refined until converged");
  addRoomOptions(*command, o->source, o->room, {o->forward.rays, o->forward.seed, o->forward.threads});
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
