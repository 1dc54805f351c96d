// Files that appear whole or not at all: written beside their place, then renamed; and what Ctrl-C does.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace fiatlux {

/// Replaces `path` by `bytes`: on any failure (full disk, no such folder) throws CommandError and leaves what
/// was there. Devices and pipes are written to directly.
void writeFileAtomically(const std::string& path, std::span<const std::uint8_t> bytes);
void writeFileAtomically(const std::string& path, std::string_view text);

/// Throws CommandError now if writeFileAtomically could not put a file there: before an hour of work, not
/// after.
void checkWritable(const std::string& path);

/// The whole of a file of at most `maxBytes`; throws CommandError.
std::vector<std::uint8_t> readFileBytes(const std::string& path, std::uint64_t maxBytes = 256ull << 20);

/// From now on Ctrl-C (and TERM, HUP) removes a file that is being written, says so in one line and ends with
/// status 2.
void installInterruptHandler();

}  // namespace fiatlux
