// fiatlux validate: the analytic cases through the real pipeline; status 2 if one fails.
#include <CLI/CLI.hpp>
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <memory>
#include <nlohmann/json.hpp>

#include "precompute/base/error.h"
#include "precompute/base/json_text.h"
#include "precompute/commands/commands.h"
#include "precompute/program/room_command_options.h"
#include "precompute/validation/validation.h"

namespace fiatlux {
namespace {

using Json = nlohmann::ordered_json;

struct ValidateOptions {
  ValidationOptions validation;
  bool json = false, markdown = false;
};

/// Errors and tolerances: percent where relative, as they are where absolute.
std::string errorText(const ValidationRow& row, double value) {
  char text[40];
  if (row.absolute) {
    std::snprintf(text, sizeof text, "%.2g", value);
  } else {
    std::snprintf(text, sizeof text, "%.3g %%", 100 * value);
  }
  return text;
}

/// In a cell of a Markdown table.
std::string inCell(const std::string& name) {
  std::string escaped;
  for (const char c : name) escaped += c == '|' ? std::string("\\|") : std::string(1, c);
  return escaped;
}

void printTable(const std::vector<ValidationRow>& rows, bool markdown) {
  std::string topic;
  for (const ValidationRow& row : rows) {
    const char* format =
        markdown ? "| %s | %.6g | %.6g | %s | %s | %s |\n" : "  %-62s %12.6g %12.6g %10s of %8s  %s\n";
    if (row.topic != topic) {
      topic = row.topic;
      std::printf(markdown ? "\n## %s\n\n| case | expected | got | error | tolerance | verdict "
                             "|\n|---|---|---|---|---|---|\n"
                           : "\n%s\n",
                  topic.c_str());
    }
    std::printf(format, (markdown ? inCell(row.name) : row.name).c_str(), row.expected, row.got,
                errorText(row, row.error).c_str(), errorText(row, row.tolerance).c_str(),
                row.passes() ? "pass" : "FAIL");
  }
}

void validate(const ValidateOptions& options) {
  const std::vector<ValidationRow> rows = validateAll(options.validation);
  const auto failed =
      std::count_if(rows.begin(), rows.end(), [](const ValidationRow& row) { return !row.passes(); });
  if (options.json) {
    Json cases = Json::array();
    for (const ValidationRow& row : rows) {
      // note: an infinite error (a case that could not run) becomes null.
      cases.push_back({{"topic", row.topic},
                       {"name", row.name},
                       {"expected", row.expected},
                       {"got", row.got},
                       {"error", row.error},
                       {"kind", row.absolute ? "absolute" : "relative"},
                       {"tolerance", row.tolerance},
                       {"verdict", row.passes() ? "pass" : "fail"}});
    }
    const Json json = {{"passed", rows.size() - failed}, {"failed", failed}, {"cases", cases}};
    std::fputs(jsonDocument(json).c_str(), stdout);
  } else {
    if (options.markdown) std::puts("# Validation\n\nMade by `fiatlux validate --markdown`.");
    printTable(rows, options.markdown);
    std::printf("\n%zu of %zu cases pass.\n", rows.size() - failed, rows.size());
  }
  if (failed > 0)
    throw CommandError(std::to_string(failed) + " of " + std::to_string(rows.size()) + " cases fail");
}

}  // namespace

void addValidateCommand(CLI::App& app) {
  auto o = std::make_shared<ValidateOptions>();
  CLI::App* command = app.add_subcommand("validate", "Analytic cases and CIE 171 through the whole pipeline");
  addRayOptions(*command, {o->validation.rays, o->validation.seed, o->validation.threads});
  command->add_flag("--json", o->json, "One JSON document on standard output");
  command->add_flag("--markdown", o->markdown, "The table of docs/validation.md");
  command->callback([o] { validate(*o); });
}

}  // namespace fiatlux
