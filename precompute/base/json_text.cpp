// nlohmann's parser between a look at the depth before it and the search for a line after it.
#include "precompute/base/json_text.h"

#include <algorithm>
#include <nlohmann/json.hpp>
#include <string_view>

#include "precompute/base/json_walk.h"

namespace fiatlux {
namespace {

using Json = nlohmann::json;

constexpr int kDeepest = 64;
constexpr int kIndent = 2;  // of a document

std::size_t lineAt(const std::string& text, std::size_t byte) {
  const auto end = text.begin() + static_cast<std::ptrdiff_t>(std::min(byte, text.size()));
  return 1 + static_cast<std::size_t>(std::count(text.begin(), end, '\n'));
}

}  // namespace

JsonExtent extentOfJson(std::string_view text) {
  JsonExtent extent;
  extent.values = 1;
  int depth = 0;
  for (JsonWalk walk(text); !walk.done();) {
    const bool comma = text[walk.at()] == ',';
    const int deeper = walk.skipToken();
    depth += deeper;
    extent.depth = std::max(extent.depth, depth);
    if (deeper > 0) walk.skipBlanks();
    const bool filled = deeper > 0 && !walk.done() && text[walk.at()] != '}' && text[walk.at()] != ']';
    if (comma || filled) ++extent.values;
  }
  return extent;
}

Result<Json> parseJson(const std::string& text) {
  if (extentOfJson(text).depth > kDeepest)
    return Error{"nested deeper than " + std::to_string(kDeepest) + " levels"};
  try {
    return Json::parse(text);
  } catch (const Json::parse_error& error) {
    const std::size_t byte = error.byte == 0 ? 0 : error.byte - 1;
    return Error{"not valid JSON: syntax error in line " + std::to_string(lineAt(text, byte)) + " (byte " +
                 std::to_string(byte) + ")"};
  } catch (const Json::exception&) {
    return Error{"not valid JSON: a number is out of range"};
  }
}

std::size_t jsonLineOf(const std::string& text, const std::vector<std::string>& path) {
  JsonWalk walk(text);
  walk.skipBlanks();
  for (const std::string& step : path)
    if (!walk.enter(step)) break;
  return lineAt(text, walk.at());
}

std::string jsonText(const Json& json, int indent) {
  return json.dump(indent, ' ', false, Json::error_handler_t::replace);
}

std::string jsonText(const nlohmann::ordered_json& json, int indent) {
  return json.dump(indent, ' ', false, nlohmann::ordered_json::error_handler_t::replace);
}

std::string jsonDocument(const nlohmann::ordered_json& json) { return jsonText(json, kIndent) + "\n"; }

}  // namespace fiatlux
