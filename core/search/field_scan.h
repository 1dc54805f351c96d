// The best regular field, proved: all fields are tried, one after the other.
#pragma once

#include <cstdint>
#include <vector>

#include "core/search/arrangements.h"
#include "core/search/evaluator.h"

namespace fiatlux {

class FieldScan {
 public:
  /// `prepared` is of sites and must outlive it. Precondition: there is a field (hasRoom).
  FieldScan(PreparedScene& prepared, const Intentions& intentions, const Layout* reference);

  /// Tries that many more fields, or those that are left.
  void advance(std::uint32_t evaluations);
  bool isDone() const { return next_ == fields_.size(); }

  Layout incumbent() const;
  const Evaluation& evaluation() const { return bestEvaluation_; }
  std::uint64_t evaluations() const { return evaluations_; }
  std::uint64_t foundAt() const { return foundAt_; }

 private:
  void tryNext();

  Evaluator evaluator_;
  Fields all_;
  std::vector<Field> fields_;  // those that the rules allow
  std::size_t next_ = 0;
  std::vector<std::uint32_t> sites_, best_;
  Evaluation bestEvaluation_;
  std::uint64_t evaluations_ = 0, foundAt_ = 0;
};

}  // namespace fiatlux
