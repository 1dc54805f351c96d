// Files that people take for photometric ones: told by their bytes, answered by what to do instead.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>

namespace fiatlux {

/// One sentence for pictures, containers (the photometric files inside are named), XML, web pages, other
/// programs' own formats, and anything else binary; none for plain text, which may be LM-63 or EULUMDAT.
std::optional<std::string> refusalOfForeignFile(std::span<const std::uint8_t> bytes);

}  // namespace fiatlux
