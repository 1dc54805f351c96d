// Numbers in sentences.
#pragma once

#include <string>

namespace fiatlux {

/// `value` with so many significant digits at most, without trailing zeros; "1840", where %g says 1.84e+03.
std::string shortNumber(double value, int digits = 3);

}  // namespace fiatlux
