// Variable neighbourhood search (Hansen and Mladenovic; the engine of paper section 5): shake a layout,
// improve it by local search on delta evaluations, and shake again, more strongly. What shakes is an annealed
// walk, longer each time: from the best layout, from luminaires gathered around a site, from anywhere, by
// turns. Between walks, good layouts that were found are crossed. Where all moves can be looked at together,
// every other walk and what follows a crossing take the steps of a tabu search. When that has found nothing
// better for long, all of it starts anew from a random layout: many searches one after another find what one
// long one does not. Bounds on true extremes are left out at first and of every other walk, more or less
// often as that misleads: luminaires that can be dimmed meet them anyhow, and are dimmed so where they are
// put badly, which hides what else they are worth. A pure function of scene, intentions, start and seed; it
// advances in slices of any size without changing its path.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "core/base/random.h"
#include "core/search/annealed_walk.h"
#include "core/search/evaluator.h"
#include "core/search/intentions.h"
#include "core/search/layout_memory.h"
#include "core/search/neighborhood.h"

namespace fiatlux {

/// The rules in terms of the ties of a prepared scene, those that hold pinned sites as `start` has them.
LuminaireRules tiedRules(const PreparedScene& prepared, const LuminaireRules& rules, const TiedStart& start);

class Vns {
 public:
  /// `start`: a layout to improve (the incumbent of the last search when a slider moves), fitted to the
  /// rules; nullptr starts at random. `reference` scales the goals (see Evaluator). The prepared scene must
  /// outlive the search. Precondition: checkIntentions(scene, intentions) passed.
  Vns(PreparedScene& prepared, const Intentions& intentions, std::uint64_t seed,
      const Layout* start = nullptr, const Layout* reference = nullptr);
  /// Among layouts of ties: `prepared` is of them, `start` one of startsOf. The intentions' sites are sites.
  Vns(PreparedScene& prepared, const Intentions& intentions, std::uint64_t seed, const TiedStart& start,
      const Layout* reference = nullptr);

  /// Spends exactly `evaluations` more evaluations (one = one trial layout; a survey is five, a step of a
  /// tabu search as many as last as long), or none when nothing can move.
  void advance(std::uint32_t evaluations);

  /// The best layout so far, always a complete one, and what it is worth.
  Layout incumbent() const;
  const Evaluation& evaluation() const { return isRecordBroken() ? bestEvaluation_ : recordEvaluation_; }

  std::uint64_t evaluations() const { return evaluations_; }
  /// The count of evaluations at which the incumbent was found.
  std::uint64_t foundAt() const { return foundAt_; }

 private:
  Vns(PreparedScene& prepared, const Intentions& intentions, const LuminaireRules& rules, std::uint64_t seed,
      const Layout* reference);
  bool isRecordBroken() const { return isBetter(bestEvaluation_, recordEvaluation_); }
  bool isStuck() const;
  std::uint64_t firstLength();
  void startAnew();
  void open(const std::vector<std::uint32_t>& sites);
  std::vector<std::uint32_t> inSlots(std::vector<std::uint32_t> ties) const;
  std::vector<std::uint32_t> somewhereElse();
  void begin(const std::vector<std::uint32_t>& sites);
  std::uint32_t spend(std::uint32_t limit);
  void openScan();
  void closeScan();
  void take();
  void keepBest();
  void enter(std::size_t neighborhood);
  void leave();
  void shake(const std::vector<std::uint32_t>& sites, const Evaluation& evaluation);
  void remember(const std::vector<std::uint32_t>& sites, const Evaluation& evaluation);
  bool isCrossingWorthwhile();
  void beginCrossing();
  std::uint32_t tryCrossings(std::uint32_t limit);
  void tryCrossing();
  void searchChild(const std::vector<std::uint32_t>& child);
  void beginGatherings();
  std::uint32_t tryGatherings(std::uint32_t limit);
  void follow(const std::vector<std::uint32_t>& sites);
  void beginWalk(const std::vector<std::uint32_t>& sites, double heat);
  void closeStep();
  void endWalk();
  void searchTruly();
  void relax(bool relaxed);
  bool isRelaxing() const;
  Surroundings here() {
    return {evaluator_, freeSites_, random_, crossing_ ? 0 : walk_.trials(), walk_.penalty()};
  }

  std::uint64_t evaluations_ = 0, foundAt_ = 0;
  Evaluator evaluator_;
  FreeSites freeSites_;
  Random random_;
  PreparedScene& prepared_;
  LuminaireRules rules_;  // in terms of the candidates
  bool areDifferent_;     // in flux or in the way that they may hang: to change places is a move

  std::vector<std::uint32_t> best_;  // since the search started anew
  Evaluation bestEvaluation_;
  std::vector<std::uint32_t> record_;  // the best before that
  Evaluation recordEvaluation_ = kNothingFound;
  std::uint32_t walksAtBest_ = 0;  // walks when the best was found

  // The running local search: which neighbourhood is looked through, and how far.
  std::size_t neighborhood_ = 0;  // row of neighborhoods()
  bool thorough_ = true;          // all rows, not only those after shakes
  std::uint32_t fruitless_ = 0;   // scans in a row that found nothing
  bool scanning_ = false;
  Scan scan_;

  // The running walk, whose steps are scans too.
  std::uint64_t length_;  // of the next one, trials
  AnnealedWalk walk_;
  bool walking_ = false;
  std::uint32_t walks_ = 0;
  bool foundSince_ = false;            // a new incumbent, since it began
  std::vector<std::uint32_t> walked_;  // its best layout
  Evaluation walkedEvaluation_;
  bool relaxed_ = false;      // true extremes are left out, of a walk or of the first local search
  std::uint32_t misled_ = 1;  // one walk in 2^misled_ leaves them out

  // What local searches have found, and the crossings of it.
  LayoutMemory memory_;
  bool crossing_ = false;        // the local search is of a crossing,
  bool easing_ = false;          // at the prices of the last walk
  std::uint64_t work_ = 0;       // trials since the last local search ended,
  std::uint64_t crossWork_ = 0;  // of all crossings,
  std::uint64_t otherWork_ = 0;  // and of all else
  std::uint32_t inVain_ = 0;     // crossings in a row of which nothing was kept

  // Crossings that are being tried, for a local search from the best of them.
  bool choosing_ = false;
  std::uint32_t crossed_ = 0;              // trials
  std::vector<std::uint32_t> child_;       // the best so far
  std::vector<std::uint32_t> otherChild_;  // the one that is being tried
  std::uint32_t childMissing_ = 0;         // luminaires, to be far from all that is kept
  double childWorth_ = 0;                  // a broken bound at its price

  // Gatherings that are being tried.
  bool gathering_ = false;
  std::uint32_t gatherings_ = 0;
  std::uint32_t centers_ = 0;               // of gatherings of all luminaires; 0: of some, anywhere
  std::vector<std::uint32_t> gatheredNow_;  // the one that is being tried
  std::vector<std::uint32_t> gathered_;     // the best so far of those tried
  Evaluation gatheredEvaluation_;
};

}  // namespace fiatlux
