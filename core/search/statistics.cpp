// Units in words, and what each statistic says to the relaxation; see statistics.h.
#include "core/search/statistics.h"

namespace fiatlux {

const char* unitName(Statistic statistic, Quantity quantity) {
  switch (traitsOf(statistic).unit) {
    case Unit::kLight:
      return quantity == Quantity::kExitance ? "lm/m2" : "lx";
    case Unit::kLux:
      return "lx";
    case Unit::kFlux:
      return "lm";
    case Unit::kRatio:
    case Unit::kGlare:
      return "";
  }
  return "";
}

std::optional<RelaxedForm> relaxedSide(Statistic statistic, Side side, double bound, double alpha) {
  const bool lower = side == Side::kLower;
  const double sign = lower ? -1 : 1;
  RelaxedForm form;
  form.constant = -sign * bound;
  switch (statistic) {
    case Statistic::kMean:
      form.mean = sign;
      return form;
    case Statistic::kSigma:
      if (lower) return std::nullopt;  // not convex
      form.sigma = 1;
      return form;
    case Statistic::kPower:
      form.power = sign;
      return form;
    case Statistic::kChebyshev:
      form.mean = sign;
      form.sigma = alpha;
      return form;
    case Statistic::kMinimum:  // minimum <= mean <= maximum
      if (!lower) return std::nullopt;
      form.mean = sign;
      return form;
    case Statistic::kMaximum:
      if (lower) return std::nullopt;
      form.mean = sign;
      return form;
    case Statistic::kUniformity:
      return std::nullopt;  // mean and sigma say nothing of it
    case Statistic::kContrast:
      form.mean = sign;
      form.over = -sign * bound;
      form.constant = 0;
      return form;
    case Statistic::kUgr:
    case Statistic::kCylindrical:
    case Statistic::kModelling:
    case Statistic::kVertical:
      return std::nullopt;  // their rows are not those of surfaces
  }
  return std::nullopt;
}

std::optional<RelaxedForm> relaxedValue(Statistic statistic) {
  RelaxedForm form;
  switch (statistic) {
    case Statistic::kMean:
      form.mean = 1;
      return form;
    case Statistic::kSigma:
      form.sigma = 1;
      return form;
    case Statistic::kPower:
      form.power = 1;
      return form;
    default:
      return std::nullopt;  // a ratio, or not a goal
  }
}

}  // namespace fiatlux
