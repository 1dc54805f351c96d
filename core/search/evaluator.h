// Trial layouts of candidates (sites, or ties of them: prepared_scene.h), cheaply: the evaluator stands at
// one layout, keeps the sums C x of it (variance_sums.h), and tells what a change of it would be worth in
// O(1) loads per surface set instead of N (N + 1) / 2 (paper (8), (10)): (x + d)^T C (x + d) = x^T C x + 2
// d^T (C x) + d^T C d, and d has two entries a move.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "core/search/intentions.h"
#include "core/search/move_rows.h"
#include "core/search/objective.h"
#include "core/search/plane_values.h"
#include "core/search/variance_sums.h"

namespace fiatlux {

/// A luminaire put on another site; of ties, a tie in another's place.
struct Move {
  std::uint32_t luminaire = 0, site = 0;
};

/// Moves made together: one, or two for exchanges. Their sites may be each other's.
struct Trial {
  Move moves[2];
  std::uint32_t count = 0;
  Evaluation evaluation;
};

class Evaluator {
 public:
  /// Precondition: checkIntentions passed. `reference` scales the goals; without it a spread-out layout does.
  /// The prepared scene must outlive the evaluator.
  Evaluator(PreparedScene& prepared, const Intentions& intentions, const Layout* reference = nullptr);

  /// A full evaluation of any layout, one site a luminaire, patches included where true extremes are asked
  /// for.
  Evaluation evaluate(const std::vector<std::uint32_t>& sites);

  /// The same where only a better one than `best` is asked for, which it then becomes; patches are lit only
  /// for what may be better. Not for an evaluator that stands at a layout.
  bool tryLayout(const std::vector<std::uint32_t>& sites, Evaluation& best);

  /// Stands at a layout, one site a luminaire; `current()` is its evaluation.
  void load(const std::vector<std::uint32_t>& sites);
  const std::vector<std::uint32_t>& sites() const { return sites_; }
  const std::vector<double>& flux() const {
    return flux_;
  }  // lm of each luminaire, for the most there may be
  const Evaluation& current() const { return current_; }

  /// Tries luminaire `i` on each of `count` candidates; `best` becomes the best of them when one is better
  /// than it. One evaluation a candidate.
  void tryMoves(std::uint32_t i, const std::uint32_t* candidates, std::uint32_t count, Trial& best);

  /// May moves be surveyed? (objective.h)
  bool maySurvey() const { return maySurvey_; }
  /// What luminaire `i` on each of kSurveyed candidates would be worth, bounds at the penalty, or without one
  /// at a price that no goal pays; the one that it is on may be among them. Of bounds on extremes what the
  /// patches that were extreme lately say: the truth may be worse. Precondition: maySurvey().
  void survey(std::uint32_t i, const std::uint32_t* candidates, double* worths);
  /// What kSurveyed pairs of moves would be worth, first[k] and second[k] made at once. As survey().
  void surveyPairs(const Move* first, const Move* second, double* worths);

  /// May all moves be looked at together?
  bool mayLookAround() const {
    return maySurvey_ && objective_.mayLinearize() && prepared_.candidateCount() >= kMoveLanes;
  }
  /// Of all moves of `luminaires` to candidates that are not closed (kNoMove for one that is, else 0) the one
  /// that is worth most to first order (linear_worth.h), at the prices of survey(); false where all are
  /// closed. Preconditions: mayLookAround(), all luminaires of one flux.
  bool bestMove(const std::vector<std::uint32_t>& luminaires, const std::vector<float>& closed, Move& best);

  /// Tries two moves at once; `best` as above. One evaluation.
  void tryPair(const Move& a, const Move& b, Trial& best);

  /// Trials are compared at these prices, for a walk through layouts that break a bound a little or miss an
  /// aim. Firm ones restore the order of `isBetter`.
  void setPrices(const Prices& prices) { prices_ = prices; }

  /// Must patches be lit to judge a layout?
  bool lightsPatches() const { return lightsPatches_; }
  /// From the next load() on, true extremes are the best that mean and variance allow (Objective::allowedBy),
  /// and no patch is lit; or, again, what the patches say.
  void leaveOutExtremes(bool leftOut) { leftOut_ = leftOut; }

  /// Makes the moves of a trial. With FIATLUX_CHECK_DELTA (the sanitizer build) it asserts that the trial,
  /// what the cached sums say afterwards and a full evaluation agree.
  void apply(const Trial& trial);

  /// The layout it stands at, with its dimming.
  Layout layout() const { return {sites_, flux_, current_.dimming}; }
  /// Value of goal g in its own unit where it stands.
  double goalValue(std::size_t g) const {
    return objective_.goalValue(g, moments_.data(), extremes_.data(), current_.dimming);
  }
  const Objective& objective() const { return objective_; }
  /// Mean and variance per objective set where it stands.
  const std::vector<Moments>& moments() const { return moments_; }

 private:
  std::uint32_t changesOf(const Trial& trial, FluxChange* changes) const;
  void momentsAfter(const FluxChange* changes, std::uint32_t count);
  bool settleExtremes(const FluxChange* changes, std::uint32_t count, const Evaluation& toBeat,
                      Evaluation& result);
  void lightPatches();
  void relightPatches(std::uint32_t count);
  void refresh();
  Prices surveyPrices() const;
  void addComing(const Slope& slope, float* line) const;
  double leaving(const Slope& slope, std::uint32_t from) const;
  MoveProduct productOf(const Slope& slope) const;
  void readLines(const std::vector<float>& closed);
  void readLeaving(const std::vector<std::uint32_t>& luminaires);
  SurveyedLayouts surveyed();
  void hopeFor(std::uint32_t k, const FluxChange* changes, std::uint32_t count);
  void hopeForMoves(std::uint32_t i, const std::uint32_t* candidates);
  void momentsOfMoves(std::uint32_t i, const std::uint32_t* block, std::uint32_t count);
  const double* countedFlux(const ObjectiveSet& set) const {
    return (set.row == RowOf::kGlare ? squares_ : flux_).data();
  }
  void readMoments(const std::vector<std::uint32_t>& sites);
  template <class Lit>
  void light(Lit& lit, const std::vector<std::uint32_t>& sites);
  static void take(const MeanAndLeast& points, Moments& moments, Extremes& extremes);
  void readPoints(const std::vector<std::uint32_t>& sites);
  void addChange(std::uint32_t candidate, double flux);
  std::uint32_t resolve(const FluxChange* changes, std::uint32_t count);
  bool isExact(const Trial& trial);
  bool prefers(const Evaluation& a, const Evaluation& b) const;

  const PreparedScene& prepared_;
  Prices prices_;
  std::vector<double> flux_, squares_;  // squares: of the fluxes
  Objective objective_;
  std::vector<std::uint32_t> sites_;
  Evaluation current_;
  std::vector<Moments> moments_;
  std::vector<std::optional<VarianceSums>> sums_;      // of each set that needs variances,
  std::vector<std::optional<VarianceInTurn>> inTurn_;  // and of it for layouts that it does not stand at
  std::vector<std::optional<PatchExtremes>> patches_;  // of each set that needs extremes
  std::vector<std::optional<PlaneValues>> points_;     // of each set that needs each point of planes
  bool hasPoints_ = false, lightsPatches_ = false, maySurvey_ = false;
  bool leftOut_ = false;                   // true extremes
  std::uint32_t appliedSince_ = 0;         // layouts since all patches were lit
  std::vector<Extremes> extremes_;         // where it stands, of each set that needs them
  std::vector<Moments> trialMoments_;      // scratch, one per set
  std::vector<Extremes> trialExtremes_;    // scratch, one per set
  std::vector<double> means_, variances_;  // scratch, sets x block
  std::vector<double> least_, most_;       // likewise, of what a survey hopes for
  struct LookAround {
    LinearWorth worth;
    std::vector<float> lines;  // of the slopes together, then of each edge: an entry a candidate
    std::vector<MoveProduct> products;
    std::vector<MoveEdge> edges;
    std::vector<std::uint32_t> from;
    std::vector<float> leaving;
  };
  LookAround look_;                                    // scratch of bestMove()
  std::vector<FluxChange> changes_;                    // scratch, one a site
  std::vector<std::uint32_t> litSites_, memberSites_;  // scratch
  std::vector<double> litFlux_;                        // scratch
};

}  // namespace fiatlux
