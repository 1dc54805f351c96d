// fiatlux surfaces: what surfaces a model has, and where luminaires would hang, before anything is computed.
#include <CLI/CLI.hpp>
#include <cstdio>
#include <memory>
#include <nlohmann/json.hpp>

#include "precompute/base/error.h"
#include "precompute/base/json_text.h"
#include "precompute/commands/commands.h"
#include "precompute/files/command_host.h"
#include "precompute/program/room_command_options.h"

namespace fiatlux {
namespace {

using Json = nlohmann::ordered_json;
using Facing = SurveyedSurface::Facing;
using Use = SurveyedSurface::Use;

struct SurfacesOptions {
  std::string source;
  RoomOptions room;
  bool json = false, verbose = false;
};

const char* nameOf(Facing facing) {
  switch (facing) {
    case Facing::kUp:
      return "up";
    case Facing::kDown:
      return "down";
    case Facing::kSideways:
      return "sideways";
    case Facing::kAllWays:
      break;
  }
  return "all ways";
}

const char* nameOf(Use use) {
  switch (use) {
    case Use::kMount:
      return "mount";
    case Use::kFloor:
      return "floor";
    case Use::kMeasuringPlane:
      return "measuring plane";
    case Use::kNone:
      break;
  }
  return "";
}

Json jsonOf(const Survey& survey) {
  Json json = {{"surfaces", Json::array()}, {"warnings", survey.warnings}};
  for (const SurveyedSurface& s : survey.surfaces)
    json["surfaces"].push_back({{"name", s.name},
                                {"area", s.area},
                                {"low", s.low},
                                {"high", s.high},
                                {"tilt", s.tilt},
                                {"faces", nameOf(s.facing)},
                                {"use", nameOf(s.use)}});
  return json;
}

void printTable(const Survey& survey) {
  std::printf("%-40s %10s %9s %9s %6s  %-9s %s\n", "surface", "area m2", "from m", "to m", "tilt", "faces",
              "good as");
  for (const SurveyedSurface& s : survey.surfaces)
    std::printf("%-40s %10.2f %9.2f %9.2f %6.0f  %-9s %s\n", printable(s.name, 60).c_str(), s.area, s.low,
                s.high, s.tilt, nameOf(s.facing), nameOf(s.use));
}

void listSurfaces(const SurfacesOptions& options) {
  TerminalProgress progress;
  const Host host = commandHost(options.source, 1, progress, options.verbose);
  const ModelFile model = orThrow(options.source, modelAt(options.source));
  const Survey survey = orThrow(options.source, surveyModel(model, options.room, host));
  if (options.json) {
    std::fputs(jsonDocument(jsonOf(survey)).c_str(), stdout);
    return;
  }
  printWarnings(options.source, survey.warnings, options.verbose);
  printTable(survey);
}

}  // namespace

void addSurfacesCommand(CLI::App& app) {
  auto o = std::make_shared<SurfacesOptions>();
  CLI::App* command = app.add_subcommand(
      "surfaces", "What surfaces a model has, and where luminaires would hang, before anything is computed");
  addModelOptions(*command, o->source, o->room, o->verbose);
  command->add_flag("--json", o->json, "One JSON document on standard output");
  command->callback([o] { listSurfaces(*o); });
}

}  // namespace fiatlux
