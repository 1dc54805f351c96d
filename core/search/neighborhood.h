// The neighbourhoods of the local search, one row each, in the order in which the search goes through them.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "core/base/random.h"
#include "core/search/evaluator.h"
#include "core/search/free_sites.h"

namespace fiatlux {

/// One look through a neighbourhood from where the evaluator stands: what its row fills in when it opens, and
/// how far it has got.
struct Scan {
  std::uint32_t luminaire = 0;                               // whose turn it is: given before a row opens
  std::uint32_t partner = 0;                                 // that moves with it
  std::vector<std::uint32_t> candidates, partnerCandidates;  // sites for the two
  std::vector<Move> promising;     // of all luminaires, for pairs of them (best_pairs.h),
  double leastWorth = kUnbounded;  // and what the best pair so far is worth
  std::uint32_t position = 0;      // of the trials, those left out included: a row counts it up
  std::uint32_t size = 0;          // trials in all: the scan ends there
  bool isSurvey = false;           // the candidates are looked at together, kSurveyed at a time
  Trial found;                     // the best so far; its count is 0 while nothing better was found
};

/// What a row works on.
struct Surroundings {
  Evaluator& evaluator;  // stands at the layout whose neighbours are tried
  const FreeSites& freeSites;
  Random& random;
  std::uint64_t walked = 0;  // trials of the walk that the local search comes from; 0: it comes from no walk
  double price = 0;          // of a violation of 100 %, as the walk has learned

  /// May one luminaire's moves be surveyed?
  bool maySurvey() const { return evaluator.maySurvey() && (!freeSites.isTied() || freeSites.isOfOneType()); }
};

struct Neighborhood {
  const char* name;
  /// Prepares a scan and sets its size.
  void (*open)(const Surroundings& at, Scan& scan);
  /// Tries at most `limit` > 0 layouts, counts the position up and returns how many it tried.
  std::uint32_t (*trySome)(const Surroundings& at, Scan& scan, std::uint32_t limit);
  /// Scans in vain that make a turn: then the search goes on to the next row.
  std::uint32_t (*turn)(const Surroundings& at);
  bool afterShakes;     // it is also looked through after a shake, where only a quick search is worth while
  bool startsOver;      // a success in it leads back to the first row; else its own scans go on
  bool needsDifferent;  // it does nothing for luminaires that are all alike
};

/// Each from small to large.
std::span<const Neighborhood> neighborhoods();

}  // namespace fiatlux
