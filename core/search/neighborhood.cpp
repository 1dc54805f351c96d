// The rows; see neighborhood.h.
#include "core/search/neighborhood.h"

#include <algorithm>

#include "core/search/best_pairs.h"

namespace fiatlux {
namespace {

constexpr std::uint32_t kNearReach = 12;  // sites tried around a luminaire
constexpr std::uint32_t kPairReach = 8;   // and around each of two

std::uint32_t countOf(const std::vector<std::uint32_t>& list) {
  return static_cast<std::uint32_t>(list.size());
}

std::uint32_t everyLuminaire(const Surroundings& at) { return countOf(at.freeSites.movable()); }

std::uint32_t onceForAll(const Surroundings&) { return 1; }

// --- One luminaire to another site: near ones, then any.

/// Nobody in one place is as good as in another: only the first is looked at.
bool isNobodyAgain(const Surroundings& at, const Scan& scan) {
  const std::vector<std::uint32_t>&movable = at.freeSites.movable(), &sites = at.evaluator.sites();
  const auto isNobody = [&](std::uint32_t i) { return at.freeSites.isNobody(sites[i]); };
  return isNobody(scan.luminaire) &&
         *std::find_if(movable.begin(), movable.end(), isNobody) != scan.luminaire;
}

/// Looks at the candidates together, kSurveyed at a time; the luminaire's own site is the first and fills up.
void openSurveys(const Surroundings& at, Scan& scan) {
  const std::uint32_t surveys = surveysOf(scan.candidates.size());
  scan.candidates.resize(std::size_t{surveys} * kSurveyed, at.evaluator.sites()[scan.luminaire]);
  scan.size = surveys * kTrialsPerSurvey;
  scan.isSurvey = true;
}

/// Looks at the candidates, none of which is the luminaire's own, together where that may be.
void openMoves(const Surroundings& at, Scan& scan) {
  if (at.maySurvey()) {
    scan.candidates.insert(scan.candidates.begin(), at.evaluator.sites()[scan.luminaire]);
    return openSurveys(at, scan);
  }
  scan.isSurvey = false;
  scan.size = isNobodyAgain(at, scan) ? 0 : countOf(scan.candidates);
}

void openNear(const Surroundings& at, Scan& scan) {
  const std::uint32_t from = at.evaluator.sites()[scan.luminaire];
  const std::uint32_t ways = at.freeSites.waysPerPlace();
  if (at.maySurvey() && ways == 1) {
    at.freeSites.around(from, kSurveyed - 1, kSurveyed, at.random, scan.candidates);
    return openSurveys(at, scan);
  }
  at.freeSites.nearMoves(from, kNearReach * ways, scan.candidates);
  openMoves(at, scan);
}

void openFar(const Surroundings& at, Scan& scan) {
  at.freeSites.farMoves(at.evaluator.sites()[scan.luminaire], scan.candidates);
  openMoves(at, scan);
}

/// The surveys choose one move, which a trial of its own judges: counted with them.
void survey(const Surroundings& at, Scan& scan) {
  const std::uint32_t from = scan.candidates[0];
  double worths[kSurveyed], least = 0;
  std::uint32_t chosen = from;
  for (std::size_t first = 0; first < scan.candidates.size(); first += kSurveyed) {
    const std::uint32_t* block = scan.candidates.data() + first;
    at.evaluator.survey(scan.luminaire, block, worths);
    if (first == 0) least = worths[0];
    for (std::uint32_t k = 0; k < kSurveyed; ++k) {
      if (!(worths[k] < least) || !at.freeSites.mayMove(from, block[k])) continue;
      least = worths[k];
      chosen = block[k];
    }
  }
  if (chosen != from) at.evaluator.tryMoves(scan.luminaire, &chosen, 1, scan.found);
}

std::uint32_t tryMoves(const Surroundings& at, Scan& scan, std::uint32_t limit) {
  const std::uint32_t tried = std::min(limit, scan.size - scan.position);
  if (!scan.isSurvey)
    at.evaluator.tryMoves(scan.luminaire, scan.candidates.data() + scan.position, tried, scan.found);
  else if (tried > 0 && scan.position + tried == scan.size)
    survey(at, scan);
  scan.position += tried;
  return tried;
}

// --- Two luminaires of different flux, type, turn or aim change places: all of them in one scan.

void openSwaps(const Surroundings& at, Scan& scan) {
  scan.size = countOf(at.freeSites.movable()) * countOf(at.freeSites.movable());
}

std::uint32_t trySwaps(const Surroundings& at, Scan& scan, std::uint32_t limit) {
  const std::vector<std::uint32_t>&movable = at.freeSites.movable(), &sites = at.evaluator.sites();
  std::uint32_t tried = 0;
  for (; scan.position < scan.size && tried < limit; ++scan.position) {
    const std::uint32_t i = movable[scan.position / movable.size()],
                        j = movable[scan.position % movable.size()];
    if (i >= j) continue;
    const std::uint32_t to = at.freeSites.exchanged(sites[i], sites[j]),
                        partnerTo = at.freeSites.exchanged(sites[j], sites[i]);
    if (to == kNone || partnerTo == kNone) continue;  // one of the two does not fit there
    if (at.evaluator.flux()[i] == at.evaluator.flux()[j] && to == sites[j]) continue;
    if (!at.freeSites.mayExchange(sites[i], to, sites[j], partnerTo)) continue;
    at.evaluator.tryPair({i, to}, {j, partnerTo}, scan.found);
    ++tried;
  }
  return tried;
}

// --- Two luminaires at once, each to a near site: a pair of ties may trade its weight.

void openPairs(const Surroundings& at, Scan& scan) {
  scan.partner = at.freeSites.randomMovable(at.random);
  const std::vector<std::uint32_t>& sites = at.evaluator.sites();
  at.freeSites.anyNearMoves(sites[scan.luminaire], kPairReach, at.random, scan.candidates);
  at.freeSites.anyNearMoves(sites[scan.partner], kPairReach, at.random, scan.partnerCandidates);
  const bool two = scan.partner != scan.luminaire;
  scan.size = two ? countOf(scan.candidates) * countOf(scan.partnerCandidates) : 0;
}

std::uint32_t tryPairs(const Surroundings& at, Scan& scan, std::uint32_t limit) {
  const std::uint32_t second = countOf(scan.partnerCandidates);
  const std::uint32_t from = at.evaluator.sites()[scan.luminaire],
                      partnerFrom = at.evaluator.sites()[scan.partner];
  std::uint32_t tried = 0;
  for (; scan.position < scan.size && tried < limit; ++scan.position) {
    const std::uint32_t a = scan.candidates[scan.position / second],
                        b = scan.partnerCandidates[scan.position % second];
    if (at.freeSites.conflict(a, b) || !at.freeSites.keepsCount(from, a, partnerFrom, b)) continue;
    at.evaluator.tryPair({scan.luminaire, a}, {scan.partner, b}, scan.found);
    ++tried;
  }
  return tried;
}

// name, open, trySome, turn, afterShakes, startsOver, needsDifferent
constexpr Neighborhood kNeighborhoods[] = {
    {"near", openNear, tryMoves, everyLuminaire, true, false, false},
    {"far", openFar, tryMoves, everyLuminaire, false, false, false},
    {"swaps", openSwaps, trySwaps, onceForAll, true, false, true},
    {"best pairs", openBestPairs, tryBestPairs, onceForAll, true, true, false},
    {"pairs", openPairs, tryPairs, everyLuminaire, false, true, false},
};

}  // namespace

std::span<const Neighborhood> neighborhoods() { return kNeighborhoods; }

}  // namespace fiatlux
