// Checks of numbers on the command line: one line says what was given and what may be.
#pragma once

#include <CLI/CLI.hpp>
#include <cstdint>
#include <string>

namespace fiatlux {

/// A finite number from `low` to `high`.
CLI::Validator numberFrom(double low, double high);

/// A whole number from `low` to `high`, written in digits.
CLI::Validator wholeFrom(std::uint64_t low, std::uint64_t high);

/// Any seed: a whole number of 64 bits.
inline CLI::Validator aSeed() { return wholeFrom(0, UINT64_MAX); }

}  // namespace fiatlux
