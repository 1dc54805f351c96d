#include "precompute/commands/light_report.h"

#include <cstdio>
#include <nlohmann/json.hpp>

#include "precompute/files/terminal.h"

namespace fiatlux {
namespace {

using Json = nlohmann::ordered_json;

constexpr double kLittleLost = 0.0005;  // of a surface's rays: not worth a line

LightResults resultsOf(const LightReport& report) {
  return lightResults(report.room.patches, report.room.surfaces, report.light.illuminance);
}

Json energyJson(const EnergyBalance& energy) {
  return {{"emitted", energy.emitted},
          {"absorbed", energy.absorbed},
          {"lostDirect", energy.lostDirect},
          {"lostReflected", energy.lostReflected},
          {"imbalance", energy.imbalance}};
}

Json lostJson(const LightReport& report) {
  Json json = Json::array();
  for (std::size_t s = 0; s < report.room.surfaces.size(); ++s) {
    json.push_back({{"name", report.room.surfaces[s].name}, {"lost", report.light.lost[s]}});
  }
  return json;
}

Json pointsJson(const LightReport& report) {
  Json json = Json::array();
  for (std::size_t i = 0; i < report.points.size(); ++i) {
    const auto& [p, n] = report.points[i];
    const PointReading& r = report.readings[i];
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

Json gridsJson(const LightReport& report) {
  Json json = Json::array();
  for (const GridReading& reading : *report.grids) {
    const MeasuringGrid& grid = reading.grid;
    json.push_back({{"surface", report.room.surfaces[grid.surface].name},
                    {"points", grid.points.size()},
                    {"spacing", grid.spacing},
                    {"rim", grid.rim},
                    {"mean", reading.mean},
                    {"min", reading.least},
                    {"uniformity", reading.uniformity()}});
  }
  return json;
}

void printEnergy(const LightReport& report) {
  const EnergyBalance& e = report.light.energy;
  std::printf(
      "energy: %.6g lm emitted = %.6g absorbed + %.6g lost directly + %.6g lost after reflection %+.3g (%.2f "
      "%%)\n",
      e.emitted, e.absorbed, e.lostDirect, e.lostReflected, e.imbalance,
      e.emitted > 0 ? 100 * e.imbalance / e.emitted : 0.0);
  for (std::size_t s = 0; s < report.room.surfaces.size(); ++s) {
    if (report.light.lost[s] < kLittleLost) continue;
    std::printf("lost from %s: %.2f %% of its rays\n", printable(report.room.surfaces[s].name).c_str(),
                100 * report.light.lost[s]);
  }
}

void printGrids(const LightReport& report) {
  for (const GridReading& reading : *report.grids) {
    const MeasuringGrid& grid = reading.grid;
    std::printf(
        "grid on %s: %zu points, spacing at most %.2f m, rim %.1f m: E_m %.4g lx, E_min %.4g lx, U_o %.3f\n",
        printable(report.room.surfaces[grid.surface].name).c_str(), grid.points.size(), grid.spacing,
        grid.rim, reading.mean, reading.least, reading.uniformity());
  }
}

}  // namespace

Json lightReportJson(const LightReport& report) {
  const LightResults results = resultsOf(report);
  Json json = {{"surfaces", surfacesJson(results)},
               {"all", surfaceJson(results.all)},
               {"patches", report.room.patches.count},
               {"patchSize", report.room.patchSize},
               {"residual", report.light.residual},
               {"steps", report.light.steps},
               {"energy", energyJson(report.light.energy)},
               {"lost", lostJson(report)},
               {"seconds", report.seconds},
               {"directOnly", report.directOnly}};
  if (!report.points.empty()) json["points"] = pointsJson(report);
  if (report.grids) json["grids"] = gridsJson(report);
  return json;
}

void printLightReport(const LightReport& report) {
  std::fputs(surfacesTable(resultsOf(report)).c_str(), stdout);
  std::printf(
      "\n%u patches of about %.3g m (sigma, least and uniformity depend on that size); residual %.2g after "
      "%u steps\n",
      report.room.patches.count, report.room.patchSize, report.light.residual, report.light.steps);
  printEnergy(report);
  if (report.grids) printGrids(report);
  if (!report.points.empty()) std::printf("\n%s", pointsCsv(report.points, report.readings).c_str());
}

}  // namespace fiatlux
