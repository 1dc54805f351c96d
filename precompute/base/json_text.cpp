// nlohmann's parser between a look at the depth before it and the search for a line after it.
#include "precompute/base/json_text.h"

#include <algorithm>
#include <nlohmann/json.hpp>
#include <string_view>

namespace fiatlux {
namespace {

using Json = nlohmann::json;

constexpr int kDeepest = 64;
constexpr int kIndent = 2;  // of a document

std::size_t lineAt(const std::string& text, std::size_t byte) {
  const auto end = text.begin() + static_cast<std::ptrdiff_t>(std::min(byte, text.size()));
  return 1 + static_cast<std::size_t>(std::count(text.begin(), end, '\n'));
}

/// Steps over JSON without building anything. Of text that is no JSON it only finds some end.
class JsonWalk {
 public:
  explicit JsonWalk(std::string_view text) : text_(text) {}

  std::size_t at() const { return at_; }
  bool done() const { return at_ >= text_.size(); }

  void skipBlanks() {
    while (!done() && std::string_view(" \t\r\n").find(text_[at_]) != std::string_view::npos) ++at_;
  }

  /// From one quote to behind the other; what is between them, escapes as written.
  std::string_view skipText() {
    const std::size_t begin = ++at_;
    while (!done() && text_[at_] != '"') at_ += text_[at_] == '\\' ? 2 : 1;
    const std::string_view inside = text_.substr(begin, std::min(at_, text_.size()) - begin);
    ++at_;
    return inside;
  }

  /// One bracket, text or other character; how much deeper the next one is.
  int skipToken() {
    const char c = text_[at_];
    if (c == '"') return skipText(), 0;
    ++at_;
    return c == '{' || c == '[' ? 1 : c == '}' || c == ']' ? -1 : 0;
  }

  /// To the comma or bracket behind the value that begins here.
  void skipValue() {
    for (int depth = 0; !done(); depth += skipToken())
      if (depth == 0 && (text_[at_] == ',' || text_[at_] == '}' || text_[at_] == ']')) return;
  }

  /// From the beginning of an object or a list to that of its member `step`; false, without a move, where it
  /// has none.
  bool enter(const std::string& step) {
    const std::size_t begin = at_;
    if (done() || (text_[at_] != '{' && text_[at_] != '[')) return false;
    const bool object = text_[at_++] == '{';
    for (std::size_t index = 0; skipBlanks(), !done() && text_[at_] != '}' && text_[at_] != ']'; ++index) {
      const bool found = object ? skipText() == step : std::to_string(index) == step;
      skipBlanks();
      if (object) ++at_;  // the colon
      skipBlanks();
      if (found) return true;
      skipValue();
      if (!done() && text_[at_] == ',') ++at_;
    }
    at_ = begin;
    return false;
  }

 private:
  std::string_view text_;
  std::size_t at_ = 0;
};

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
