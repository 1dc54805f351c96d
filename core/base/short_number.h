// Numbers in sentences.
#pragma once

#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <string>

namespace fiatlux {

/// `value` with so many significant digits at most, without trailing zeros; "1840", where %g says 1.84e+03.
inline std::string shortNumber(double value, int digits = 3) {
  constexpr double kLongest = 1e15;  // from which on zeros tell nobody anything
  char text[40];
  std::snprintf(text, sizeof text, "%.*g", digits, value);
  if (std::strchr(text, 'e') && std::abs(value) >= 1 && std::abs(value) < kLongest)
    std::snprintf(text, sizeof text, "%.0f", std::strtod(text, nullptr));
  return text;
}

}  // namespace fiatlux
