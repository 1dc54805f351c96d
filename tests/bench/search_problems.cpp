// Eleven families; see search_problems.h.
#include "tests/bench/search_problems.h"

#include <algorithm>
#include <utility>
#include <vector>

#include "core/search/patch_extremes.h"
#include "core/search/start_layout.h"

namespace fiatlux {
namespace {

constexpr std::uint32_t kSamples = 1000;                    // random layouts that bounds are read from
constexpr std::uint32_t kLitSamples = 200;                  // the same where patches have to be lit
constexpr double kAimWeight = 10;                           // over the spread, as the page asks
constexpr double kFourFluxes[] = {1000, 1500, 2200, 3200};  // lm, by turns

Goal least(Statistic statistic, const SurfaceSet& surfaces, double weight = 1) {
  return {statistic, Sense::kMinimize, weight, surfaces, {}};
}

Goal most(Statistic statistic, const SurfaceSet& surfaces, double weight = 1) {
  return {statistic, Sense::kMaximize, weight, surfaces, {}};
}

double quantile(std::vector<double> values, double share) {
  const auto at = static_cast<std::ptrdiff_t>(share * static_cast<double>(values.size() - 1));
  std::nth_element(values.begin(), values.begin() + at, values.end());
  return values[static_cast<std::size_t>(at)];
}

/// Random layouts under the rules so far, and what statistics say of them.
class Samples {
 public:
  Samples(PreparedScene& prepared, const LuminaireRules& rules, std::uint32_t samples)
      : prepared_(prepared), flux_(fluxesOf(rules)) {
    Random random(rules.count);
    for (std::uint32_t s = 0; s < samples; ++s) layouts_.push_back(randomSites(prepared, rules, random));
  }

  std::vector<double> means(const SurfaceSet& surfaces) const {
    return each(surfaces, [](const Moments& moments) { return moments.mean; });
  }
  std::vector<double> sigmas(const SurfaceSet& surfaces) const {
    return each(surfaces, [](const Moments& moments) { return moments.sigma(); });
  }
  /// mu - sigma
  std::vector<double> guaranteed(const SurfaceSet& surfaces) const {
    return each(surfaces, [](const Moments& moments) { return moments.mean - moments.sigma(); });
  }
  std::vector<double> uniformities(const SurfaceSet& surfaces) const {
    PatchExtremes patches(prepared_.scene(), Quantity::kIlluminance, surfaces);
    std::vector<double> values = means(surfaces);
    for (std::size_t s = 0; s < layouts_.size(); ++s) {
      patches.load(layouts_[s].data(), flux_.data(), static_cast<std::uint32_t>(flux_.size()));
      values[s] = patches.current().minimumLow / values[s];
    }
    return values;
  }

 private:
  template <class Read>
  std::vector<double> each(const SurfaceSet& surfaces, Read read) const {
    const auto statistics = prepared_.statistics(Quantity::kIlluminance, surfaces);
    std::vector<double> values;
    for (const std::vector<std::uint32_t>& sites : layouts_)
      values.push_back(
          read(momentsOf(*statistics, sites.data(), flux_.data(), static_cast<std::uint32_t>(sites.size()))));
    return values;
  }

  PreparedScene& prepared_;
  std::vector<double> flux_;
  std::vector<std::vector<std::uint32_t>> layouts_;
};

/// mu - sigma of the focus above the median, and of what is left a tenth with the least sigma elsewhere.
void askGuarantee(Intentions& asked, const ProblemSurfaces& surfaces, const Samples& samples) {
  const std::vector<double> guaranteed = samples.guaranteed(surfaces.focus);
  const std::vector<double> sigmas = samples.sigmas(surfaces.other);
  const double floor = quantile(guaranteed, 0.5);
  std::vector<double> left;
  for (std::size_t s = 0; s < sigmas.size(); ++s)
    if (guaranteed[s] >= floor) left.push_back(sigmas[s]);
  asked.goals = {least(Statistic::kMean, surfaces.focus)};
  asked.constraints = {{Statistic::kChebyshev, floor, kUnbounded, 1, surfaces.focus, {}},
                       {Statistic::kSigma, -kUnbounded, quantile(left, 0.1), 1, surfaces.other, {}}};
}

/// Two pinned, a tenth of the sites excluded, none beside another.
void askApart(Intentions& asked, const ProblemSurfaces& surfaces, const PreparedScene& prepared) {
  LuminaireRules& rules = asked.luminaires;
  rules.minDistance = 1.2 * prepared.distance(0, prepared.nearSites(0)[0]);
  Random random(rules.count);
  rules.pinned = randomSites(prepared, rules, random);
  rules.pinned.resize(2);
  for (std::uint32_t site = 0; site < prepared.candidateCount(); ++site)
    if (site != rules.pinned[0] && site != rules.pinned[1] && random.below(10) == 0)
      rules.excluded.push_back(site);
  asked.goals = {least(Statistic::kSigma, surfaces.focus)};
}

}  // namespace

std::optional<Intentions> problemOf(PreparedScene& prepared, const ProblemSurfaces& surfaces,
                                    const std::string& family, std::uint32_t count) {
  const auto& [focus, other, third] = surfaces;
  Intentions asked;
  LuminaireRules& rules = asked.luminaires;
  rules.count = count;
  const auto samples = [&](std::uint32_t number = kSamples) { return Samples(prepared, rules, number); };
  if (family == "even") {
    asked.goals = {least(Statistic::kSigma, {})};
  } else if (family == "varied") {
    asked.goals = {most(Statistic::kSigma, {})};
  } else if (family == "band") {
    const double mean = quantile(samples().means(focus), 0.5);
    asked.goals = {least(Statistic::kSigma, focus)};
    asked.constraints = {{Statistic::kMean, 0.99 * mean, 1.01 * mean, 1, focus, {}}};
  } else if (family == "aimed") {
    Goal aim{Statistic::kMean, Sense::kNear, kAimWeight, focus, {}};
    aim.target = quantile(samples().means(focus), 0.5);
    asked.goals = {aim, least(Statistic::kSigma, focus)};
  } else if (family == "guarantee") {
    askGuarantee(asked, surfaces, samples());
  } else if (family == "bright") {
    asked.goals = {most(Statistic::kMean, focus)};
    asked.constraints = {
        {Statistic::kSigma, -kUnbounded, quantile(samples().sigmas(other), 0.02), 1, other, {}}};
  } else if (family == "dimmed") {
    rules.dimmingLow = 0.1;
    asked.goals = {least(Statistic::kSigma, focus)};
    asked.constraints = {
        {Statistic::kMean, quantile(samples().means(other), 0.75), kUnbounded, 1, other, {}}};
  } else if (family == "fluxes") {
    rules.flux.clear();
    for (std::uint32_t i = 0; i < count; ++i) rules.flux.push_back(kFourFluxes[i % 4]);
    asked.goals = {least(Statistic::kSigma, {})};
  } else if (family == "uniform") {
    asked.goals = {most(Statistic::kMean, focus)};
    asked.constraints = {{Statistic::kUniformity,
                          quantile(samples(kLitSamples).uniformities(focus), 0.9),
                          kUnbounded,
                          1,
                          focus,
                          {}}};
  } else if (family == "apart") {
    askApart(asked, surfaces, prepared);
  } else if (family == "weighted") {
    asked.goals = {least(Statistic::kSigma, focus), most(Statistic::kMean, other, 0.5),
                   least(Statistic::kMean, third, 0.3)};
  } else {
    return std::nullopt;
  }
  return asked;
}

}  // namespace fiatlux
