// The shake of the search: an annealed walk from a layout (Kirkpatrick, Gelatt and Vecchi 1983). A step looks
// at a few sites for one luminaire and takes the best of them, a worse layout too while it is hot. Where
// trials may be surveyed (objective.h), it looks at all near ones at once, the luminaire's own too, and takes
// each with about the chance that the temperature gives it; that counts for as many trials as last as long.
// The temperature is led by how many steps are taken, which are to become fewer; a broken bound costs a
// penalty, which grows while bounds are broken and shrinks while they are met, so that the walk keeps to
// their edge. Neither knows any unit. What a missed aim costs is little at first, for one that is met hardly
// lets anything move, and in the end as much as leads there. A walk may also take the steps of a tabu search
// (tabu.h) at the same prices.
#pragma once

#include <cstdint>

#include "core/search/neighborhood.h"
#include "core/search/tabu.h"

namespace fiatlux {

class AnnealedWalk {
 public:
  /// `swaps`: to change places is a move; `bounded`: there are constraints; `aimShare`: of what missed aims
  /// cost, at the end of a walk.
  AnnealedWalk(bool swaps, bool bounded, double aimShare)
      : swaps_(swaps), bounded_(bounded), lastAimShare_(aimShare) {}

  /// Starts anew, for about `trials` trials. `heat`: 1 forgets where it starts, less keeps something of it;
  /// `goal`: a value that goals have. What a broken bound costs is what the last walk learned.
  void begin(std::uint64_t trials, double heat, double goal);

  /// The same by steps of a tabu search, which come to layouts that warmth does not, and the other way round.
  /// Precondition: Tabu::isPossible().
  void beginTabu(std::uint64_t trials, double goal);
  /// The same from a layout that is near its aims: what they cost does not rise from little again.
  void beginTabuNear(std::uint64_t trials, double goal);

  /// Prepares a step from where the evaluator stands, whose penalty it sets, and opens the scan for it.
  void open(const Surroundings& at, Scan& scan);
  /// As of a row (neighborhood.h).
  std::uint32_t trySome(const Surroundings& at, Scan& scan, std::uint32_t limit);
  /// After a step of `scan` that led to `current`, or to nothing when nothing was found.
  void close(const Scan& scan, const Evaluation& current);

  bool isDone() const { return done_ >= trials_; }
  std::uint64_t trials() const { return trials_; }
  /// What a violation of 100 % costs, in units of the goal; 0 where there are no constraints.
  double penalty() const { return penalty_; }
  /// What counts at the end of a walk, as the last one has learned.
  Prices prices() const { return {penalty_, lastAimShare_}; }

 private:
  void survey(const Surroundings& at, Scan& scan) const;
  bool openSwap(const Surroundings& at, Scan& scan) const;

  bool swaps_, bounded_, byTabu_ = false;
  Tabu tabu_;
  double lastAimShare_;
  std::uint64_t trials_ = 0, done_ = 0;
  double heat_ = 1, scale_ = 1;
  double temperature_ = 0;  // in units of the goal, as is
  double penalty_ = 0;      // of a violation of 100 %
  double aimShare_ = 1;     // of what missed aims cost
  double taken_ = 0;        // share of the latest steps
  double follow_ = 0;       // of what is measured and led, a step
};

}  // namespace fiatlux
