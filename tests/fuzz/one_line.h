// What every refusal must be: one readable line.
#pragma once

#include <cstdio>
#include <cstdlib>
#include <string>

namespace fiatlux::fuzz {

/// Ends the process, which is a finding, where `line` is not one line that a person can read.
inline void requireOneLine(const std::string& line) {
  bool readable = !line.empty() && line.size() < 4000;
  for (const char c : line) readable = readable && (static_cast<unsigned char>(c) >= 0x20 && c != 0x7f);
  if (readable) return;
  std::fprintf(stderr, "a refusal that is not one readable line: [%s]\n", line.substr(0, 4000).c_str());
  std::abort();
}

}  // namespace fiatlux::fuzz
