// Cleaning, uniqueness and likeness of names.
#include "precompute/base/names.h"

#include <algorithm>
#include <cctype>
#include <cstdint>
#include <numeric>

namespace fiatlux {
namespace {

constexpr std::size_t kLongest = 120;      // characters of a name that are shown
constexpr std::size_t kMostRanked = 2000;  // names that are compared with a misspelt one

/// The next code point of UTF-8 and its bytes; broken sequences come out as one replacement character a byte.
std::uint32_t nextCodePoint(const std::string& text, std::size_t& at) {
  const auto byte = [&](std::size_t i) { return static_cast<unsigned char>(text[i]); };
  const unsigned char first = byte(at);
  const std::size_t extra = first < 0x80                    ? 0
                            : first >= 0xf0 && first < 0xf5 ? 3
                            : first >= 0xe0                 ? 2
                            : first >= 0xc2                 ? 1
                                                            : 9;
  if (first >= 0xf5 || extra == 9 || at + extra >= text.size()) return ++at, 0xfffd;
  std::uint32_t code = extra == 0 ? first : first & (0x3f >> extra);
  for (std::size_t i = 1; i <= extra; ++i) {
    if ((byte(at + i) & 0xc0) != 0x80) return ++at, 0xfffd;
    code = code << 6 | (byte(at + i) & 0x3f);
  }
  at += extra + 1;
  return code;
}

bool isHidden(std::uint32_t c) {
  return c < 0x20 || (c >= 0x7f && c < 0xa0) || c == 0xad || c == 0x61c || (c >= 0x200b && c <= 0x200f) ||
         (c >= 0x2028 && c <= 0x202e) || (c >= 0x2060 && c <= 0x206f) || c == 0xfeff || c == 0xfffd ||
         (c >= 0xd800 && c <= 0xdfff) || (c >= 0xe0000 && c <= 0xe0fff);
}

std::string cleaned(const std::string& text, bool slashes) {
  std::string result;
  std::size_t characters = 0;
  for (std::size_t at = 0; at < text.size();) {
    const std::size_t start = at;
    const std::uint32_t code = nextCodePoint(text, at);
    if (isHidden(code) || (code == ' ' && (result.empty() || result.back() == ' '))) continue;
    if (++characters > kLongest) {
      result += "…";
      break;
    }
    if (code == '/' && !slashes)
      result += '-';
    else
      result.append(text, start, at - start);
  }
  while (!result.empty() && result.back() == ' ') result.pop_back();
  return result;
}

/// Letters to insert, delete or replace to get from a to b (Levenshtein), case apart.
std::size_t editDistance(const std::string& a, const std::string& b) {
  std::vector<std::size_t> row(b.size() + 1);
  std::iota(row.begin(), row.end(), 0);
  for (std::size_t i = 1; i <= a.size(); ++i) {
    std::size_t diagonal = row[0];
    row[0] = i;
    for (std::size_t j = 1; j <= b.size(); ++j) {
      const bool same = std::tolower(static_cast<unsigned char>(a[i - 1])) ==
                        std::tolower(static_cast<unsigned char>(b[j - 1]));
      const std::size_t best = std::min({row[j] + 1, row[j - 1] + 1, diagonal + (same ? 0 : 1)});
      diagonal = row[j];
      row[j] = best;
    }
  }
  return row[b.size()];
}

}  // namespace

std::string cleanName(const std::string& name) { return cleaned(name, false); }
std::string cleanText(const std::string& text) { return cleaned(text, true); }

std::string UniqueNames::take(const std::string& wanted) {
  std::string name = wanted;
  for (int i = 2; name == "all" || taken_.count(name); ++i) name = wanted + " " + std::to_string(i);
  taken_.insert(name);
  return name;
}

bool matchesPattern(const std::string& pattern, const std::string& name) {
  const auto lower = [](char c) { return std::tolower(static_cast<unsigned char>(c)); };
  // The last '*' takes more and more of the name until the rest fits.
  std::size_t p = 0, n = 0, star = std::string::npos, taken = 0;
  while (n < name.size()) {
    if (p < pattern.size() && pattern[p] == '*') {
      star = p++, taken = n;
    } else if (p < pattern.size() && (pattern[p] == '?' || lower(pattern[p]) == lower(name[n]))) {
      ++p, ++n;
    } else if (star != std::string::npos) {
      p = star + 1, n = ++taken;
    } else {
      return false;
    }
  }
  while (p < pattern.size() && pattern[p] == '*') ++p;
  return p == pattern.size();
}

/// How far a name is from what was asked: of a path its last part may be meant alone, and of a pattern what
/// it says.
static std::size_t unlikeness(const std::string& asked, const std::string& name) {
  if (matchesPattern("*" + asked + "*", name)) return 1;
  return std::min(editDistance(asked, name), editDistance(asked, name.substr(name.rfind('/') + 1)) + 1);
}

std::string closestNames(const std::string& wanted, const std::vector<std::string>& names, char quote,
                         std::size_t most) {
  const std::string asked = cleanText(wanted);
  std::vector<std::pair<std::size_t, std::string>> ranked;
  for (const std::string& name : names)
    if (ranked.size() < kMostRanked) ranked.emplace_back(unlikeness(asked, name), name);
  std::sort(ranked.begin(), ranked.end());
  ranked.erase(std::unique(ranked.begin(), ranked.end()), ranked.end());
  std::string list;
  for (std::size_t i = 0; i < ranked.size() && i < most; ++i)
    list += (i ? ", " : "") + (quote + ranked[i].second + quote);
  return list;
}

}  // namespace fiatlux
