#include "core/photometry/photometric_text.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <cstdlib>

namespace fiatlux {
namespace {

constexpr std::uint8_t kCtrlZ = 0x1a;

/// Code points of the bytes 0x80 to 0x9f; 0 where Windows-1252 has none.
constexpr std::array<std::uint16_t, 32> kWindows1252 = {
    0x20ac, 0,      0x201a, 0x0192, 0x201e, 0x2026, 0x2020, 0x2021, 0x02c6, 0x2030, 0x0160,
    0x2039, 0x0152, 0,      0x017d, 0,      0,      0x2018, 0x2019, 0x201c, 0x201d, 0x2022,
    0x2013, 0x2014, 0x02dc, 0x2122, 0x0161, 0x203a, 0x0153, 0,      0x017e, 0x0178};

/// Bytes that follow a first byte of UTF-8; -1 for a byte that cannot be first.
int bytesAfter(std::uint8_t first) {
  if (first < 0x80) return 0;
  if (first >= 0xc2 && first < 0xe0) return 1;
  if (first >= 0xe0 && first < 0xf0) return 2;
  if (first >= 0xf0 && first < 0xf5) return 3;
  return -1;
}

bool isUtf8(std::span<const std::uint8_t> bytes) {
  for (std::size_t i = 0; i < bytes.size(); ++i) {
    const int more = bytesAfter(bytes[i]);
    if (more < 0 || i + static_cast<std::size_t>(more) >= bytes.size()) return false;
    for (int k = 0; k < more; ++k)
      if ((bytes[++i] & 0xc0) != 0x80) return false;
  }
  return true;
}

/// One byte of Windows-1252 as UTF-8.
void appendWindows1252(std::string& line, std::uint8_t byte) {
  std::uint32_t code = byte;
  if (byte >= 0x80 && byte < 0xa0) code = kWindows1252[byte - 0x80] ? kWindows1252[byte - 0x80] : 0xfffd;
  if (code < 0x80) {
    line += static_cast<char>(code);
  } else if (code < 0x800) {
    line += static_cast<char>(0xc0 | code >> 6);
    line += static_cast<char>(0x80 | (code & 0x3f));
  } else {
    line += static_cast<char>(0xe0 | code >> 12);
    line += static_cast<char>(0x80 | (code >> 6 & 0x3f));
    line += static_cast<char>(0x80 | (code & 0x3f));
  }
}

/// The powers of ten that a double holds exactly.
constexpr std::array<double, 23> kTens = {1e0,  1e1,  1e2,  1e3,  1e4,  1e5,  1e6,  1e7,
                                          1e8,  1e9,  1e10, 1e11, 1e12, 1e13, 1e14, 1e15,
                                          1e16, 1e17, 1e18, 1e19, 1e20, 1e21, 1e22};

/// value x 10^exponent by exact powers only, so that every machine gets the same bits.
double scaledByTen(double value, int exponent) {
  const bool down = exponent < 0;
  for (int left = std::min(std::abs(exponent), 400); left > 0; left -= 22) {
    const double power = kTens[static_cast<std::size_t>(std::min(left, 22))];
    value = down ? value / power : value * power;
  }
  return value;
}

}  // namespace

PhotometricText textOf(std::span<const std::uint8_t> bytes) {
  bytes =
      bytes.first(static_cast<std::size_t>(std::find(bytes.begin(), bytes.end(), kCtrlZ) - bytes.begin()));
  if (bytes.size() >= 3 && bytes[0] == 0xef && bytes[1] == 0xbb && bytes[2] == 0xbf) bytes = bytes.subspan(3);
  const bool utf8 = isUtf8(bytes);
  PhotometricText text;
  std::string line;
  for (std::size_t i = 0; i < bytes.size(); ++i) {
    if (bytes[i] == '\r' || bytes[i] == '\n') {
      if (bytes[i] == '\r' && i + 1 < bytes.size() && bytes[i + 1] == '\n') ++i;
      text.lines.push_back(std::move(line));
      line.clear();
    } else if (utf8) {
      line += static_cast<char>(bytes[i]);
    } else {
      appendWindows1252(line, bytes[i]);
    }
  }
  if (!line.empty()) text.lines.push_back(std::move(line));
  return text;
}

Error errorAt(std::size_t line, const std::string& what) {
  std::string message = "line ";
  message += std::to_string(line);
  message += ": ";
  message += what;
  return Error{message};
}

std::string_view trimmed(std::string_view text) {
  const auto blank = [](char c) { return static_cast<std::uint8_t>(c) <= ' '; };
  while (!text.empty() && blank(text.front())) text.remove_prefix(1);
  while (!text.empty() && blank(text.back())) text.remove_suffix(1);
  return text;
}

std::string shortText(std::string_view text) {
  text = trimmed(text);
  std::size_t size = std::min<std::size_t>(text.size(), 200);
  while (size < text.size() && size > 0 && (text[size] & 0xc0) == 0x80) --size;
  std::string shown(text.substr(0, size));
  for (char& c : shown)
    if (static_cast<std::uint8_t>(c) < ' ' || c == 0x7f) c = ' ';
  return shown;
}

std::string quoted(std::string_view text) {
  std::string shown(1, '"');
  shown += shortText(text.substr(0, 40));
  shown += '"';
  return shown;
}

std::optional<double> numberOf(std::string_view token) {
  std::size_t i = 0;
  const bool negative = !token.empty() && token[0] == '-';
  if (!token.empty() && (token[0] == '-' || token[0] == '+')) ++i;
  // Whole and fraction: 18 digits count, further ones only move the point.
  std::uint64_t mantissa = 0;
  int digits = 0, exponent = 0;
  bool point = false, any = false;
  for (; i < token.size(); ++i) {
    const char c = token[i];
    if (c == '.' && !point) {
      point = true;
    } else if (c >= '0' && c <= '9') {
      any = true;
      if (digits < 18) {
        mantissa = 10 * mantissa + static_cast<std::uint64_t>(c - '0');
        digits += mantissa > 0;
        exponent -= point;
      } else {
        exponent += !point;
      }
    } else {
      break;
    }
  }
  if (!any) return {};
  if (i < token.size()) {
    // Exponent: e, E, or Fortran's d, D.
    if ((token[i] | 0x20) != 'e' && (token[i] | 0x20) != 'd') return {};
    ++i;
    const bool down = i < token.size() && token[i] == '-';
    if (i < token.size() && (token[i] == '-' || token[i] == '+')) ++i;
    if (i == token.size()) return {};
    int power = 0;
    for (; i < token.size(); ++i) {
      if (token[i] < '0' || token[i] > '9') return {};
      power = std::min(10 * power + (token[i] - '0'), 100000);
    }
    exponent += down ? -power : power;
  }
  const double value = scaledByTen(static_cast<double>(mantissa), exponent);
  if (!std::isfinite(value)) return {};
  return negative ? -value : value;
}

std::optional<double> numberOfLine(std::string_view line) {
  std::string text(trimmed(line));
  std::replace(text.begin(), text.end(), ',', '.');
  return numberOf(text);
}

std::string shortNumber(double value) {
  char text[40];
  std::snprintf(text, sizeof text, "%.6g", value);
  return text;
}

}  // namespace fiatlux
