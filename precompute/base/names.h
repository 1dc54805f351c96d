// Names from files are text of strangers: cleaned before anybody sees them, made unique before they become
// paths.
#pragma once

#include <set>
#include <string>
#include <vector>

namespace fiatlux {

/// `name` without control and bidirectional-override characters, '/' turned into '-' (it separates the levels
/// of a surface's path), trimmed, cut at 120 characters with an ellipsis. May be empty.
std::string cleanName(const std::string& name);

/// `text` made fit for one line of a message: as cleanName, but '/' stays.
std::string cleanText(const std::string& text);

/// Hands out names that nobody has yet: "x", then "x 2", "x 3"... Never "all".
class UniqueNames {
 public:
  std::string take(const std::string& wanted);
  bool taken(const std::string& name) const { return taken_.count(name) != 0; }

 private:
  std::set<std::string> taken_;
};

/// Whether a name is what a pattern says, case apart: '*' stands for any text, '?' for one byte.
bool matchesPattern(const std::string& pattern, const std::string& name);

/// Up to `most` of `names` that look most like `wanted`, each in quotes: "'a', 'b', 'c'"; for error messages.
std::string closestNames(const std::string& wanted, const std::vector<std::string>& names, char quote = '\'',
                         std::size_t most = 3);

}  // namespace fiatlux
