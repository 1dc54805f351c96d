// Evaluator::bestMove: every move of some luminaires at once. What a move adds to the worth is a sum of what
// leaving one candidate adds, what going to another does, and their product in the covariance: rows over all
// candidates, in floats side by side. Only + - * and comparisons: the same bits natively and as Wasm.
#include <cassert>

#include "core/search/evaluator.h"

namespace fiatlux {

/// What going to each candidate adds to `line`.
void Evaluator::addComing(const Slope& slope, std::vector<double>& line) const {
  const double flux = flux_[0], perMean = flux * slope.mean, perSum = 2 * flux * slope.variance,
               perSquare = flux * flux * slope.variance;
  const KernelStatistics& statistics = *objective_.sets()[slope.set].statistics;
  if (perMean != 0)
    for (std::size_t c = 0; c < line.size(); ++c) line[c] += perMean * statistics.mean[c];
  if (slope.variance == 0) return;
  const std::vector<double>& sums = sums_[slope.set]->row();
  for (std::size_t c = 0; c < line.size(); ++c)
    line[c] += perSum * sums[c] + perSquare * statistics.diagonal[c];
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

/// Rows of what moves add: of the slopes together, where no candidate is closed, and of each edge.
void Evaluator::readLines(const std::vector<float>& closed) {
  const std::size_t count = closed.size();
  look_.lines.resize((1 + look_.worth.edges.size()) * count);
  float* line = look_.lines.data();
  look_.line.assign(count, 0.0);
  for (const Slope& slope : look_.worth.slopes) addComing(slope, look_.line);
  for (std::size_t c = 0; c < count; ++c) line[c] = static_cast<float>(look_.line[c]) + closed[c];
  for (const auto& [slope, beyond] : look_.worth.edges) {
    look_.line.assign(count, beyond);
    addComing(slope, look_.line);
    line += count;
    for (std::size_t c = 0; c < count; ++c) line[c] = static_cast<float>(look_.line[c]);
  }
}

/// What moves of luminaire `i` to each of `count` candidates from `first` on add, to look_.worths.
void Evaluator::readWorths(std::uint32_t i, std::uint32_t first, std::uint32_t count) {
  const std::uint32_t from = sites_[i], all = prepared_.candidateCount();
  float* worths = look_.worths.data();
  const float* line = look_.lines.data() + first;
  const auto rowOf = [&](const Slope& slope) {
    return objective_.sets()[slope.set].statistics->covariance.data() + std::size_t{from} * all + first;
  };
  const auto factorOf = [&](const Slope& slope) {
    return static_cast<float>(-2 * flux_[0] * flux_[0] * slope.variance);
  };
  double left = 0;
  for (const Slope& slope : look_.worth.slopes) left += leaving(slope, from);
  startWorths(line, static_cast<float>(left), count, worths);
  for (const Slope& slope : look_.worth.slopes)
    if (slope.variance != 0) addProducts(rowOf(slope), factorOf(slope), count, worths);
  for (const auto& [slope, beyond] : look_.worth.edges) {
    line += all;
    const auto leftOfIt = static_cast<float>(leaving(slope, from));
    if (slope.variance == 0)
      addExcess(line, leftOfIt, count, worths);
    else
      addExcess(line, leftOfIt, rowOf(slope), factorOf(slope), count, worths);
  }
}

bool Evaluator::bestMove(const std::vector<std::uint32_t>& luminaires, const std::vector<float>& closed,
                         Move& best) {
  assert(mayLookAround());
  const std::uint32_t count = prepared_.candidateCount();
  objective_.linearize(moments_.data(), current_.dimming, surveyPrices(), look_.worth);
  readLines(closed);
  look_.worths.resize(count);
  look_.least.assign(count, kNoMove);
  for (const std::uint32_t i : luminaires) {
    readWorths(i, 0, count);
    keepLess(look_.worths.data(), count, look_.least.data());
  }
  const float least = leastOf(look_.least.data(), count);
  if (!(least < kNoMove / 2)) return false;
  best.site = placeOf(least, look_.least.data(), count);
  float leastThere = kNoMove;
  for (const std::uint32_t i : luminaires) {
    readWorths(i, best.site, 1);
    if (!(look_.worths[0] < leastThere)) continue;
    leastThere = look_.worths[0];
    best.luminaire = i;
  }
  return true;
}

}  // namespace fiatlux
