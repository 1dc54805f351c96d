#include "core/photometry/color_temperature.h"

#include <cmath>
#include <cstddef>

namespace fiatlux {
namespace {

constexpr double kLeast = 1000, kMost = 25000;  // K, of anything sold as white light
bool isDigit(char c) { return c >= '0' && c <= '9'; }

/// Each run of digits with what follows it, until `take` is satisfied.
template <class Take>
std::optional<double> firstRun(std::string_view text, Take take) {
  for (std::size_t i = 0; i < text.size();) {
    if (!isDigit(text[i])) {
      ++i;
      continue;
    }
    double value = 0;
    const std::size_t start = i;
    for (; i < text.size() && isDigit(text[i]); ++i) value = 10 * value + (text[i] - '0');
    if (const std::optional<double> kelvin = take(value, i - start, text.substr(i))) return kelvin;
  }
  return {};
}

bool within(double kelvin) { return kelvin >= kLeast && kelvin <= kMost; }

}  // namespace

std::optional<double> colorTemperatureOf(std::string_view field) {
  return firstRun(field, [](double value, std::size_t digits, std::string_view) -> std::optional<double> {
    if (within(value) && digits <= 5) return value;
    // A code: rendering index by tens, then hundreds of kelvin.
    const double hundreds = std::fmod(value, 100);
    if (digits == 3 && value >= 700 && hundreds >= 18 && hundreds <= 80) return 100 * hundreds;
    return {};
  });
}

std::optional<double> colorTemperatureIn(std::string_view sentence) {
  return firstRun(
      sentence, [](double value, std::size_t digits, std::string_view after) -> std::optional<double> {
        if (!after.empty() && after[0] == ' ') after.remove_prefix(1);
        const bool kelvin = !after.empty() && (after[0] == 'K' || after[0] == 'k') &&
                            (after.size() == 1 || !((after[1] | 0x20) >= 'a' && (after[1] | 0x20) <= 'z'));
        return kelvin && digits <= 5 && within(value) ? std::optional(value) : std::nullopt;
      });
}

}  // namespace fiatlux
