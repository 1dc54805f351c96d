#include "precompute/commands/light_report.h"

#include <cstdio>
#include <nlohmann/json.hpp>

#include "precompute/files/observers_json.h"
#include "precompute/files/planes_json.h"
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
  if (report.grids) json["grids"] = gridsJson(report.room.surfaces, *report.grids);
  if (!report.observers.empty()) json["observers"] = observersJson(report.observers, report.seen);
  if (!report.planes.empty()) json["planes"] = planesJson(report.room.surfaces, report.planes);
  return json;
}

void printLightReport(const LightReport& report) {
  std::fputs(surfacesTable(resultsOf(report)).c_str(), stdout);
  std::printf(
      "\n%u patches of about %.3g m (sigma, least and uniformity depend on that size); residual %.2g after "
      "%u steps\n",
      report.room.patches.count, report.room.patchSize, report.light.residual, report.light.steps);
  printEnergy(report);
  if (report.grids) std::fputs(gridLines(report.room.surfaces, *report.grids).c_str(), stdout);
  std::fputs(observersText(report.observers, report.seen).c_str(), stdout);
  std::fputs(planesText(report.room.surfaces, report.planes).c_str(), stdout);
  if (!report.points.empty()) std::printf("\n%s", pointsCsv(report.points, report.readings).c_str());
}

}  // namespace fiatlux
