#include "precompute/base/repeated_key.h"

#include <algorithm>
#include <nlohmann/json.hpp>
#include <unordered_set>
#include <utility>
#include <vector>

#include "precompute/base/json_walk.h"

namespace fiatlux {
namespace {

/// An object or a list that is open.
struct OpenBracket {
  bool object = false;
  std::unordered_set<std::string> keys;
};

/// Without its escapes.
std::string keyOf(std::string_view written) {
  if (written.find('\\') == std::string_view::npos) return std::string(written);
  return nlohmann::json::parse('"' + std::string(written) + '"').get<std::string>();
}

}  // namespace

std::optional<RepeatedKey> repeatedKey(const std::string& text) {
  std::vector<OpenBracket> around;
  bool keyNext = false;
  for (JsonWalk walk(text); walk.skipBlanks(), !walk.done();) {
    const auto begin = text.begin() + static_cast<std::ptrdiff_t>(walk.at());
    if (*begin == '"' && keyNext) {
      std::string key = keyOf(walk.skipText());
      if (!around.back().keys.insert(key).second)
        return RepeatedKey{std::move(key),
                           1 + static_cast<std::size_t>(std::count(text.begin(), begin, '\n'))};
      keyNext = false;
      continue;
    }
    const int deeper = walk.skipToken();
    if (deeper > 0) around.push_back({*begin == '{', {}});
    if (deeper < 0) around.pop_back();
    keyNext = *begin == '{' || (*begin == ',' && around.back().object);
  }
  return std::nullopt;
}

}  // namespace fiatlux
