// How good is a layout, provably, under its arrangement? The bound of every P that the rule allows, the least
// of which holds for all. Rows have so many P that the free layouts' bound is taken, which holds for them
// too; of fields all may have been tried.
#pragma once

#include <cassert>
#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "core/bound/bound.h"
#include "core/search/layout_search.h"

namespace fiatlux {

/// What a bound is proved by.
enum class BoundKind : std::uint8_t { kRelaxation, kPairs, kEnumeration };
inline constexpr const char* kBoundKindNames[] = {"relaxation", "pairs", "enumeration"};  // by code

class LayoutBound {
 public:
  /// As OptimumBound, for what a search has found; `prepared` is of sites and must outlive it.
  LayoutBound(PreparedScene& prepared, const Intentions& intentions, const LayoutSearch& found);

  /// False where no bound is known: without a goal, with a contrast as goal, or for the most sigma of ties.
  bool supported() const;
  /// Goes on for about so many steps.
  void advance(std::uint32_t steps);
  bool done() const;
  /// No layout that meets the constraints has an Evaluation::goal below this; -infinity until it is proved.
  double goal() const;
  BoundKind kind() const;
  /// As OptimumBound::takePairs.
  std::optional<PairGoal> takePairs() { return parts_.size() == 1 ? parts_[0]->takePairs() : std::nullopt; }
  /// As OptimumBound's. Precondition: takePairs() has given some.
  void provedByPairs(double goal) {
    assert(parts_.size() == 1);
    parts_[0]->provedByPairs(goal);
  }
  /// As OptimumBound::within.
  std::optional<double> within(const Evaluation& evaluation) const;

 private:
  std::vector<std::shared_ptr<PreparedScene>> scenes_;
  std::vector<std::unique_ptr<OptimumBound>> parts_;
  std::optional<Evaluation> proved_;  // the best of all layouts, where all were tried
};

}  // namespace fiatlux
