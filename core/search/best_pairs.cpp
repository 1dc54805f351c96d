// Lists of sites, then surveys of their pairs; see best_pairs.h.
#include "core/search/best_pairs.h"

#include <algorithm>
#include <utility>

namespace fiatlux {
namespace {

constexpr std::uint32_t kSites = 6;                // of each luminaire
constexpr std::uint32_t kPartsOfAWalk = 4;         // a scan is at most one of them
constexpr std::uint32_t kPairs = kSites * kSites;  // of the sites of two luminaires

/// A scan in surveys: first of each luminaire's sites, then of pairs.
struct Plan {
  std::uint32_t luminaires, surveysOfEach, surveysOfPairs;

  explicit Plan(const Surroundings& at)
      : luminaires(static_cast<std::uint32_t>(at.freeSites.movable().size())),
        surveysOfEach(surveysOf(at.freeSites.candidateCount())),
        surveysOfPairs(surveysOf(std::uint64_t{luminaires} * (luminaires / 2) * kPairs)) {}

  std::uint64_t trials() const {
    return std::uint64_t{kTrialsPerSurvey} * (std::uint64_t{luminaires} * surveysOfEach + surveysOfPairs);
  }
};

/// The sites that are best for the luminaire alone, all but its own; that fills up where there are few.
void addSites(const Surroundings& at, std::uint32_t luminaire, Scan& scan) {
  const std::uint32_t own = at.evaluator.sites()[luminaire];
  std::vector<std::uint32_t> free;
  at.freeSites.farMoves(own, free);
  const std::size_t count = free.size();
  free.resize(std::size_t{surveysOf(count)} * kSurveyed, own);
  std::vector<std::pair<double, std::uint32_t>> order;
  double worths[kSurveyed];
  for (std::size_t first = 0; first < count; first += kSurveyed) {
    at.evaluator.survey(luminaire, free.data() + first, worths);
    for (std::size_t k = first; k < std::min(count, first + kSurveyed); ++k)
      order.emplace_back(worths[k - first], free[k]);
  }
  order.resize(std::max<std::size_t>(order.size(), kSites), {kUnbounded, own});
  std::partial_sort(order.begin(), order.begin() + kSites, order.end());
  for (std::uint32_t k = 0; k < kSites; ++k) scan.promising.push_back({luminaire, order[k].second});
}

/// Do the rules allow both moves at once, each of which they allow alone?
bool areTogether(const Surroundings& at, const Move& a, const Move& b) {
  const std::vector<std::uint32_t>& sites = at.evaluator.sites();
  return !at.freeSites.conflict(a.site, b.site) &&
         at.freeSites.keepsCount(sites[a.luminaire], a.site, sites[b.luminaire], b.site);
}

/// Surveys the pairs from number `first` on; the most promising of all scans so far is judged by a trial.
void surveyPairs(const Surroundings& at, std::uint64_t first, Scan& scan) {
  const std::uint64_t luminaires = scan.promising.size() / kSites,
                      all = luminaires * (luminaires / 2) * kPairs;
  Move one[kSurveyed], other[kSurveyed];
  for (std::uint32_t k = 0; k < kSurveyed; ++k) {
    // Each luminaire with the next one, then each with the next but one, to half-way round.
    const std::uint64_t number = (first + k) % all, pair = number / kPairs;
    const std::uint64_t a = pair % luminaires, b = (a + 1 + pair / luminaires) % luminaires;
    one[k] = scan.promising[a * kSites + number % kPairs / kSites];
    other[k] = scan.promising[b * kSites + number % kSites];
  }
  double worths[kSurveyed];
  at.evaluator.surveyPairs(one, other, worths);
  std::uint32_t best = kSurveyed;
  for (std::uint32_t k = 0; k < kSurveyed; ++k) {
    if (!(worths[k] < scan.leastWorth) || !areTogether(at, one[k], other[k])) continue;
    scan.leastWorth = worths[k];
    best = k;
  }
  if (best < kSurveyed) at.evaluator.tryPair(one[best], other[best], scan.found);
}

}  // namespace

void openBestPairs(const Surroundings& at, Scan& scan) {
  scan.promising.clear();
  scan.leastWorth = kUnbounded;
  const Plan plan(at);
  const bool isShort = kPartsOfAWalk * plan.trials() <= at.walked;
  scan.size =
      isShort && at.maySurvey() && plan.luminaires > 1 ? static_cast<std::uint32_t>(plan.trials()) : 0;
}

std::uint32_t tryBestPairs(const Surroundings& at, Scan& scan, std::uint32_t limit) {
  const Plan plan(at);
  const std::uint32_t tried = std::min(limit, scan.size - scan.position), end = scan.position + tried;
  const std::uint32_t perLuminaire = kTrialsPerSurvey * plan.surveysOfEach;
  const std::uint32_t listed = perLuminaire * plan.luminaires;
  at.evaluator.setPrices({at.price});
  for (std::uint32_t i = scan.position / perLuminaire; i < plan.luminaires && (i + 1) * perLuminaire <= end;
       ++i)
    addSites(at, at.freeSites.movable()[i], scan);
  at.evaluator.setPrices({});
  const std::uint32_t from = std::max(scan.position, listed);
  for (std::uint32_t s = (from - listed) / kTrialsPerSurvey; listed + (s + 1) * kTrialsPerSurvey <= end; ++s)
    surveyPairs(at, std::uint64_t{s} * kSurveyed, scan);
  scan.position = end;
  return tried;
}

}  // namespace fiatlux
