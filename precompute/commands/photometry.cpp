// fiatlux photometry: what a maker's photometric file says of a luminaire, and what follows from its table.
#include "core/photometry/photometry.h"

#include <CLI/CLI.hpp>
#include <cstdio>
#include <memory>
#include <nlohmann/json.hpp>

#include "core/photometry/photometric_description.h"
#include "precompute/base/error.h"
#include "precompute/base/json_text.h"
#include "precompute/commands/commands.h"
#include "precompute/files/files_on_disk.h"
#include "precompute/files/terminal.h"

namespace fiatlux {
namespace {

using Json = nlohmann::ordered_json;

/// null for what is not known.
Json orNull(const std::optional<double>& value) { return value ? Json(*value) : Json(); }

Json cardOf(const Photometry& photometry) {
  const LuminousArea& area = photometry.luminous;
  const PhotometricDescription description = describe(photometry);
  return {{"name", photometry.name},
          {"maker", photometry.maker},
          {"format", nameOf(photometry.format)},
          {"flux", photometry.flux},
          {"integratedFlux", description.integratedFlux},
          {"watts", photometry.watts},
          {"efficacy", orNull(description.efficacy)},
          {"cct", orNull(photometry.cct)},
          {"luminous",
           {{"length", area.length}, {"width", area.width}, {"height", area.height}, {"round", area.round}}},
          {"longAxis", photometry.longAxis == PhotometricAxis::kC0 ? "C0" : "C90"},
          {"symmetry", nameOf(photometry.symmetry)},
          {"maxCandela", description.maxCandela},
          {"beamAngle", description.beamAngle},
          {"fieldAngle", description.fieldAngle},
          {"upwardShare", description.upwardShare},
          {"ugr4h8h", orNull(description.ugr4h8h)},
          {"warnings", photometry.warnings}};
}

/// "12.3 lm", or a dash.
std::string withUnit(const Json& value, const char* unit, const char* format = "%.4g") {
  if (value.is_null()) return "-";
  char text[64];
  std::snprintf(text, sizeof text, format, value.get<double>());
  return std::string(text) + unit;
}

std::string sizeOf(const Json& card) {
  const Json& area = card["luminous"];
  std::string text = withUnit(area["length"], " m") + " x " + withUnit(area["width"], " m");
  if (area["height"] > 0) text += " x " + withUnit(area["height"], " m high");
  return text + (area["round"].get<bool>() ? ", round" : "") + ", length along " +
         card["longAxis"].get<std::string>();
}

void printCard(const Json& card) {
  const auto line = [](const char* what, const std::string& value) {
    std::printf("%-12s %s\n", what, value.c_str());
  };
  const auto text = [&](const char* key) { return printable(card[key].get<std::string>()); };
  line("luminaire", text("name").empty() ? "-" : text("name"));
  line("maker", text("maker").empty() ? "-" : text("maker"));
  line("format", text("format") + ", symmetry " + text("symmetry"));
  line("flux", withUnit(card["integratedFlux"], " lm in the table, ") + withUnit(card["flux"], " lm stated"));
  line("power", withUnit(card["watts"], " W, ") + withUnit(card["efficacy"], " lm/W"));
  line("colour", withUnit(card["cct"], " K", "%.0f"));
  line("luminous", sizeOf(card));
  line("intensity", withUnit(card["maxCandela"], " cd at most"));
  line("beam", withUnit(card["beamAngle"], " degrees at 50 %, ", "%.1f") +
                   withUnit(card["fieldAngle"], " degrees at 10 %", "%.1f"));
  line("upwards", withUnit(100 * card["upwardShare"].get<double>(), " %"));
  line("UGR 4H 8H", withUnit(card["ugr4h8h"], "", "%.1f"));
  for (const Json& warning : card["warnings"]) line("warning", printable(warning.get<std::string>()));
}

void tell(const std::string& path, bool json) {
  const std::vector<std::uint8_t> bytes = orThrow(readFileBytes(path));
  const Json card = cardOf(orThrow(path, readPhotometry(bytes)));
  if (json)
    std::fputs(jsonDocument(card).c_str(), stdout);
  else
    printCard(card);
}

}  // namespace

void addPhotometryCommand(CLI::App& app) {
  struct Options {
    std::string file;
    bool json = false;
  };
  auto options = std::make_shared<Options>();
  CLI::App* command =
      app.add_subcommand("photometry", "What a photometric file (.ies or .ldt) says of a luminaire");
  command->add_option("file", options->file, "Photometric file: LM-63 (.ies) or EULUMDAT (.ldt)")->required();
  command->add_flag("--json", options->json, "One JSON document on standard output");
  command->callback([options] { tell(options->file, options->json); });
}

}  // namespace fiatlux
