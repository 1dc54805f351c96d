#include "precompute/pipeline/provenance.h"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <sstream>

#include "precompute/base/json_text.h"
#include "precompute/base/version.h"

namespace fiatlux {
namespace {

using Json = nlohmann::ordered_json;

/// Surfaces of fewer patches are not covered by the promise that another ray seed moves sigma by at most 1 %:
/// over so few, too little averages out (docs/fidelity.md).
constexpr std::uint32_t kFewPatches = 100;

constexpr double kMiB = 1 << 20;

const char* nameOf(PlaceOptions::Lid lid) {
  return lid == PlaceOptions::Lid::kNone ? "none" : lid == PlaceOptions::Lid::kDark ? "dark" : "white";
}

/// The options that change the light, in words that never change.
std::string lightOptions(const SceneOptions& options, const Room& room) {
  std::ostringstream text;
  text.precision(17);
  text << "patch=" << room.patchSize << " cluster=" << options.room.cluster
       << " rays=" << options.transport.rays << " refine=" << options.transport.refine
       << " paper=" << options.transport.paper << " seed=" << options.transport.seed
       << " spacing=" << options.room.siteSpacing << " size=" << options.room.siteSize
       << " scale=" << room.scale;
  if (options.room.drop > 0) text << " drop=" << options.room.drop;
  for (const std::string& name : options.room.mounts) text << " mount=" << name.size() << ":" << name;
  for (const std::string& name : options.room.measures) text << " measure=" << name.size() << ":" << name;
  if (options.room.doubleSided) text << " double-sided";
  if (room.isZUp) text << " up=z";
  if (options.room.plane > 0)
    text << " working-plane=" << options.room.plane << " rim=" << options.room.planeRim;
  for (const auto& [material, value] : options.room.reflectances)
    text << " reflectance=" << material.size() << ":" << material << "=" << value;
  if (const PlaceOptions& place = options.room.place; place.inside)
    text << " inside=" << place.inside->x << "," << place.inside->y << "," << place.inside->z
         << " doors=" << place.doors << " lid=" << nameOf(place.lid);
  if (options.draft) text << " draft";
  text << room.assumptions;
  return text.str();
}

Json reflectancesJson(const std::vector<NamedReflectance>& reflectances) {
  Json json = Json::object();
  for (const auto& [material, value] : reflectances) json[material] = value;
  return json;
}

Json placeJson(const PlaceOptions& place) {
  return {{"inside", {place.inside->x, place.inside->y, place.inside->z}},
          {"doors", place.doors},
          {"lid", nameOf(place.lid)}};
}

Json optionsJson(const SceneOptions& options, const Room& room) {
  return {{"patch", options.room.patch},
          {"cluster", options.room.cluster},
          {"rays", options.transport.rays},
          {"refine", options.transport.refine},
          {"paper", options.transport.paper},
          {"mount", options.room.mounts},
          {"siteSpacing", options.room.siteSpacing},
          {"siteSize", options.room.siteSize},
          {"drop", options.room.drop},
          {"measure", options.room.measures},
          {"ceiling", options.room.ceiling},
          {"plane", options.room.plane},
          {"planeRim", options.room.planeRim},
          {"up", room.isZUp ? "z" : "y"},
          {"reflectance", reflectancesJson(options.room.reflectances)},
          {"doubleSided", options.room.doubleSided},
          {"scale", room.scale},
          {"seed", options.transport.seed}};
}

Json secondsJson(const std::vector<StageSeconds>& stages) {
  const auto rounded = [](double seconds) { return std::round(seconds * 1e3) / 1e3; };
  Json json = Json::object();
  double total = 0;
  for (const auto& [stage, seconds] : stages) {
    json[stage] = rounded(seconds);
    total += seconds;
  }
  if (!stages.empty()) json["before the file"] = rounded(total);
  return json;
}

Json fewPatches(const Room& room) {
  Json names = Json::array();
  for (const Surface& surface : room.surfaces)
    if (!surface.measuring && surface.patches < kFewPatches) names.push_back(surface.name);
  return names;
}

}  // namespace

std::string identityOf(const SceneOptions& options, const Room& room) {
  return identityOf("fiatlux method " + std::to_string(kMethodVersion) + " source " + room.sourceHash + " " +
                    lightOptions(options, room));
}

double lostShare(const Room& room, const Transport& transport) {
  double lost = 0, area = 0;
  for (std::size_t s = 0; s < room.surfaces.size(); ++s) {
    if (room.surfaces[s].measuring) continue;
    lost += room.surfaces[s].area * transport.lost[s];
    area += room.surfaces[s].area;
  }
  return area > 0 ? lost / area : 0;
}

std::string provenanceOf(const Account& account) {
  const auto& [source, plan, options, room, report, ranks, seconds] = account;
  Json json;
  json["program"] = programVersion();
  json["method"] = kMethodVersion;
  json["source"] = {{"file", source.substr(source.rfind('/') + 1)}, {"hash", room.sourceHash}};
  if (!plan.empty()) json["plan"] = Json::parse(plan);
  json["patchSize"] = room.patchSize;
  json["options"] = optionsJson(options, room);
  if (options.room.place.inside) json["options"]["place"] = placeJson(options.room.place);
  json["seconds"] = secondsJson(seconds);
  json["lost"] = report.lost;
  json["lostLight"] = std::max(0.0, 1 - report.balance.absorbed);
  if (!report.useless.empty()) json["useless"] = report.useless;
  if (!report.ask.surface.empty())
    json["ask"] = {{"surface", report.ask.surface},
                   {"mean", report.ask.mean},
                   {"count", report.ask.count},
                   {"apart", report.ask.apart}};
  json["residuals"] = report.residuals;
  json["peakMiB"] = std::round(bytesNeeded(countsOf(options.room, room)) / kMiB);
  json["fewPatches"] = fewPatches(room);
  json["warnings"] = room.warnings;
  json["ranks"] = ranks;
  json["errors"] = {{"mean", report.errors.mean},
                    {"sigma", report.errors.sigma},
                    {"patchRmsMedian", report.errors.patchRmsMedian},
                    {"patchRmsWorst", report.errors.patchRmsWorst}};
  for (const OperatorError& error : report.operatorErrors)
    json["exchangeErrors"][error.photometry] = {{"meanMedian", error.meanMedian},
                                                {"meanWorst", error.meanWorst},
                                                {"sigmaMedian", error.sigmaMedian},
                                                {"sigmaWorst", error.sigmaWorst}};
  return jsonText(json);
}

}  // namespace fiatlux
