// A key that an object of a JSON text has twice: the parser keeps one of the two values and says nothing.
#pragma once

#include <cstddef>
#include <optional>
#include <string>

namespace fiatlux {

struct RepeatedKey {
  std::string key;
  std::size_t line = 0;  // from 1 on, where it stands for the second time
};

/// The first one, however its characters are written. `text`: one that parseJson has accepted; the time grows
/// with its length alone.
std::optional<RepeatedKey> repeatedKey(const std::string& text);

}  // namespace fiatlux
