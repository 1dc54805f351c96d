// The text of a photometric file: its lines as they stand, and its numbers with the line each was found on.
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

/// "0.5", "1200": the shortest text of six digits, for sentences.
std::string shortNumber(double value);

/// Reads numbers parted by blanks, commas and line ends, as LM-63 writes them. The first failure is kept;
/// after it every call returns 0.
class NumberReader {
 public:
  /// Starts at the beginning of line `line` (from 1).
  NumberReader(const PhotometricText& text, std::size_t line);
  /// The next number; `what` is named if there is none ("the lamp's lumens").
  double next(const char* what);
  /// The next number, which must be whole and within [least, most]; "3.0" is whole.
  std::uint32_t count(const char* what, std::uint32_t least, std::uint32_t most);
  /// Line of the number that was read last, from 1.
  std::size_t line() const { return line_; }
  /// Keeps `what` as the failure, at the line of the last number, unless there is one already.
  void fail(const std::string& what);
  const std::optional<Error>& failure() const { return failure_; }
  /// The next token, not read; empty at the end of the text.
  std::string_view peek();

 private:
  const std::vector<std::string>& lines_;
  std::size_t next_, line_, at_ = 0;  // index of the line being read; line of the last number; place in it
  std::optional<Error> failure_;
};

}  // namespace fiatlux
