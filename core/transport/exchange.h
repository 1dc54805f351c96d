// Interreflection by the operator of a scene: what direct light of any kind becomes once it has been
// reflected, without the form factors. With phi = A rho D (lm, first reflected) and S ~ W H W^T + W R^T + R:
//   E_indirect = S phi;   H between groups, W interpolation, R the rest (core/scene/light_operator.h).
// S is read both ways: the mean over a group knows each source patch by itself, only what is left of the
// light's detail within a group sees the sources group by group. Means over groups are H's alone: of R, which
// a file holds in steps without its many small values, counts what is not even over a group.
#pragma once

#include <cstdint>
#include <vector>

#include "core/scene/light_operator.h"
#include "core/scene/patches.h"
#include "core/transport/group_interpolation.h"

namespace fiatlux {

/// Refers to patches, groups and exchange, which must outlive it and agree.
class ExchangeOperator {
 public:
  ExchangeOperator(const Patches& patches, const ExchangeGroups& groups, const Exchange& exchange);

  /// lx of every row, column-major rows x columns, for direct light of the same shape (lx). May be a hair
  /// below zero where it is dark.
  std::vector<float> indirect(const std::vector<float>& direct, std::uint32_t columns) const;

  /// lx of every row, column-major rows x columns, for lumens that leave the groups of patches evenly
  /// (row-major groups x columns). The fewer groups they leave, the sooner.
  std::vector<float> spread(const std::vector<float>& lumens, std::uint32_t columns) const;
  /// Mean lx over group `to` per lumen that leaves group `from`, 1/m2.
  double between(std::uint32_t to, std::uint32_t from) const {
    return exchange_.means[std::size_t{to} * count_ + from];
  }

 private:
  void indirectBlock(const float* direct, std::uint32_t width, float* out) const;
  void addRest(const std::uint32_t* place, const float* in, std::uint32_t width, float* out,
               float* means) const;

  const Patches& patches_;
  const ExchangeGroups& groups_;
  const Exchange& exchange_;
  std::uint32_t count_, total_;
  GroupInterpolation interpolation_;
};

}  // namespace fiatlux
