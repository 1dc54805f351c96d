// The low-rank inverse as a preconditioner of the radiosity system whose F holds slopes and near patches, too
// (form_factors.h).
#include "core/transport/site_responses.h"

#include <cassert>
#include <cmath>

namespace fiatlux {

namespace {

/// residual = e - b + R F b, given gathered = F b; returns |residual| / |e| of each column, weighted by area.
std::vector<double> residualOf(const Patches& patches, std::uint32_t width, const std::vector<float>& e,
                               const std::vector<float>& b, const std::vector<float>& gathered,
                               std::vector<float>& residual) {
  std::vector<double> squares(width, 0.0), scale(width, 0.0);
  for (std::uint32_t p = 0; p < patches.count; ++p) {
    for (std::uint32_t j = 0; j < width; ++j) {
      const std::size_t at = std::size_t{p} * width + j;
      residual[at] = e[at] - b[at] + patches.reflectance[p] * gathered[at];
      squares[j] += patches.area[p] * double{residual[at]} * residual[at];
      scale[j] += patches.area[p] * double{e[at]} * e[at];
    }
  }
  for (std::uint32_t j = 0; j < width; ++j) squares[j] = scale[j] > 0 ? std::sqrt(squares[j] / scale[j]) : 0;
  return squares;
}

}  // namespace

void solveResponses(const FormFactors& factors, const Patches& patches, const LowRankRadiosity& lowRank,
                    std::uint32_t refine, double tolerance, ResponseBlock& block) {
  const std::uint32_t n = patches.count, width = block.width;
  const std::size_t size = std::size_t{n} * width;
  assert(block.direct.size() == std::size_t{patches.rows()} * width);
  assert(block.emission.empty() || block.emission.size() == size);
  std::vector<float> e(size);
  for (std::size_t at = 0; at < size; ++at) e[at] = patches.reflectance[at / width] * block.direct[at];
  for (std::size_t at = 0; at < block.emission.size(); ++at) e[at] += block.emission[at];

  std::vector<float>& b = block.radiosity;
  b.resize(size);
  lowRank.solve(e.data(), width, b.data());
  std::vector<float> residual(size), correction(size);
  std::vector<float>& gathered = block.irradiance;
  gathered.resize(std::size_t{patches.rows()} * width);
  block.residuals.clear();
  for (std::uint32_t step = 0;; ++step) {
    irradiance(factors, b.data(), width, gathered.data());
    const std::vector<double> norms = residualOf(patches, width, e, b, gathered, residual);
    block.residuals.insert(block.residuals.end(), norms.begin(), norms.end());
    bool converged = true;
    for (const double norm : norms) converged = converged && norm <= tolerance;
    if (step == refine || converged) break;
    lowRank.solve(residual.data(), width, correction.data());
    for (std::size_t at = 0; at < size; ++at) b[at] += correction[at];
  }
  for (std::size_t at = 0; at < gathered.size(); ++at) gathered[at] += block.direct[at];
}

}  // namespace fiatlux
