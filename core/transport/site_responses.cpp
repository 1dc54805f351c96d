// The low-rank inverse as a preconditioner of the radiosity system whose F holds slopes and near patches, too
// (form_factors.h): generalised conjugate residuals, every column by itself (Eisenstat, Elman and Schultz
// 1983). Narrow places, which clusters know badly, would hold plain refinement up for many steps.
#include "core/transport/site_responses.h"

#include <cassert>
#include <cmath>

namespace fiatlux {

namespace {

/// Sums of a column's products, patches weighted by their areas.
class ColumnSums {
 public:
  ColumnSums(const Patches& patches, std::uint32_t width) : patches_(patches), width_(width) {}

  /// One sum a column of a block, n x width each.
  std::vector<double> of(const std::vector<float>& a, const std::vector<float>& b) const {
    std::vector<double> sums(width_, 0.0);
    for (std::uint32_t p = 0; p < patches_.count; ++p) {
      const double area = patches_.area[p];
      const std::size_t row = std::size_t{p} * width_;
      for (std::uint32_t j = 0; j < width_; ++j) sums[j] += area * a[row + j] * b[row + j];
    }
    return sums;
  }

 private:
  const Patches& patches_;
  std::uint32_t width_;
};

/// One direction d of every column, with what it does: F d and (I - R F) d.
struct Direction {
  std::vector<float> correction, gathered, change;  // n, rows and n, x width
  std::vector<double> squares;                      // |change|^2 of each column
};

/// to += factor[j] x from, whole rows of `width`.
void addColumns(const std::vector<double>& factors, const std::vector<float>& from, std::vector<float>& to) {
  const std::size_t width = factors.size();
  const std::vector<float> factor(factors.begin(), factors.end());
  for (std::size_t row = 0; row < from.size(); row += width)
    for (std::size_t j = 0; j < width; ++j) to[row + j] += factor[j] * from[row + j];
}

/// sign x a / b of each column; 0 where there is nothing to divide by.
std::vector<double> ratios(double sign, const std::vector<double>& a, const std::vector<double>& b) {
  std::vector<double> quotients(a.size());
  for (std::size_t j = 0; j < a.size(); ++j) quotients[j] = b[j] > 0 ? sign * a[j] / b[j] : 0;
  return quotients;
}

/// (I - R F) b, given gathered = F b.
std::vector<float> systemOf(const Patches& patches, std::uint32_t width, const std::vector<float>& b,
                            const std::vector<float>& gathered) {
  std::vector<float> out(b.size());
  for (std::size_t at = 0; at < b.size(); ++at)
    out[at] = b[at] - patches.reflectance[at / width] * gathered[at];
  return out;
}

/// The light that is reflected and emitted at once: n x width.
std::vector<float> startOf(const Patches& patches, const ResponseBlock& block) {
  std::vector<float> e(std::size_t{patches.count} * block.width);
  for (std::size_t at = 0; at < e.size(); ++at)
    e[at] = patches.reflectance[at / block.width] * block.direct[at];
  for (std::size_t at = 0; at < block.emission.size(); ++at) e[at] += block.emission[at];
  return e;
}

/// Where the preconditioned residual points, conjugate to the directions taken before.
Direction nextDirection(const FormFactors& factors, const Patches& patches, const LowRankRadiosity& lowRank,
                        const ColumnSums& sums, const std::vector<float>& residual, std::uint32_t width,
                        const std::vector<Direction>& taken) {
  Direction next;
  next.correction.resize(residual.size());
  next.gathered.resize(std::size_t{patches.rows()} * width);
  lowRank.solve(residual.data(), width, next.correction.data(), next.gathered.data());
  next.change = systemOf(patches, width, next.correction, next.gathered);
  for (const Direction& before : taken) {
    const std::vector<double> along = ratios(-1, sums.of(next.change, before.change), before.squares);
    addColumns(along, before.correction, next.correction);
    addColumns(along, before.gathered, next.gathered);
    addColumns(along, before.change, next.change);
  }
  next.squares = sums.of(next.change, next.change);
  return next;
}

}  // namespace

void solveResponses(const FormFactors& factors, const Patches& patches, const LowRankRadiosity& lowRank,
                    std::uint32_t refine, double tolerance, ResponseBlock& block) {
  const std::uint32_t width = block.width;
  assert(block.direct.size() == std::size_t{patches.rows()} * width);
  assert(block.emission.empty() || block.emission.size() == std::size_t{patches.count} * width);
  const ColumnSums sums(patches, width);
  const std::vector<float> e = startOf(patches, block);
  const std::vector<double> scale = sums.of(e, e);

  std::vector<float>&b = block.radiosity, &gathered = block.irradiance;
  b.resize(e.size());
  gathered.resize(std::size_t{patches.rows()} * width);
  lowRank.solve(e.data(), width, b.data(), gathered.data());
  std::vector<float> residual = systemOf(patches, width, b, gathered);
  for (std::size_t at = 0; at < e.size(); ++at) residual[at] = e[at] - residual[at];

  std::vector<Direction> taken;
  block.residuals.clear();
  for (std::uint32_t step = 0;; ++step) {
    bool converged = true;
    for (const double square : ratios(1, sums.of(residual, residual), scale)) {
      block.residuals.push_back(std::sqrt(square));
      converged = converged && block.residuals.back() <= tolerance;
    }
    if (step == refine || converged) break;
    taken.push_back(nextDirection(factors, patches, lowRank, sums, residual, width, taken));
    const Direction& next = taken.back();
    const std::vector<double> left = sums.of(residual, next.change);
    addColumns(ratios(1, left, next.squares), next.correction, b);
    addColumns(ratios(1, left, next.squares), next.gathered, gathered);
    addColumns(ratios(-1, left, next.squares), next.change, residual);
  }
  for (std::size_t at = 0; at < gathered.size(); ++at) gathered[at] += block.direct[at];
}

}  // namespace fiatlux
