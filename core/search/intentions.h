// What a person asks of the light: goals and constraints on statistics of surfaces (paper
// sections 2.1, 3.1, 3.4), and the luminaires that may be used. Plain data; evaluation is in evaluator.h.
#pragma once

#include <algorithm>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "core/scene/patches.h"
#include "core/scene/scene.h"
#include "core/search/statistics.h"

namespace fiatlux {

enum class Sense : std::uint8_t { kMinimize, kMaximize, kNear };
inline constexpr const char* kSenseNames[] = {"min", "max", "near"};  // in intentions.json, by code

/// Part of the objective: weight x (signed value / value of the start layout), or weight x
/// distanceFrom(target, value) for kNear; summed over the goals and minimised.
struct Goal {
  Statistic statistic = Statistic::kSigma;  // one that may be a goal
  Sense sense = Sense::kMinimize;
  double weight = 1;
  SurfaceSet surfaces, over;              // as the statistic needs them
  double target = 0;                      // kNear only, > 0, in the unit of the statistic
  std::optional<Quantity> quantity = {};  // nothing: that of the intentions
};

/// lower <= statistic <= upper; either may be infinite. Violation: sum of excessOver (statistics.h).
struct Constraint {
  Statistic statistic = Statistic::kMean;
  double lower = -kUnbounded,
         upper = kUnbounded;  // in the unit of the quantity; a ratio for uniformity, contrast
  double alpha = 1;           // where the statistic needs it
  SurfaceSet surfaces, over;
  std::uint32_t observer = kNone;         // of a ugr: which one; kNone: whoever is worst off
  std::optional<Quantity> quantity = {};  // nothing: that of the intentions
  bool isLeast = false;                   // of points of planes: of the least of them, not of their mean
  Vec3 direction = {};                    // of a vertical: unit, level, that its plane faces
  bool onGrid = false;                    // mean, minimum, uniformity: at the points of EN 12464-1's grid
};

/// How the luminaires hang together (arrangements.h).
enum class Rule : std::uint8_t { kFree, kSymmetric, kRows, kField };
inline constexpr const char* kRuleNames[] = {"free", "symmetric", "rows", "field"};  // in intentions.json

/// A line in plan, along the room's x or z as far as the grid of sites follows them: the one that a layout is
/// mirrored about, or that rows run along. Found: the search takes the better one. Both: mirrored about two.
enum class PlanAxis : std::uint8_t { kFound, kX, kZ, kBoth };
inline constexpr const char* kPlanAxisNames[] = {"found", "x", "z", "both"};  // in intentions.json, by code

struct Arrangement {
  Rule rule = Rule::kFree;
  PlanAxis axis = PlanAxis::kFound;  // of symmetric layouts and rows; a field's, found: it may be anywhere
  std::uint32_t leastInRow = 3;      // of rows: fewer only where there are not so many in all
};

/// How many luminaires of one type there may be.
struct TypeRange {
  std::uint32_t least = 0, most = kNone;
  std::string name = {};  // of the type, for a person
};

/// The luminaires at the search's disposal.
struct LuminaireRules {
  std::uint32_t count = 6;                 // the least, where countHigh is above it
  std::uint32_t countHigh = 0;             // the most; 0: exactly `count`
  std::vector<double> flux = {1000};       // lm: one value for all, or one per luminaire
  double dimmingLow = 1, dimmingHigh = 1;  // range of the common factor t; equal = no dimming
  std::vector<std::uint32_t> pinned;       // site that luminaire i is kept on, kNone: it may move, as may all
                                           // beyond the end
  std::vector<std::uint32_t> excluded;     // sites that stay free
  double minDistance = 0;                  // m, between the centres of any two luminaires
  Arrangement arrangement;
  std::vector<TypeRange> types;       // of each type of the scene's hangings; none: any number of any
  std::vector<std::uint32_t> ofType;  // that luminaire i must be of, kNone: any, as for all beyond the end
};

/// The most luminaires that the rules allow.
inline std::uint32_t mostOf(const LuminaireRules& rules) { return std::max(rules.count, rules.countHigh); }

/// May layouts differ in their number of luminaires?
inline bool countVaries(const LuminaireRules& rules) { return rules.countHigh > rules.count; }

/// Are luminaires nearer to each other than the least distance? Places are known as 32-bit floats: to hang
/// just that far apart is far enough, whatever they round to.
inline bool isTooNear(double distance, double least) {
  constexpr double kRounding = 1e-4;
  return distance < (1 - kRounding) * least;
}

/// Is luminaire i kept on a site?
inline bool isPinned(const LuminaireRules& rules, std::uint32_t i) {
  return i < rules.pinned.size() && rules.pinned[i] != kNone;
}

/// Flux of luminaire i under the rules, lm.
inline double fluxOf(const LuminaireRules& rules, std::uint32_t i) {
  return rules.flux.size() == 1 ? rules.flux[0] : rules.flux[i];
}

/// Of each luminaire of a layout of `count`.
inline std::vector<double> fluxesOf(const LuminaireRules& rules, std::uint32_t count) {
  return rules.flux.size() == 1 ? std::vector<double>(count, rules.flux[0]) : rules.flux;
}

/// Of each luminaire of the smallest layout.
inline std::vector<double> fluxesOf(const LuminaireRules& rules) { return fluxesOf(rules, rules.count); }

struct Intentions {
  LuminaireRules luminaires;
  std::vector<Goal> goals;
  std::vector<Constraint> constraints;
  Quantity quantity = Quantity::kIlluminance;
  std::vector<Observer> observers;  // those of the scene that is searched (Scene::observers)
  std::vector<Zone> zones;          // likewise (Scene::zones)
};

/// Of which light a goal or a constraint of these intentions speaks.
template <class Intention>
Quantity quantityOf(const Intentions& intentions, const Intention& intention) {
  return intention.quantity.value_or(intentions.quantity);
}

/// Does any of them speak of direct light?
inline bool asksForDirect(const Intentions& intentions) {
  const auto isOfDirect = [](const auto& intention) { return intention.quantity == Quantity::kDirect; };
  return intentions.quantity == Quantity::kDirect ||
         std::any_of(intentions.goals.begin(), intentions.goals.end(), isOfDirect) ||
         std::any_of(intentions.constraints.begin(), intentions.constraints.end(), isOfDirect);
}

}  // namespace fiatlux
