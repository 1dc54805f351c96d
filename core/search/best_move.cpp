// Evaluator::bestMove: every move of some luminaires at once, to first order. What a move adds to the worth
// is a sum of what leaving one candidate adds, what going to another does, and their product in the
// covariance.
#include <cassert>

#include "core/search/evaluator.h"

namespace fiatlux {

/// Adds what going to each candidate adds.
void Evaluator::addComing(const Slope& slope, float* line) const {
  const double flux = flux_[0], perMean = flux * slope.mean, perSum = 2 * flux * slope.variance,
               perSquare = flux * flux * slope.variance;
  const KernelStatistics& statistics = *objective_.sets()[slope.set].statistics;
  const std::uint32_t count = prepared_.candidateCount();
  if (slope.variance != 0)
    addToLine({statistics.mean.data(), perMean}, {sums_[slope.set]->row().data(), perSum},
              {statistics.diagonal.data(), perSquare}, count, line);
  else if (perMean != 0)
    addToLine({statistics.mean.data(), perMean}, count, line);
}

/// What leaving a candidate adds.
double Evaluator::leaving(const Slope& slope, std::uint32_t from) const {
  const double flux = flux_[0];
  const KernelStatistics& statistics = *objective_.sets()[slope.set].statistics;
  double sum = -flux * slope.mean * statistics.mean[from];
  if (slope.variance != 0)
    sum += slope.variance * flux * (flux * statistics.diagonal[from] - 2 * sums_[slope.set]->row()[from]);
  return sum;
}

/// The product of leaving and going.
MoveProduct Evaluator::productOf(const Slope& slope) const {
  if (slope.variance == 0) return {};
  return {objective_.sets()[slope.set].statistics->covariance.data(),
          static_cast<float>(-2 * flux_[0] * flux_[0] * slope.variance)};
}

/// Rows of what going to candidates adds: of the slopes together, where no candidate is closed, and of each
/// edge.
void Evaluator::readLines(const std::vector<float>& closed) {
  const std::size_t count = closed.size();
  look_.lines.resize((1 + look_.worth.edges.size()) * count);
  look_.products.clear();
  look_.edges.clear();
  float* line = look_.lines.data();
  std::copy(closed.begin(), closed.end(), line);
  for (const Slope& slope : look_.worth.slopes) {
    addComing(slope, line);
    if (slope.variance != 0) look_.products.push_back(productOf(slope));
  }
  for (const auto& [slope, beyond] : look_.worth.edges) {
    line += count;
    std::fill_n(line, count, static_cast<float>(beyond));
    addComing(slope, line);
    look_.edges.push_back({line, productOf(slope)});
  }
}

/// What leaving adds, of each luminaire: by the slopes together, and by each edge.
void Evaluator::readLeaving(const std::vector<std::uint32_t>& luminaires) {
  look_.from.clear();
  look_.leaving.clear();
  for (const std::uint32_t i : luminaires) {
    const std::uint32_t from = sites_[i];
    double left = 0;
    for (const Slope& slope : look_.worth.slopes) left += leaving(slope, from);
    look_.from.push_back(from);
    look_.leaving.push_back(static_cast<float>(left));
    for (const LinearWorth::Edge& edge : look_.worth.edges)
      look_.leaving.push_back(static_cast<float>(leaving(edge.slope, from)));
  }
}

bool Evaluator::bestMove(const std::vector<std::uint32_t>& luminaires, const std::vector<float>& closed,
                         Move& best) {
  assert(mayLookAround());
  objective_.linearize(moments_.data(), current_.dimming, surveyPrices(), look_.worth);
  readLines(closed);
  readLeaving(luminaires);
  const RowMove least =
      leastMove({prepared_.candidateCount(), look_.lines.data(), look_.products, look_.edges}, look_.from,
                look_.leaving.data());
  if (!(least.worth < kNoMove / 2)) return false;
  best = {luminaires[least.luminaire], least.candidate};
  return true;
}

}  // namespace fiatlux
