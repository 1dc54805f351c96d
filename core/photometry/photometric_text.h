// The text of a photometric file: its lines as they stand, and how a number is written.
// Takes what makers write: BOM, CR, LF or CR LF, Windows-1252, a Ctrl-Z at the end, commas between numbers.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/result.h"

namespace fiatlux {

/// Lines without their ends, in UTF-8; `lines[0]` is line 1. Blank lines are kept.
struct PhotometricText {
  std::vector<std::string> lines;
};

/// Bytes after a Ctrl-Z are left out. Never fails: bytes that are not UTF-8 are read as Windows-1252.
PhotometricText textOf(std::span<const std::uint8_t> bytes);

/// "line 12: <what>".
Error errorAt(std::size_t line, const std::string& what);

/// Without blanks at both ends.
std::string_view trimmed(std::string_view text);

/// The start of a text for people: control characters as blanks, cut to 200 bytes at a letter's end.
std::string shortText(std::string_view text);

/// The first letters of a text in quotation marks, for sentences.
std::string quoted(std::string_view text);

/// A decimal number that takes the whole token ("3", "-1.5e2", "2.D1"); none for NaN, infinity, hexadecimal,
/// empty. The same bits on every machine and in every locale.
std::optional<double> numberOf(std::string_view token);

/// The number that a whole line of EULUMDAT is; its comma may be a point.
std::optional<double> numberOfLine(std::string_view line);

/// "0.5", "1200": the shortest text of six digits, for sentences.
std::string shortNumber(double value);

}  // namespace fiatlux
