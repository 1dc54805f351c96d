// Checks of luminaires, goals and constraints; see validate_intentions.h.
#include "core/search/validate_intentions.h"

#include <algorithm>
#include <cmath>

#include "core/base/short_number.h"
#include "core/scene/calculation_grid.h"
#include "core/scene/plane_points.h"
#include "core/search/arrangements.h"
#include "core/search/prepared_scene.h"
#include "core/search/start_layout.h"
#include "core/search/type_counts.h"

namespace fiatlux {
namespace {

constexpr std::uint32_t kMostLuminaires = 1000;

std::string text(double value) { return shortNumber(value, 6); }

std::string text(std::size_t value) { return std::to_string(value); }

/// A site by its number in the room.
std::string siteText(const Scene& scene, std::uint32_t site) {
  return text(std::size_t{scene.hangings.empty() ? site : scene.hangings[site].place});
}

std::string countText(const LuminaireRules& rules) {
  return text(std::size_t{rules.count}) +
         (countVaries(rules) ? " to " + text(std::size_t{rules.countHigh}) : "");
}

Result<Done> checkCount(const LuminaireRules& rules) {
  if (rules.count == 0 || mostOf(rules) > kMostLuminaires)
    return Error{"luminaires: a count of " + countText(rules) + "; it must be 1 to " +
                 text(std::size_t{kMostLuminaires})};
  if (rules.countHigh > 0 && rules.countHigh < rules.count)
    return Error{"luminaires: a count from " + text(std::size_t{rules.count}) + " to " +
                 text(std::size_t{rules.countHigh}) + "; the least comes first"};
  return Done{};
}

Result<Done> checkArrangement(const Scene& scene, const LuminaireRules& rules) {
  const Arrangement& asked = rules.arrangement;
  const std::string name = kRuleNames[static_cast<std::size_t>(asked.rule)];
  if (asked.rule == Rule::kFree && asked.axis != PlanAxis::kFound)
    return Error{"arrangement: \"" + name + "\" has no axis; drop it"};
  if (asked.rule == Rule::kRows && asked.axis == PlanAxis::kBoth)
    return Error{"arrangement: rows run along one axis; say \"x\", \"z\" or \"found\""};
  if (asked.leastInRow < 2)
    return Error{"arrangement: a row has at least two luminaires; say so many as \"leastInRow\""};
  if (rules.flux.size() > 1 && asked.rule != Rule::kFree)
    return Error{"arrangement: luminaires that are tied are all alike; give one flux"};
  if (rules.flux.size() > 1 && countVaries(rules))
    return Error{"luminaires: where their count may vary they are all alike; give one flux"};
  if (hasRoom(scene, rules)) return Done{};
  const char* const what[] = {"layout", "symmetric layout", "layout in rows", "regular field"};
  const bool areRows = asked.rule == Rule::kRows;
  return Error{"arrangement: found no " + std::string(what[static_cast<std::size_t>(asked.rule)]) + " of " +
               countText(rules) + " luminaires" +
               (areRows ? ", at least " + text(std::size_t{asked.leastInRow}) + " in each," : "") +
               " on the free sites; change the count, give it a range, or free the arrangement"};
}

Result<Done> checkFluxes(const LuminaireRules& rules) {
  if (rules.flux.size() != 1 && rules.flux.size() != rules.count)
    return Error{"luminaires: " + text(rules.flux.size()) + " fluxes for " + text(std::size_t{rules.count}) +
                 " luminaires; give one for all or one for each"};
  for (double flux : rules.flux)
    if (!(flux > 0) || !(flux <= 1e9))
      return Error{"luminaires: a flux of " + text(flux) + " lm; it must be above 0"};
  if (!(rules.dimmingLow >= 0) || !(rules.dimmingHigh <= 1) || !(rules.dimmingLow <= rules.dimmingHigh) ||
      !(rules.dimmingHigh > 0))
    return Error{"luminaires: dimming from " + text(rules.dimmingLow) + " to " + text(rules.dimmingHigh) +
                 "; it must be a range within 0 to 1"};
  return Done{};
}

Result<Done> checkSites(const Scene& scene, const LuminaireRules& rules) {
  const std::size_t m = scene.sites.size();
  std::vector<char> excluded(m, 0), pinned(m, 0);
  std::size_t free = m;
  for (std::uint32_t site : rules.excluded) {
    if (site >= m)
      return Error{"luminaires: excluded site " + text(std::size_t{site}) +
                   " does not exist; sites are 0 to " + text(m - 1)};
    if (!excluded[site]) --free;
    excluded[site] = 1;
  }
  for (std::uint32_t site : rules.pinned) {
    if (site == kNone) continue;
    if (site >= m)
      return Error{"luminaires: pinned site " + text(std::size_t{site}) + " does not exist; sites are 0 to " +
                   text(m - 1)};
    if (excluded[site])
      return Error{"luminaires: site " + siteText(scene, site) +
                   " is both pinned and excluded; drop one of the two"};
    if (pinned[site])
      return Error{"luminaires: site " + siteText(scene, site) +
                   " is pinned twice; a site holds one luminaire"};
    pinned[site] = 1;
  }
  if (rules.pinned.size() > mostOf(rules))
    return Error{"luminaires: " + text(rules.pinned.size()) + " are pinned but the count is " +
                 countText(rules) + "; raise the count or unpin"};
  if (rules.count > free)
    return Error{"luminaires: " + text(std::size_t{rules.count}) + " luminaires on " + text(free) +
                 " free sites; lower the count or exclude fewer sites"};
  return Done{};
}

std::string quoted(const LuminaireRules& rules, std::size_t type) {
  const bool isNamed = type < rules.types.size() && !rules.types[type].name.empty();
  return isNamed ? "\"" + rules.types[type].name + "\"" : "type " + text(type + 1);
}

/// Each range by itself, then all of them against the count.
Result<Done> checkTypeRanges(const LuminaireRules& rules, const std::vector<TypeRange>& ranges) {
  std::size_t least = 0, most = 0;
  for (std::size_t t = 0; t < ranges.size(); ++t) {
    if (t < rules.types.size() && rules.types[t].least > ranges[t].most)
      return Error{"luminaires: " + quoted(rules, t) + ": a count from " +
                   text(std::size_t{ranges[t].least}) + " to " + text(std::size_t{ranges[t].most}) +
                   "; the least comes first"};
    if (ranges[t].least > ranges[t].most)
      return Error{"luminaires: " + text(std::size_t{ranges[t].least}) + " of them must be of " +
                   quoted(rules, t) + ", of which there may be " + text(std::size_t{ranges[t].most}) +
                   "; raise its count"};
    least += ranges[t].least;
    most += std::min(ranges[t].most, mostOf(rules));
  }
  const std::string count = countText(rules);
  if (least > mostOf(rules))
    return Error{"luminaires: the types ask for " + text(least) + " together, but the count is " + count +
                 "; raise it or ask for fewer of a type"};
  if (least > rules.count)
    return Error{"luminaires: the types ask for " + text(least) + " together, but the count is " + count +
                 "; begin its range at " + text(least)};
  if (most < rules.count)
    return Error{"luminaires: the types allow " + text(most) + " together, but the count is " + count +
                 "; lower it or allow more of a type"};
  return Done{};
}

/// Luminaires that must be of a type, and pinned ones.
Result<Done> checkTypesAsked(const Scene& scene, const LuminaireRules& rules) {
  const std::uint32_t types = typeCountOf(scene);
  if (rules.ofType.size() > mostOf(rules))
    return Error{"luminaires: L" + text(rules.ofType.size()) + " must be of a type, but the count is " +
                 countText(rules) + "; raise it"};
  for (std::size_t i = 0; i < rules.ofType.size(); ++i) {
    const std::uint32_t type = rules.ofType[i];
    if (type == kNone) continue;
    if (type >= types)
      return Error{"luminaires: L" + text(i + 1) + " must be of " + quoted(rules, type) +
                   ", which fits nowhere in this room"};
    if (isPinned(rules, static_cast<std::uint32_t>(i)) && scene.hangings[rules.pinned[i]].type != type)
      return Error{"luminaires: L" + text(i + 1) + " must be of " + quoted(rules, type) +
                   ", but is pinned as one of " + quoted(rules, scene.hangings[rules.pinned[i]].type) +
                   "; unpin it"};
  }
  return Done{};
}

Result<Done> checkTypes(const Scene& scene, const LuminaireRules& rules) {
  if (scene.hangings.empty()) {
    if (rules.types.empty() && rules.ofType.empty()) return Done{};
    return Error{"luminaires: this room is asked about squares of light, which have no types"};
  }
  if (rules.flux.size() > 1)
    return Error{"luminaires: their types say the flux; give no fluxes of their own"};
  if (auto ok = checkTypesAsked(scene, rules); !ok) return ok;
  if (auto ok = checkTypeRanges(rules, rangesOf(rules, typeCountOf(scene))); !ok) return ok;
  if (!TypeCounts(scene, rules).isAsked()) return Done{};
  const PreparedScene prepared(scene);
  const std::vector<std::uint32_t> sites = packSites(prepared, rules);
  TypeCounts counts(scene, rules);
  for (const std::uint32_t site : sites) counts.add(prepared.typeOf(site), 1);
  if (sites.size() < rules.count || !counts.areMet())
    return Error{"luminaires: found no " + countText(rules) +
                 " places with as many of each type as is asked for; lower the count or widen the ranges"};
  return Done{};
}

Result<Done> checkDistance(const Scene& scene, const LuminaireRules& rules) {
  if (!(rules.minDistance >= 0) || !std::isfinite(rules.minDistance))
    return Error{"luminaires: a minimum distance of " + text(rules.minDistance) + " m; it must be 0 or more"};
  if (rules.minDistance == 0) return Done{};
  for (std::uint32_t i = 0; i < rules.pinned.size(); ++i)
    for (std::uint32_t j = 0; j < i; ++j) {
      if (!isPinned(rules, i) || !isPinned(rules, j)) continue;
      const double distance =
          length(scene.sites[rules.pinned[i]].position - scene.sites[rules.pinned[j]].position);
      if (isTooNear(distance, rules.minDistance))
        return Error{"luminaires: pinned sites " + siteText(scene, rules.pinned[j]) + " and " +
                     siteText(scene, rules.pinned[i]) + " are " + text(distance) +
                     " m apart, closer than the minimum distance of " + text(rules.minDistance) + " m"};
    }
  const PreparedScene prepared(scene);
  const std::size_t room = packSites(prepared, rules).size();
  if (room >= rules.count) return Done{};
  const std::string found =
      "luminaires: found room for only " + text(room) + " of " + text(std::size_t{rules.count});
  constexpr double kFelt = 0.01;  // m: less keeps luminaires of types off one site, no more
  if (prepared.hasBodies() && rules.minDistance < kFelt)
    return Error{found + " luminaires that do not run into each other; lower the count or take smaller ones"};
  return Error{found + " luminaires " + text(rules.minDistance) +
               " m apart; lower the count or the minimum distance"};
}

Result<Done> checkSurfaces(const Scene& scene, const SurfaceSet& surfaces, Quantity quantity,
                           const std::string& where) {
  for (std::size_t i = 0; i < surfaces.size(); ++i) {
    if (surfaces[i] >= scene.surfaces.size())
      return Error{where + ": surface number " + text(std::size_t{surfaces[i]}) + " does not exist"};
    if (i > 0 && surfaces[i] <= surfaces[i - 1])
      return Error{where + ": the surfaces of a set must be sorted and different"};
    if (quantity == Quantity::kExitance && scene.surfaces[surfaces[i]].measuring)
      return Error{where + ": \"" + scene.surfaces[surfaces[i]].name +
                   "\" is a measuring plane and reflects nothing; ask for illuminance"};
  }
  return Done{};
}

/// Of a goal or a constraint.
template <class Intention>
Result<Done> checkSets(const Scene& scene, const Intention& of, Quantity quantity, const std::string& where) {
  const StatisticTraits& traits = traitsOf(of.statistic);
  if ((!traits.needsSurfaces || traits.ofPlanes) && of.quantity)
    return Error{where + ": " + traits.name + " is of no quantity; leave it out"};
  if (!traits.needsSurfaces) return Done{};
  if (traits.ofPlanes) return checkSurfaces(scene, of.surfaces, Quantity::kIlluminance, where);
  if (quantity == Quantity::kDirect && !scene.direct && !scene.lightOperator)
    return Error{
        where +
        ": this room's file does not tell direct light apart; make it again with fiatlux precompute, "
        "without --no-exchange"};
  if (auto ok = checkSurfaces(scene, of.surfaces, quantity, where); !ok) return ok;
  if (traits.needsOver) return checkSurfaces(scene, of.over, quantity, where);
  return Done{};
}

/// "mean, sigma, power and contrast"
std::string goalNames() {
  std::string names, last;
  for (const StatisticTraits& traits : kStatistics) {
    if (!traits.mayBeGoal) continue;
    if (!last.empty()) names += (names.empty() ? "" : ", ") + last;
    last = traits.name;
  }
  return names + " and " + last;
}

Result<Done> checkGoal(const Scene& scene, const Goal& goal, Quantity quantity, Asking asking,
                       const std::string& where) {
  const StatisticTraits& traits = traitsOf(goal.statistic);
  if (!traits.mayBeGoal && !(asking == Asking::kBoundSearch && traits.needsExtremes))
    return Error{where + ": " + statisticName(goal.statistic) +
                 " cannot be a goal, only a constraint; goals are " + goalNames()};
  if (goal.sense == Sense::kNear && !traits.mayBeAimed)
    return Error{where + ": " + traits.name + " cannot aim at a target; ask for the least or the most of it"};
  if (goal.sense == Sense::kNear && (!(goal.target > 0) || !std::isfinite(goal.target)))
    return Error{where + ": a target of " + text(goal.target) + "; it must be above 0"};
  if (!(goal.weight > 0) || !std::isfinite(goal.weight))
    return Error{where + ": a weight of " + text(goal.weight) + "; it must be above 0"};
  return checkSets(scene, goal, quantity, where);
}

Result<Done> checkGlare(const Constraint& c, std::size_t observers, const std::string& where) {
  if (std::isfinite(c.lower)) return Error{where + ": nobody asks for glare; give \"max\" only"};
  if (observers == 0) return Error{where + ": nobody looks; give \"observers\""};
  if (c.observer != kNone && c.observer >= observers)
    return Error{where + ": observer number " + text(std::size_t{c.observer}) + " does not exist"};
  return Done{};
}

Result<Done> checkPlanes(const Scene& scene, const Constraint& c, const std::string& where) {
  if (c.surfaces.empty()) return Error{where + ": it is told of measuring planes only; name one"};
  constexpr double kLevel = 1e-6;
  const bool isVertical = c.statistic == Statistic::kVertical;
  if (isVertical && !(std::fabs(length(c.direction) - 1) < kLevel))
    return Error{where + ": which way does the vertical plane face? Give \"direction\""};
  if (isVertical && !(std::fabs(c.direction.y) < kLevel))
    return Error{where + ": a vertical plane faces sideways; give a level \"direction\""};
  for (const std::uint32_t surface : c.surfaces) {
    const PlaneWish wish{surface, isVertical ? std::vector<Vec3>{c.direction} : std::vector<Vec3>{}};
    if (isToldBy(scene.planes, wish)) continue;
    if (auto ok = checkPlane(scene, surface); !ok) return Error{where + ": " + ok.error().message};
    if (!scene.lightOperator)
      return Error{where +
                   ": this room's file does not tell what light comes from where; make it again with fiatlux "
                   "precompute, without --no-exchange"};
  }
  return Done{};
}

Result<Done> checkGrid(const Scene& scene, const Constraint& c, Quantity quantity, const std::string& where) {
  if (c.statistic != Statistic::kMean && c.statistic != Statistic::kMinimum &&
      c.statistic != Statistic::kUniformity)
    return Error{where + ": a grid tells mean, minimum and uniformity only"};
  if (quantity == Quantity::kExitance)
    return Error{where + ": a grid tells light that falls on it; ask for illuminance"};
  if (c.surfaces.empty()) return Error{where + ": a grid is of floors and measuring planes; name one"};
  const auto hasGrid = [&](std::uint32_t surface) { return !gridPointsOf(scene, surface).empty(); };
  if (std::none_of(c.surfaces.begin(), c.surfaces.end(), hasGrid))
    return Error{where + ": \"" + scene.surfaces[c.surfaces[0]].name +
                 "\" has no point of an EN 12464-1 grid; name a floor, a measuring plane or a task area"};
  return Done{};
}

Result<Done> checkConstraint(const Scene& scene, const Constraint& c, Quantity quantity,
                             const std::string& where) {
  if (std::isnan(c.lower) || std::isnan(c.upper)) return Error{where + ": a bound is not a number"};
  if (!std::isfinite(c.lower) && !std::isfinite(c.upper))
    return Error{where + ": no bound; give \"min\", \"max\" or both"};
  if (c.lower > c.upper)
    return Error{where + ": the minimum " + text(c.lower) + " is above the maximum " + text(c.upper)};
  if (traitsOf(c.statistic).needsAlpha && (!(c.alpha >= 0) || !std::isfinite(c.alpha)))
    return Error{where + ": alpha is " + text(c.alpha) + "; it must be 0 or more"};
  if (auto ok = checkSets(scene, c, quantity, where); !ok) return ok;
  if (c.onGrid) return checkGrid(scene, c, quantity, where);
  if (!traitsOf(c.statistic).ofPlanes) return Done{};
  return checkPlanes(scene, c, where);
}

}  // namespace

Result<Done> checkRules(const Scene& scene, const LuminaireRules& rules) {
  if (scene.sites.empty()) return Error{"the scene has no sites, so no luminaire can hang; give it a mount"};
  if (auto ok = checkCount(rules); !ok) return ok;
  if (auto ok = checkFluxes(rules); !ok) return ok;
  if (auto ok = checkSites(scene, rules); !ok) return ok;
  if (auto ok = checkTypes(scene, rules); !ok) return ok;
  if (auto ok = checkDistance(scene, rules); !ok) return ok;
  return checkArrangement(scene, rules);
}

Result<Done> checkIntentions(const Scene& scene, const Intentions& intentions, Asking asking) {
  if (auto ok = checkRules(scene, intentions.luminaires); !ok) return ok;
  for (std::size_t g = 0; g < intentions.goals.size(); ++g) {
    const Goal& goal = intentions.goals[g];
    if (auto ok = checkGoal(scene, goal, quantityOf(intentions, goal), asking, "goal " + text(g + 1)); !ok)
      return ok;
  }
  for (std::size_t c = 0; c < intentions.constraints.size(); ++c) {
    const Constraint& constraint = intentions.constraints[c];
    const std::string where = "constraint " + text(c + 1) + " (" + statisticName(constraint.statistic) + ")";
    if (auto ok = checkConstraint(scene, constraint, quantityOf(intentions, constraint), where); !ok)
      return ok;
    if (constraint.statistic != Statistic::kUgr) continue;
    if (auto ok = checkGlare(constraint, intentions.observers.size(), where); !ok) return ok;
  }
  return Done{};
}

}  // namespace fiatlux
