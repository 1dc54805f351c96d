// The smallest alpha whose Chebyshev constraints really keep every patch within its bounds: paper section 4,
// figures 6 and 7. Guaranteed minima and maxima over the patches are replaced by mu -/+ alpha sigma, searched
// without a patch in sight, and the answer is checked on the true patches once an iteration. Deterministic;
// advances in slices.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "core/base/result.h"
#include "core/search/intentions.h"
#include "core/search/layout_search.h"

namespace fiatlux {

struct AlphaOptions {
  double deltaAlpha = 0.01;  // stop when the interval is not wider than this
  double deltaPhi = 0;  // stop when the goal's values at its ends differ by at most this share; 0 = never
  std::uint32_t iterations = 60;      // stop after so many
  std::uint32_t evaluations = 25000;  // per run of the search
  std::uint32_t runs = 3;             // per iteration: one from the best layout known, the others at random
  std::uint64_t seed = 1;
};

/// I: the best layout under the Chebyshev constraints breaks the true ones. II: it keeps them. III: there is
/// none.
enum class Region : std::uint8_t { kOne, kTwo, kThree };

struct AlphaIteration {
  double alpha = 0, low = 0, high = 0;  // tried; the interval it was tried for (alpha a, alpha b of figure 7)
  Region region = Region::kOne;
  bool bipartition = false;         // second part of the algorithm
  double mean = 0, sigma = 0;       // of the first guaranteed surface set
  double minimum = 0, maximum = 0;  // true ones of it, over the patches, with the margin of the stored light
  double phi = 0;                   // the goal in its own unit (several goals: their weighted sum)
  Layout layout;
};

enum class AlphaOutcome : std::uint8_t {
  kRunning,
  kFound,           // alpha() is the smallest found that works
  kZeroSuffices,    // region I is empty: the means alone keep the bounds
  kTwoEmpty,        // regions I and III touch: no alpha works
  kNoLayout,        // region III from alpha = 0 on: not even the means can be reached
  kOutOfIterations  // stopped before an alpha of region II was seen
};

class AlphaSearch {
 public:
  /// Precondition: checkAlphaIntentions (guarantees.h) passed. The prepared scene must outlive the search.
  AlphaSearch(PreparedScene& prepared, const Intentions& intentions, const AlphaOptions& options = {});

  /// Goes on for about `evaluations` trial layouts; iterations may end on the way.
  void advance(std::uint32_t evaluations);
  bool done() const { return stage_ == Stage::kDone; }

  /// All iterations so far, in order.
  const std::vector<AlphaIteration>& iterations() const { return iterations_; }
  AlphaOutcome outcome() const { return outcome_; }
  /// The iteration that answers (kFound, kZeroSuffices), or nullptr.
  const AlphaIteration* solution() const { return solution_ ? &iterations_[*solution_] : nullptr; }

  /// Where no alpha works: the layout with the best true extreme of the guarantee that fails, and that
  /// extreme, the largest minimum (or smallest maximum) found to be feasible together with everything else
  /// that was asked.
  const std::optional<Layout>& fallback() const { return fallback_; }
  double feasibleBound() const { return feasibleBound_; }

  /// The verdict for a person, one or two sentences; empty while it runs.
  const std::string& verdict() const { return verdict_; }
  std::uint64_t evaluations() const { return evaluations_; }

 private:
  enum class Stage : std::uint8_t { kZero, kInterval, kBipartition, kBound, kDone };

  void openProblem(double alpha);
  void openRun();
  void closeRun();
  void closeIteration();
  AlphaIteration iterationOf(const Layout& layout, bool feasible);
  void afterZero(const AlphaIteration& last);
  void afterInterval(const AlphaIteration& last);
  void afterBipartition(const AlphaIteration& last);
  bool stops() const;
  void conclude(AlphaOutcome outcome);
  void openBound(AlphaOutcome outcome);
  void closeBound();
  std::size_t firstGuarantee() const;

  PreparedScene& prepared_;
  Intentions intentions_;
  AlphaOptions options_;
  Layout reference_;
  Stage stage_ = Stage::kZero;
  AlphaOutcome outcome_ = AlphaOutcome::kRunning;
  double low_ = 0, high_ = 1;                             // alpha a, alpha b
  double third_ = kUnbounded;                             // the smallest alpha seen in region III
  std::optional<std::size_t> lowAt_, highAt_, solution_;  // their iterations
  std::vector<AlphaIteration> iterations_;

  Intentions problem_;  // the current OptCh
  double alpha_ = 0;
  std::uint32_t run_ = 0;
  std::optional<LayoutSearch> search_;
  std::uint32_t left_ = 0;  // evaluations left in the run
  Layout best_;
  Evaluation bestEvaluation_;
  std::uint64_t evaluations_ = 0;
  std::size_t broken_ = 0;  // the constraint whose feasible bound is looked for
  std::optional<Layout> fallback_;
  double feasibleBound_ = 0;
  std::string verdict_;
};

/// "I", "II", "III".
const char* regionName(Region region);

}  // namespace fiatlux
