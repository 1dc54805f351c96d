#include "precompute/program/option_checks.h"

#include <charconv>

#include "core/base/short_number.h"
#include "precompute/files/terminal.h"

namespace fiatlux {
namespace {

constexpr int kDigits = 10;  // of the ends of a range

/// The check, and its words for --help.
template <class Number>
CLI::Validator inRange(Number low, Number high, const std::string& kind, const std::string& range) {
  const auto check = [=](const std::string& text) -> std::string {
    Number value{};
    const char* end = text.data() + text.size();
    const auto [stop, error] = std::from_chars(text.data(), end, value);
    // note: written so that NaN is refused, too
    if (error == std::errc() && stop == end && value >= low && value <= high) return "";
    return "'" + printable(text, 40) + "' is not " + kind + " from " + range;
  };
  return CLI::Validator(check, range);
}

}  // namespace

CLI::Validator numberFrom(double low, double high) {
  return inRange<double>(low, high, "a number",
                         shortNumber(low, kDigits) + " to " + shortNumber(high, kDigits));
}

CLI::Validator wholeFrom(std::uint64_t low, std::uint64_t high) {
  return inRange<std::uint64_t>(low, high, "a whole number",
                                std::to_string(low) + " to " + std::to_string(high));
}

}  // namespace fiatlux
