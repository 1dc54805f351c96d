// C_s = sum of w_p (g_p - a_s)^T (g_p - a_s): deviations first, products second, so that no digits cancel.
#include "core/transport/surface_statistics.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>

namespace fiatlux {
SurfaceStatistics surfaceStatistics(const float* values, const double* weights, std::uint32_t members,
                                    std::uint32_t columns) {
  using RowMatrix = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;
  using Rows = Eigen::Map<const Eigen::Matrix<float, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>>;
  const Rows rows(values, members, columns);
  double area = 0;
  for (std::uint32_t i = 0; i < members; ++i) area += weights[i];

  SurfaceStatistics result;
  result.mean.assign(columns, 0.0);
  Eigen::Map<Eigen::RowVectorXd> mean(result.mean.data(), columns);
  for (std::uint32_t i = 0; i < members; ++i) mean += weights[i] / area * rows.row(i).cast<double>();

  // Blocks of rows keep the doubles few; their order is fixed.
  RowMatrix covariance = RowMatrix::Zero(columns, columns);
  constexpr std::uint32_t kBlock = 512;
  RowMatrix deviations;
  for (std::uint32_t first = 0; first < members; first += kBlock) {
    const std::uint32_t count = std::min(kBlock, members - first);
    deviations = rows.middleRows(first, count).cast<double>();
    deviations.rowwise() -= mean;
    for (std::uint32_t i = 0; i < count; ++i) deviations.row(i) *= std::sqrt(weights[first + i] / area);
    covariance.selfadjointView<Eigen::Lower>().rankUpdate(deviations.transpose());
  }
  covariance.triangularView<Eigen::StrictlyUpper>() = covariance.transpose();
  result.covariance.assign(covariance.data(), covariance.data() + covariance.size());
  return result;
}

SurfaceStatistics responseStatistics(const Patches& patches, const Responses& responses, Quantity quantity,
                                     std::uint32_t surface) {
  std::vector<std::uint32_t> members;
  for (std::uint32_t p = 0; p < patches.rows(); ++p) {
    if (patches.surface[p] == surface && patches.counts(p)) members.push_back(p);
  }
  const bool exitance = quantity == Quantity::kExitance;
  if (members.empty() || (exitance && members[0] >= patches.count)) return {};
  std::vector<float> values(members.size() * responses.sites);
  std::vector<double> weights(members.size());
  for (std::size_t i = 0; i < members.size(); ++i) {
    const std::uint32_t p = members[i];
    weights[i] = patches.area[p];
    const float factor = exitance ? patches.reflectance[p] : 1.0f;
    for (std::uint32_t j = 0; j < responses.sites; ++j) {
      values[i * responses.sites + j] = factor * responses.column(j)[p];
    }
  }
  return surfaceStatistics(values.data(), weights.data(), static_cast<std::uint32_t>(members.size()),
                           responses.sites);
}

void setMeanRows(Quantity quantity, Scene& scene) {
  const auto rowsOf = [&](Quantity each) {
    return meanRows(scene.patches, scene.surfaces.size(), scene.responses, each);
  };
  scene.illuminance = rowsOf(Quantity::kIlluminance);
  if (quantity == Quantity::kExitance) scene.exitance = rowsOf(quantity);
}

}  // namespace fiatlux
