// The words of the alpha-search; see alpha_verdict.h.
#include "core/alpha/alpha_verdict.h"

#include <cassert>

#include "core/base/short_number.h"
#include "core/scene/surface_names.h"

namespace fiatlux {
namespace {

std::string text(double value) { return shortNumber(value, 4); }

/// "the darkest patch has 41 lx" of the layout that answers.
std::string extremeOf(const AlphaIteration& found, bool minimum, const std::string& unit) {
  return (minimum ? "the darkest patch has " : "the brightest patch has ") +
         text(minimum ? found.minimum : found.maximum) + unit;
}

/// Why no alpha answers.
std::string failureOf(AlphaOutcome outcome, const std::string& guarantee) {
  switch (outcome) {
    case AlphaOutcome::kNoLayout:
      return "No layout found can give " + guarantee + ": even the means fall short.";
    case AlphaOutcome::kTwoEmpty:
      return "No alpha leads to " + guarantee +
             ": with a small one some patches miss it, with a larger one no layout meets the margin.";
    default:
      return "Stopped before an alpha was found that keeps " + guarantee + ".";
  }
}

/// What would be feasible instead.
std::string cureOf(const AlphaSearch& search, bool minimum, double asked, const std::string& unit) {
  if (!search.fallback()) return " The other intentions cannot all be met either: relax one of them first.";
  const double feasible = search.feasibleBound();
  if (minimum ? feasible >= asked : feasible <= asked)
    return " A search on the patches themselves does find such a layout, with " + text(feasible) + unit + ".";
  return std::string(" The ") + (minimum ? "largest minimum" : "smallest maximum") + " found feasible is " +
         text(feasible) + unit + ": ask for that, or add luminaires or flux.";
}

}  // namespace

std::string alphaVerdict(const AlphaSearch& search, const Scene& scene, Quantity quantity,
                         const Constraint& guarantee) {
  assert(search.done());
  const bool minimum = guarantee.statistic == Statistic::kMinimum;
  const double asked = minimum ? guarantee.lower : guarantee.upper;
  const std::string unit = std::string(" ") + unitName(guarantee.statistic, quantity);
  const std::string promise = (minimum ? "at least " : "at most ") + text(asked) + unit +
                              " on every patch of " + surfaceSetName(scene, guarantee.surfaces);
  const AlphaIteration* found = search.solution();
  if (!found) return failureOf(search.outcome(), promise) + cureOf(search, minimum, asked, unit);
  const std::string extreme = extremeOf(*found, minimum, unit);
  if (search.outcome() == AlphaOutcome::kZeroSuffices)
    return "The best layout keeps " + promise + " without further care (alpha 0): " + extreme + ".";
  return "With alpha = " + text(found->alpha) + ", the smallest found, the layout keeps " + promise + ": " +
         extreme + ".";
}

}  // namespace fiatlux
