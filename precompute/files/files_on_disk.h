// Files that appear whole or not at all: written beside their place, then renamed. Errors begin with the
// path.
#pragma once

#include <cstdint>
#include <functional>
#include <span>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

#include "core/base/result.h"

namespace fiatlux {

/// Replaces the file at `path` by `bytes`; where it cannot (full disk, no such folder) what was there stays.
/// Devices and pipes are written to directly.
Result<Done> replaceFile(const std::string& path, std::span<const std::uint8_t> bytes);
Result<Done> replaceFile(const std::string& path, std::string_view text);

/// An error now if replaceFile could not put a file there: before an hour of work, not after.
Result<Done> checkReplaceable(const std::string& path);

/// The whole of a file of at most `most` bytes.
Result<std::vector<std::uint8_t>> readFileBytes(const std::string& path, std::uint64_t most = 256ull << 20);

/// What `parse` (std::string to Result<T>) makes of the file at `path`, of at most `most` bytes.
template <class Parse>
auto parsedFile(const std::string& path, std::uint64_t most, const Parse& parse)
    -> std::invoke_result_t<Parse, const std::string&> {
  const Result<std::vector<std::uint8_t>> bytes = readFileBytes(path, most);
  if (!bytes) return bytes.error();
  auto parsed = parse(std::string(bytes->begin(), bytes->end()));
  if (!parsed) return Error{path + ": " + parsed.error().message};
  return parsed;
}

}  // namespace fiatlux
