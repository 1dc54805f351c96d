// True extremes asked for, their Chebyshev form, and whether they hold; see guarantees.h.
#include "core/alpha/guarantees.h"

#include <algorithm>
#include <cmath>

#include "core/search/validate_intentions.h"

namespace fiatlux {

bool isGuarantee(const Constraint& c) {
  if (c.onGrid) return false;  // mean and sigma are of all patches
  return (c.statistic == Statistic::kMinimum && std::isfinite(c.lower)) ||
         (c.statistic == Statistic::kMaximum && std::isfinite(c.upper));
}

Result<Done> checkAlphaIntentions(const Scene& scene, const Intentions& intentions) {
  if (auto ok = checkIntentions(scene, intentions); !ok) return ok;
  for (const Goal& goal : intentions.goals)
    if (goal.sense == Sense::kNear)
      return Error{
          "an alpha is found for the least or the most of something, not for what is near a target; change "
          "the "
          "goal's sense to \"min\" or \"max\""};
  for (const Constraint& c : intentions.constraints)
    if (isGuarantee(c)) return Done{};
  return Error{
      "there is no guarantee to find an alpha for; add a constraint on \"minimum\" with \"min\", or on "
      "\"maximum\" "
      "with \"max\""};
}

Intentions chebyshevProblem(const Intentions& intentions, double alpha) {
  Intentions problem = intentions;
  problem.constraints.clear();
  for (const Constraint& c : intentions.constraints) {
    if (!isGuarantee(c)) {
      problem.constraints.push_back(c);
      continue;
    }
    const bool minimum = c.statistic == Statistic::kMinimum;
    Constraint replaced = c;
    replaced.statistic = Statistic::kChebyshev;
    replaced.alpha = alpha;
    replaced.lower = -kUnbounded;
    replaced.upper = kUnbounded;
    (minimum ? replaced.lower : replaced.upper) = minimum ? c.lower : c.upper;
    problem.constraints.push_back(replaced);
    // The other side of a guarantee (a minimum from above, say) has no Chebyshev form and stays what it is.
    Constraint rest = c;
    (minimum ? rest.lower : rest.upper) = minimum ? -kUnbounded : kUnbounded;
    if (std::isfinite(rest.lower) || std::isfinite(rest.upper)) problem.constraints.push_back(rest);
  }
  return problem;
}

double shortfallOf(const Constraint& guarantee, const Extremes& extremes) {
  const bool minimum = guarantee.statistic == Statistic::kMinimum;
  const double bound = minimum ? guarantee.lower : guarantee.upper;
  const double excess = minimum ? bound - extremes.minimumLow : extremes.maximumHigh - bound;
  return excess / std::max(std::fabs(bound), 1e-12);
}

}  // namespace fiatlux
