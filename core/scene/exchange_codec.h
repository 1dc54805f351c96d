// The exchange of light in a file. H counts square roots, since couplings differ by orders of magnitude, each
// predicted from what the groups beside its two groups exchange, and range coded; so is the rest, which is
// sparse, by what the rows beside a row have.
#pragma once

#include <cstdint>
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

/// Areas of the groups, m2.
std::vector<double> areasOf(const Patches& patches, const ExchangeGroups& groups);

}  // namespace fiatlux
