// Every field in turn; see field_scan.h.
#include "core/search/field_scan.h"

#include <cassert>

namespace fiatlux {

FieldScan::FieldScan(PreparedScene& prepared, const Intentions& intentions, const Layout* reference)
    : evaluator_(prepared, intentions, reference),
      all_(prepared.grid(), intentions.luminaires.count, mostOf(intentions.luminaires),
           intentions.luminaires.arrangement.axis),
      bestEvaluation_(kNothingFound) {
  const FieldRules allowed(prepared.scene(), intentions.luminaires);
  all_.visit([&](const Field& field) {
    if (allowed.allow(all_, field, sites_)) fields_.push_back(field);
    return true;
  });
  assert(!fields_.empty());
  tryNext();
}

void FieldScan::advance(std::uint32_t evaluations) {
  for (std::uint32_t k = 0; k < evaluations && !isDone(); ++k) tryNext();
}

void FieldScan::tryNext() {
  all_.sitesOf(fields_[next_++], sites_);
  ++evaluations_;
  if (!evaluator_.tryLayout(sites_, bestEvaluation_)) return;
  best_ = sites_;
  foundAt_ = evaluations_;
}

Layout FieldScan::incumbent() const {
  const std::size_t count = best_.size();
  return {best_, std::vector<double>(count, evaluator_.flux()[0]), bestEvaluation_.dimming,
          std::vector<std::uint32_t>(count, 0)};
}

}  // namespace fiatlux
