// Numbers in sentences.
#pragma once

#include <cstdio>
#include <string>

namespace fiatlux {

/// `value` with so many significant digits at most, without trailing zeros.
inline std::string shortNumber(double value, int digits = 3) {
  char text[40];
  std::snprintf(text, sizeof text, "%.*g", digits, value);
  return text;
}

}  // namespace fiatlux
