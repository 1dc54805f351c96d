// The light operator in files made before method 9, which are read as ever: shares in 63 steps, coded by the
// cells beside them and the site before; couplings by their neighbours in the table of H; the rest as bytes,
// gaps and small numbers. Readers alone: nothing writes these any more.
#pragma once

#include <cstdint>
#include <span>
#include <string>

#include "core/scene/light_operator.h"
#include "core/scene/patches.h"

namespace fiatlux {

/// Steps of files that do not tell theirs: they had to know the means over surfaces by the exchange alone.
inline constexpr double kOldestExchangeStep = 1.5e-3;

/// Each "" or what does not fit, and as its namesake of today (visibility_codec.h, exchange_codec.h).
std::string decodeOlderVisibility(std::span<const std::uint8_t> bytes, const Patches& patches,
                                  std::uint32_t first, std::uint32_t last, SiteVisibility& visibility);
std::string decodeOlderExchangeMeans(std::span<const std::uint8_t> bytes, const Patches& patches,
                                     const ExchangeGroups& groups, Exchange& exchange, double step);
std::string decodeOlderExchangeRest(std::span<const std::uint8_t> bytes, const Patches& patches,
                                    const ExchangeGroups& groups, Exchange& exchange, double step);

}  // namespace fiatlux
