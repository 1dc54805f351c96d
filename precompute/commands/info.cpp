// fiatlux info: what is in a scene file and how it was made.
#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstdio>
#include <memory>
#include <nlohmann/json.hpp>

#include "precompute/base/error.h"
#include "precompute/base/json_text.h"
#include "precompute/commands/commands.h"
#include "precompute/files/files_on_disk.h"
#include "precompute/files/scene_io.h"
#include "precompute/files/terminal.h"

namespace fiatlux {
namespace {

using Json = nlohmann::ordered_json;

/// The file's account of its own making; an empty object where it has none. Of a person's making, so never
/// relied on.
nlohmann::json provenanceOf(std::span<const std::uint8_t> file, const SceneTable& table) {
  const SceneSection* section = table.find("provenance");
  if (!section) return nlohmann::json::object();
  const std::vector<std::uint8_t> bytes = orThrow(inflateSection(file, *section));
  Result<nlohmann::json> json = parseJson(std::string(bytes.begin(), bytes.end()));
  return json && json->is_object() ? std::move(json.value()) : nlohmann::json::object();
}

/// What a file holds for other photometries than that of its responses.
Json exchangeJson(const SceneTable& table, const LightOperator& op) {
  std::uint64_t visibility = 0, exchange = 0;
  for (const SceneSection& section : table.sections) {
    const std::string name = section.name.substr(0, section.name.find('.'));
    if (name == "siteVisibility") visibility += section.storedBytes;
    for (const char* part :
         {"charts", "chartFrames", "chartAspects", "groups", "exchange", "exchangeRest", "surfaceExchange"})
      if (name == part) exchange += section.storedBytes;
  }
  return {{"groups", op.groups.total}, {"visibilityBytes", visibility}, {"exchangeBytes", exchange}};
}

/// Everything, as --json prints it and as the table is made of.
Json infoOf(const std::string& path) {
  const std::vector<std::uint8_t> file = orThrow(readFileBytes(path));
  const SceneTable table = orThrow(path, readSceneTable(file));
  const Scene scene = orThrow(path, readScene(file));
  for (const SceneSection& section : table.sections) orThrow(path, inflateSection(file, section));
  Json json;
  json["identity"] = scene.identity;
  json["version"] = table.version;
  json["bytes"] = file.size();
  json["patches"] = table.counts.patches;
  json["clusters"] = table.counts.clusters;
  json["sites"] = table.counts.sites;
  json["receivers"] = table.counts.receivers;
  std::vector<double> covered(scene.surfaces.size());
  for (std::uint32_t p = 0; p < scene.patches.rows(); ++p)
    if (!scene.patches.counts(p)) covered[scene.patches.surface[p]] += scene.patches.area[p];
  json["surfaces"] = Json::array();
  for (std::size_t s = 0; s < scene.surfaces.size(); ++s) {
    const Surface& surface = scene.surfaces[s];
    json["surfaces"].push_back({{"name", surface.name},
                                {"patches", surface.patches},
                                {"area", surface.area},
                                {"covered", covered[s]},
                                {"reflectance", surface.reflectance},
                                {"lost", surface.lost},
                                {"measuring", surface.measuring},
                                {"errorBound", scene.errorBound[s]}});
  }
  json["sections"] = Json::array();
  for (const SceneSection& section : table.sections)
    json["sections"].push_back({{"name", section.name},
                                {"bytes", section.storedBytes},
                                {"inflated", section.inflatedBytes},
                                {"errorBound", section.errorBound}});
  if (scene.lightOperator) json["exchange"] = exchangeJson(table, *scene.lightOperator);
  // note: whoever made the file wrote this; it never replaces what was read off the file
  const nlohmann::json provenance = provenanceOf(file, table);
  for (const auto& item : provenance.items())
    if (!json.contains(item.key())) json[item.key()] = item.value();
  if (!json.contains("seconds")) json["seconds"] = Json::object();
  return json;
}

/// A member of the provenance that may be missing or of any type, in one line.
std::string textOf(const Json& json, const char* key) {
  if (!json.contains(key)) return "";
  const Json& value = json[key];
  if (value.is_string()) return printable(value.get<std::string>());
  std::string text;
  if (value.is_object() || value.is_array()) {
    for (const auto& item : value.items()) {
      char number[32] = "";
      if (item.value().is_number()) std::snprintf(number, sizeof number, "%.4g", item.value().get<double>());
      const std::string shown = *number                    ? number
                                : item.value().is_string() ? item.value().get<std::string>()
                                                           : jsonText(item.value());
      text += (text.empty() ? "" : ", ") + (value.is_object() ? item.key() + " " : std::string()) + shown;
    }
    return printable(text);
  }
  return printable(jsonText(value));
}

/// Bytes of the light operator, and how far light by it is from the whole solution.
void printExchange(const Json& json) {
  if (!json.contains("exchange")) return;
  const Json& exchange = json["exchange"];
  std::printf("%-10s %u groups, visibility %llu + exchange %llu bytes\n", "exchange",
              exchange["groups"].get<unsigned>(), exchange["visibilityBytes"].get<unsigned long long>(),
              exchange["exchangeBytes"].get<unsigned long long>());
  if (!json.contains("exchangeErrors") || !json["exchangeErrors"].is_object()) return;
  for (const auto& item : json["exchangeErrors"].items())
    std::printf("%-10s   %s: %s\n", "", printable(item.key()).c_str(),
                textOf(json["exchangeErrors"], item.key().c_str()).c_str());
}

void printTable(const std::string& path, const Json& json) {
  const auto count = [&](const char* key) { return json[key].get<unsigned>(); };
  std::printf("%s: identity %s, version %u, %.2f MB\n", path.c_str(),
              json["identity"].get<std::string>().c_str(), count("version"),
              json["bytes"].get<double>() / 1e6);
  std::printf("%u patches, %u clusters, %u sites, %u receivers\n\n", count("patches"), count("clusters"),
              count("sites"), count("receivers"));
  std::printf("%-32s %8s %10s %10s %12s %8s\n", "surface", "patches", "area m2", "covered m2", "reflectance",
              "lost");
  for (const Json& s : json["surfaces"])
    std::printf("%-32s %8u %10.3f %10.3f %12.3f %7.3f%%%s\n",
                printable(s["name"].get<std::string>(), 60).c_str(), s["patches"].get<unsigned>(),
                s["area"].get<double>(), s["covered"].get<double>(), s["reflectance"].get<double>(),
                100 * s["lost"].get<double>(), s["measuring"].get<bool>() ? "  (measuring plane)" : "");
  std::printf("\n%-32s %12s %12s\n", "section", "bytes", "inflated");
  for (const Json& s : json["sections"])
    std::printf("%-32s %12llu %12llu\n", s["name"].get<std::string>().c_str(),
                s["bytes"].get<unsigned long long>(), s["inflated"].get<unsigned long long>());
  std::puts("");
  for (const char* key :
       {"source", "options", "patchSize", "seconds", "lost", "residuals", "ranks", "errors", "peakMiB"})
    if (const std::string text = textOf(json, key); !text.empty())
      std::printf("%-10s %s\n", key, text.c_str());
  printExchange(json);
  if (const std::string names = textOf(json, "fewPatches"); !names.empty())
    std::printf("%-10s too few patches, sigma may move by more than 1 %% with the ray seed: %s\n", "note",
                names.c_str());
  if (json.contains("warnings") && json["warnings"].is_array())
    for (const Json& warning : json["warnings"])
      if (warning.is_string())
        std::printf("%-10s %s\n", "warning", printable(warning.get<std::string>()).c_str());
}

}  // namespace

void addInfoCommand(CLI::App& app) {
  struct Options {
    std::string scene;
    bool json = false;
  };
  auto options = std::make_shared<Options>();
  CLI::App* command = app.add_subcommand("info", "What is in a scene file, and how it was made");
  command->add_option("scene", options->scene, "Scene file (.flux)")->required();
  command->add_flag("--json", options->json, "One JSON document on standard output");
  command->callback([options] {
    const Json json = infoOf(options->scene);
    if (options->json)
      std::fputs(jsonDocument(json).c_str(), stdout);
    else
      printTable(options->scene, json);
  });
}

}  // namespace fiatlux
