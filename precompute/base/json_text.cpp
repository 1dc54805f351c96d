#include "precompute/base/json_text.h"

#include <algorithm>
#include <nlohmann/json.hpp>
#include <stdexcept>

namespace fiatlux {
namespace {

using Json = nlohmann::json;

constexpr int kDeepest = 64;

struct TooDeep : std::exception {};

}  // namespace

Result<Json> parseJson(const std::string& text) {
  // note: too deep a nesting is stopped while parsing, not after.
  const Json::parser_callback_t guard = [](int depth, Json::parse_event_t, Json&) {
    if (depth > kDeepest) throw TooDeep{};
    return true;
  };
  try {
    return Json::parse(text, guard);
  } catch (const TooDeep&) {
    return Error{"nested deeper than " + std::to_string(kDeepest) + " levels"};
  } catch (const Json::parse_error& error) {
    const std::size_t byte = error.byte == 0 ? 0 : error.byte - 1;
    const auto end = text.begin() + static_cast<std::ptrdiff_t>(std::min(byte, text.size()));
    return Error{"not valid JSON: syntax error in line " +
                 std::to_string(1 + std::count(text.begin(), end, '\n')) + " (byte " + std::to_string(byte) +
                 ")"};
  } catch (const Json::exception&) {
    return Error{"not valid JSON: a number out of range, or text that is not UTF-8"};
  }
}

}  // namespace fiatlux
