// The exchange of light in a file. H counts square roots, since couplings differ by orders of magnitude, each
// predicted from what the groups beside its two groups exchange, and range coded; so is the rest, which is
// sparse, by what the rows beside a row have.
#pragma once

#include <cmath>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "core/scene/light_operator.h"
#include "core/scene/patches.h"

namespace fiatlux {

/// sqrt(H_cd sqrt(A_c A_d)) is stored in steps of this.
inline constexpr double kExchangeMeanStep = 8e-3f;
/// Of the rest between row p and group d, times sqrt(A_p A_d).
inline constexpr double kExchangeRestStep = 8e-3f;

/// H by rows of its lower triangle, then the receivers' rows.
std::vector<std::uint8_t> encodeExchangeMeans(const Patches& patches, const ExchangeGroups& groups,
                                              const Exchange& exchange);
/// The inverse, into exchange.means. "" or what does not fit.
std::string decodeExchangeMeans(std::span<const std::uint8_t> bytes, const Patches& patches,
                                const ExchangeGroups& groups, Exchange& exchange,
                                double step = kExchangeMeanStep);

/// Entries that round to zero are left out.
std::vector<std::uint8_t> encodeExchangeRest(const Patches& patches, const ExchangeGroups& groups,
                                             const Exchange& exchange);
/// The inverse, into exchange.offset, group and rest. "" or what does not fit.
std::string decodeExchangeRest(std::span<const std::uint8_t> bytes, const Patches& patches,
                               const ExchangeGroups& groups, Exchange& exchange,
                               double step = kExchangeRestStep);

/// How many columns of H a file holds of a group's row: of its lower triangle, and all of a receiver's.
std::uint32_t exchangeColumns(const ExchangeGroups& groups, std::uint32_t group);

/// Beyond any room: no number of a file is larger, and no coupling (1/m2), so that sums of products stay
/// finite.
inline constexpr std::int32_t kLargestExchangeNumber = 1 << 26;
inline constexpr float kStrongestExchange = 1e12f;
inline constexpr std::uint64_t kMostRestEntries = 1u << 24;
inline constexpr const char* kExchangeOutOfRange = "a value is out of range";

/// Areas of the groups, m2.
std::vector<double> areasOf(const Patches& patches, const ExchangeGroups& groups);

/// Fills exchange.means with what the numbers of a file stand for. `next(c, d)`: the number at column d of
/// group c's row, asked for in order; nullopt where it is beyond all numbers. "" or what is wrong.
template <class Next>
std::string fillExchangeMeans(const Patches& patches, const ExchangeGroups& groups, double step,
                              Exchange& exchange, const Next& next) {
  const std::vector<double> area = areasOf(patches, groups);
  exchange.means.assign(std::size_t{groups.total} * groups.count, 0.0f);
  for (std::uint32_t c = 0; c < groups.total; ++c)
    for (std::uint32_t d = 0; d < exchangeColumns(groups, c); ++d) {
      const std::optional<std::int32_t> number = next(c, d);
      const double root = number ? step * *number : 0;
      const auto mean = static_cast<float>(root * root / std::sqrt(area[c] * area[d]));
      if (!number || !(mean < kStrongestExchange)) return kExchangeOutOfRange;
      exchange.means[std::size_t{c} * groups.count + d] = mean;
      if (c < groups.count) exchange.means[std::size_t{d} * groups.count + c] = mean;
    }
  return "";
}

}  // namespace fiatlux
