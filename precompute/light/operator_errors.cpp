#include "precompute/light/operator_errors.h"

#include <algorithm>
#include <cmath>

#include "core/transport/low_rank_radiosity.h"
#include "core/transport/photometric_light.h"
#include "core/transport/site_responses.h"

namespace fiatlux {
namespace {

constexpr std::uint32_t kSites = 6;          // evenly spread over the numbering
constexpr std::uint32_t kTrueRefine = 3;     // steps of the solution that counts as true
constexpr double kLit = 0.05;                // of the room's mean: surfaces dimmer than that are left out
constexpr std::uint32_t kManyPatches = 100;  // and smaller ones

struct Trial {
  const char* name;
  Intensity intensity;
  double beam, size;  // rad, m
};

/// A batwing, brightest at about 40 degrees, and a spot with half its intensity at 15 degrees.
std::vector<Trial> trials() {
  const auto batwing = [](const Vec3& d) {
    const double sine = 1 - d.z * d.z;
    return d.z > 0 ? d.z * (1 + 2 * sine) : 0.0;
  };
  const auto spot = [](const Vec3& d) { return d.z > 0 ? std::pow(d.z, 20) : 0.0; };
  return {{"batwing", batwing, 1.6, 0.6}, {"spot", spot, 0.5, 0.1}};
}

std::vector<PhotometricCandidate> candidatesOf(const Scene& scene, const Trial& trial) {
  const auto m = static_cast<std::uint32_t>(scene.sites.size());
  const std::uint32_t count = std::min(kSites, m);
  std::vector<PhotometricCandidate> candidates;
  for (std::uint32_t i = 0; i < count; ++i) {
    const std::uint32_t j = (2 * i + 1) * m / (2 * count);
    Luminaire luminaire = luminaireOf(scene.sites[j]);
    luminaire.distribution = Luminaire::Distribution::kPhotometric;
    luminaire.width = luminaire.height = trial.size;
    luminaire.intensity = trial.intensity;
    luminaire.beam = trial.beam;
    candidates.push_back({j, luminaire});
  }
  return candidates;
}

/// Column-major rows x columns: the whole solution for the direct light of some columns.
std::vector<float> wholeSolution(const Scene& scene, const FormFactors& factors,
                                 const LowRankRadiosity& lowRank, const std::vector<float>& direct) {
  const std::size_t rows = scene.patches.rows(), columns = direct.size() / rows;
  ResponseBlock block;
  block.width = static_cast<std::uint32_t>(columns);
  block.direct.resize(direct.size());
  for (std::size_t j = 0; j < columns; ++j)
    for (std::size_t p = 0; p < rows; ++p) block.direct[p * columns + j] = direct[j * rows + p];
  solveResponses(factors, scene.patches, lowRank, kTrueRefine, 0, block);
  std::vector<float> light(direct.size());
  for (std::size_t j = 0; j < columns; ++j)
    for (std::size_t p = 0; p < rows; ++p) light[j * rows + p] = block.irradiance[p * columns + j];
  return light;
}

/// Adds the errors of one column on every surface that counts.
void compare(const Scene& scene, const std::vector<float>& exact, const std::vector<float>& exchanged,
             std::vector<double>& means, std::vector<double>& sigmas) {
  const double least = kLit * explicitStatistics(scene, exact, {}).mean;
  for (std::uint32_t s = 0; s < scene.surfaces.size(); ++s) {
    if (scene.surfaces[s].patches < kManyPatches) continue;
    const ExplicitStatistics a = explicitStatistics(scene, exact, {s}),
                             b = explicitStatistics(scene, exchanged, {s});
    if (a.mean < least || !(a.sigma > 0)) continue;
    means.push_back(std::abs(b.mean - a.mean) / a.mean);
    sigmas.push_back(std::abs(b.sigma - a.sigma) / a.sigma);
  }
}

double medianOf(std::vector<double>& values) {
  if (values.empty()) return 0;
  std::sort(values.begin(), values.end());
  return values[values.size() / 2];
}

}  // namespace

Result<std::vector<OperatorError>> measureOperator(const Scene& scene, const FormFactors& factors) {
  const Result<LowRankRadiosity> lowRank = LowRankRadiosity::factorize(factors, scene.patches);
  if (!lowRank) return lowRank.error();
  const PhotometricLight light(scene);
  const std::size_t rows = scene.patches.rows();
  std::vector<OperatorError> errors;
  for (const Trial& trial : trials()) {
    const std::vector<PhotometricCandidate> candidates = candidatesOf(scene, trial);
    const std::vector<float> direct = light.direct(candidates), exchanged = light.total(candidates, direct);
    const std::vector<float> exact = wholeSolution(scene, factors, *lowRank, direct);
    std::vector<double> means, sigmas;
    for (std::size_t i = 0; i < candidates.size(); ++i) {
      const auto column = [&](const std::vector<float>& columns) {
        return std::vector<float>(columns.begin() + i * rows, columns.begin() + (i + 1) * rows);
      };
      compare(scene, column(exact), column(exchanged), means, sigmas);
    }
    OperatorError error{trial.name};
    error.meanMedian = medianOf(means), error.sigmaMedian = medianOf(sigmas);
    if (!means.empty()) error.meanWorst = means.back(), error.sigmaWorst = sigmas.back();
    errors.push_back(error);
  }
  return errors;
}

}  // namespace fiatlux
