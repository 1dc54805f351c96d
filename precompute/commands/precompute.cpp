// fiatlux precompute: glTF in, scene file out.
#include <CLI/CLI.hpp>
#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <nlohmann/json.hpp>
#include <sstream>

#include "core/scene/scene_file.h"
#include "precompute/base/error.h"
#include "precompute/base/parallel.h"
#include "precompute/commands/commands.h"
#include "precompute/commands/option_checks.h"
#include "precompute/commands/room_command_options.h"
#include "precompute/files/files_on_disk.h"
#include "precompute/files/scene_io.h"
#include "precompute/files/terminal.h"
#include "precompute/geometry/build_room.h"
#include "precompute/light/lost_rays.h"
#include "precompute/picture/display_mesh.h"
#include "precompute/pipeline/scene_build.h"

namespace fiatlux {
namespace {

using Json = nlohmann::ordered_json;

struct PrecomputeOptions {
  std::string source, output;
  RoomOptions room;
  TransportOptions transport;
};

/// The options that change the light, in words that never change: part of the room's identity.
std::string lightOptions(const PrecomputeOptions& options, const Room& room) {
  std::ostringstream text;
  text.precision(17);
  text << "patch=" << room.patchSize << " cluster=" << options.room.cluster
       << " rays=" << options.transport.rays << " refine=" << options.transport.refine
       << " paper=" << options.transport.paper << " seed=" << options.transport.seed
       << " spacing=" << options.room.siteSpacing << " size=" << options.room.siteSize
       << " scale=" << options.room.scale;
  for (const std::string& name : options.room.mounts) text << " mount=" << name.size() << ":" << name;
  for (const std::string& name : options.room.measures) text << " measure=" << name.size() << ":" << name;
  return text.str();
}

/// Surfaces of fewer patches are not covered by the promise that another ray seed moves sigma by at most 1 %:
/// over so few, too little averages out (docs/fidelity.md).
constexpr std::uint32_t kFewPatches = 100;

/// How the file is made, for `info`.
Json provenanceOf(const PrecomputeOptions& options, const Room& room, const Transport& transport) {
  Json json;
  json["program"] = "fiatlux 1.0.0";
  json["method"] = kMethodVersion;
  json["source"] = {{"file", std::filesystem::path(options.source).filename().string()},
                    {"hash", room.sourceHash}};
  json["patchSize"] = room.patchSize;
  json["options"] = {{"patch", options.room.patch},
                     {"cluster", options.room.cluster},
                     {"rays", options.transport.rays},
                     {"refine", options.transport.refine},
                     {"paper", options.transport.paper},
                     {"mount", options.room.mounts},
                     {"siteSpacing", options.room.siteSpacing},
                     {"siteSize", options.room.siteSize},
                     {"measure", options.room.measures},
                     {"scale", options.room.scale},
                     {"seed", options.transport.seed}};
  json["seconds"] = Json::object();
  for (const auto& [stage, seconds] : transport.seconds)
    json["seconds"][stage] = std::round(seconds * 1e3) / 1e3;
  double lost = 0, area = 0;
  for (std::size_t s = 0; s < room.surfaces.size(); ++s) {
    if (room.surfaces[s].measuring) continue;
    lost += room.surfaces[s].area * transport.lost[s];
    area += room.surfaces[s].area;
  }
  json["lost"] = area > 0 ? lost / area : 0;
  json["residuals"] = transport.residuals;
  json["peakMiB"] = std::round(bytesNeeded(countsOf(options.room, room)) / 1048576);
  json["fewPatches"] = Json::array();
  for (const Surface& surface : room.surfaces)
    if (!surface.measuring && surface.patches < kFewPatches) json["fewPatches"].push_back(surface.name);
  json["warnings"] = room.warnings;
  return json;
}

/// Seconds since the last call, rounded to milliseconds.
double lap(std::chrono::steady_clock::time_point& since) {
  const auto now = std::chrono::steady_clock::now();
  const std::chrono::duration<double> taken = now - since;
  since = now;
  return std::round(taken.count() * 1e3) / 1e3;
}

void precompute(PrecomputeOptions options) {
  if (options.output.empty())
    options.output = std::filesystem::path(options.source).replace_extension(".flux").string();
  std::error_code none;
  if (std::filesystem::equivalent(options.source, options.output, none))
    throw CommandError(options.output + ": this is the room itself; pass another file to --output");
  checkWritable(options.output);
  const auto start = std::chrono::steady_clock::now();
  auto clock = start;
  Progress progress;
  options.transport.progress = [&](const char* stage, double fraction) { progress.update(stage, fraction); };
  options.room.rays = options.transport.rays;
  options.room.paper = options.transport.paper;
  options.room.threads = threadCount(options.transport.threads);

  progress.update("reading", 0);
  const SourceScene source = orThrow(options.source, readSourceScene(options.source, options.room.scale));
  const double readingSeconds = lap(clock);
  progress.update("patches", 0);
  Room room = orThrow(options.source, buildRoom(source, options.room));
  for (const std::string& warning : source.warnings)
    if (std::find(room.warnings.begin(), room.warnings.end(), warning) == room.warnings.end())
      room.warnings.push_back(warning);
  const RayTracer tracer = orThrow(options.source, RayTracer::build(room));
  for (std::string& warning : warningsOfLostRays(room, tracer)) room.warnings.push_back(std::move(warning));
  progress.clear();
  for (const std::string& warning : room.warnings) printNote("warning: " + options.source + ": " + warning);
  const std::string identity = identityOf("fiatlux method " + std::to_string(kMethodVersion) + " source " +
                                          room.sourceHash + " " + lightOptions(options, room));
  const double patchSeconds = lap(clock);

  Transport transport = orThrow(options.source, computeTransport(room, options.transport));
  Json provenance = provenanceOf(options, room, transport);
  lap(clock);
  progress.update("display mesh", 0);
  std::vector<std::uint8_t> display = displayMesh(source, room);
  provenance["seconds"]["reading"] = readingSeconds;
  provenance["seconds"]["patches"] = patchSeconds;
  provenance["seconds"]["display mesh"] = lap(clock);

  progress.update("scene file", 0);
  const Scene scene = sceneOf(room, transport, identity);
  const PaperTransport* paper = transport.paper ? &*transport.paper : nullptr;
  provenance["seconds"]["before the file"] =
      std::round(std::chrono::duration<double>(clock - start).count() * 1e3) / 1e3;
  FileErrors errors;
  const std::vector<std::uint8_t> file = orThrow(
      options.source, buildSceneFile({scene, std::move(display), &provenance, paper, zlibDeflate}, errors));
  writeFileAtomically(options.output, file);
  progress.clear();

  const std::chrono::duration<double> total = std::chrono::steady_clock::now() - start;
  std::printf("%s: %u patches, %u clusters, %zu sites, %zu surfaces, %.2f MB, identity %s, %.1f s\n",
              options.output.c_str(), room.patches.count, room.patches.clusterCount, room.sites.size(),
              room.surfaces.size(), static_cast<double>(file.size()) / 1e6, identity.c_str(), total.count());
  std::printf(
      "light lost %.3f %%, residual %.2g, statistics within %.2g, patch light within %.2f %% RMS (median)\n",
      100 * provenance["lost"].get<double>(), transport.residuals.empty() ? 0.0 : transport.residuals.back(),
      std::max(errors.mean, errors.sigma), 100 * errors.patchRmsMedian);
}

}  // namespace

void addPrecomputeCommand(CLI::App& app) {
  auto o = std::make_shared<PrecomputeOptions>();
  CLI::App* command = app.add_subcommand("precompute", "glTF in, scene file out");
  addRoomOptions(*command, o->source, o->room, {o->transport.rays, o->transport.seed, o->transport.threads});
  command->add_option("-o,--output", o->output, "The scene file (.flux; default: the room's name)");
  command->add_option("--cluster", o->room.cluster, "Patches on a cluster's edge")
      ->check(wholeFrom(1, 64))
      ->capture_default_str();
  command->add_option("--refine", o->transport.refine, "Refinement steps after the low-rank answer")
      ->check(wholeFrom(0, 100))
      ->capture_default_str();
  command->add_flag("--paper", o->transport.paper,
                    "The paper's formulation to the letter, with Y, V and k x k covariances");
  command->callback([o] { precompute(*o); });
}

}  // namespace fiatlux
