#include "core/base/short_number.h"

#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <cstring>

namespace fiatlux {

std::string shortNumber(double value, int digits) {
  constexpr double kLongest = 1e15;  // from which on zeros tell nobody anything
  char text[40];
  std::snprintf(text, sizeof text, "%.*g", digits, value);
  if (std::strchr(text, 'e') && std::abs(value) >= 1 && std::abs(value) < kLongest)
    std::snprintf(text, sizeof text, "%.0f", std::strtod(text, nullptr));
  return text;
}

}  // namespace fiatlux
