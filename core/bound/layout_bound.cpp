// The least bound of several; see layout_bound.h.
#include "core/bound/layout_bound.h"

#include <algorithm>

namespace fiatlux {

LayoutBound::LayoutBound(PreparedScene& prepared, const Intentions& intentions, const LayoutSearch& found) {
  LuminaireRules rules = intentions.luminaires;
  if (found.isProved()) {
    proved_ = found.evaluation();
    return;
  }
  if (rules.arrangement.rule != Rule::kSymmetric) rules.arrangement = {};
  if (rules.arrangement.rule == Rule::kFree && !countVaries(rules)) {
    parts_.push_back(std::make_unique<OptimumBound>(prepared, intentions, found.evaluation()));
    return;
  }
  for (const Ties& ties : tiesUnder(prepared.grid(), rules))
    for (const TiedStart& start : startsOf(prepared.scene(), ties, rules)) {
      scenes_.push_back(prepared.tied(ties));
      parts_.push_back(std::make_unique<OptimumBound>(
          *scenes_.back(), intentions, tiedRules(*scenes_.back(), rules, start), found.evaluation()));
    }
}

bool LayoutBound::supported() const {
  return proved_ || (!parts_.empty() && std::all_of(parts_.begin(), parts_.end(),
                                                    [](const auto& part) { return part->supported(); }));
}

void LayoutBound::advance(std::uint32_t steps) {
  for (const auto& part : parts_)
    if (!part->done()) return part->advance(steps);
}

bool LayoutBound::done() const {
  return !supported() ||
         std::all_of(parts_.begin(), parts_.end(), [](const auto& part) { return part->done(); });
}

double LayoutBound::goal() const {
  if (proved_) return proved_->goal;
  double least = kUnbounded;
  for (const auto& part : parts_) least = std::min(least, part->goal());
  return least;
}

BoundKind LayoutBound::kind() const {
  if (proved_) return BoundKind::kEnumeration;
  const bool isByPairs = parts_.size() == 1 && parts_[0]->isByPairs();
  return isByPairs ? BoundKind::kPairs : BoundKind::kRelaxation;
}

std::optional<double> LayoutBound::within(const Evaluation& evaluation) const {
  if (!supported()) return std::nullopt;
  if (proved_) return evaluation.violation > 1e-9 ? std::nullopt : std::optional<double>(0);
  const auto weakest = std::min_element(parts_.begin(), parts_.end(),
                                        [](const auto& a, const auto& b) { return a->goal() < b->goal(); });
  return (*weakest)->within(evaluation);
}

}  // namespace fiatlux
