// JSON as text: in from a person or a stranger (broken, too deep or sound), out as our files hold it.
#pragma once

#include <cstddef>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/result.h"

namespace fiatlux {

/// How deep a JSON text is nested, and how many values it holds (members and entries, the whole one
/// included). Of text that is no JSON these are only some numbers. note: asked before parsing, because the
/// parser's own callback, which could stop it, takes quadratic time on long lists.
struct JsonExtent {
  int depth = 0;
  std::size_t values = 0;
};
JsonExtent extentOfJson(std::string_view text);

/// Any JSON text, at most 64 deep, in a time that grows with its length alone. An error names the line and
/// the byte.
Result<nlohmann::json> parseJson(const std::string& text);

/// The line, from 1 on, on which the value at `path` (keys and indices) begins; of a longer path than there
/// is, the line of its last value that is there. `text`: one that parseJson has accepted.
std::size_t jsonLineOf(const std::string& text, const std::vector<std::string>& path);

/// On one line, or indented by `indent` blanks a level. What is not UTF-8 in a text becomes U+FFFD.
std::string jsonText(const nlohmann::json& json, int indent = -1);
std::string jsonText(const nlohmann::ordered_json& json, int indent = -1);

/// A whole document as our files and --json hold it: indented, with a line break at its end.
std::string jsonDocument(const nlohmann::ordered_json& json);

}  // namespace fiatlux
