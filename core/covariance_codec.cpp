// Pivoted Cholesky on the correlation matrix (C scaled to a unit diagonal): each step takes the site of the
// largest remaining variance, so that what is left is bounded for every site relative to its own sigma.
#include "core/covariance_codec.h"

#include <algorithm>
#include <cmath>

#include "core/section_codec.h"

namespace fiatlux {
namespace {

/// Rows of L (double, rank x m) with L^T L ~ C; stops when every residual variance is below tolerance x its
/// variance, or when `maxRank` rows are not enough (then empty).
std::vector<double> factorize(std::span<const double> c, std::uint32_t m, double tolerance,
                              std::uint32_t maxRank) {
  std::vector<double> scale(m), residual(m), rows;
  for (std::uint32_t i = 0; i < m; ++i) {
    scale[i] = std::sqrt(std::max(0.0, c[std::size_t{i} * m + i]));
    residual[i] = scale[i] > 0 ? 1 : 0;
  }
  for (std::uint32_t rank = 0;; ++rank) {
    const auto pivot =
        static_cast<std::uint32_t>(std::max_element(residual.begin(), residual.end()) - residual.begin());
    if (residual[pivot] <= tolerance) return rows;
    if (rank == maxRank) return {};
    rows.resize(rows.size() + m);
    double* row = &rows[std::size_t{rank} * m];
    const double inverse = 1 / (std::sqrt(residual[pivot]) * scale[pivot]);
    for (std::uint32_t j = 0; j < m; ++j) row[j] = c[std::size_t{pivot} * m + j];
    for (std::uint32_t r = 0; r < rank; ++r) {
      const double* earlier = &rows[std::size_t{r} * m];
      const double weight = earlier[pivot];
      for (std::uint32_t j = 0; j < m; ++j) row[j] -= weight * earlier[j];
    }
    for (std::uint32_t j = 0; j < m; ++j) {
      row[j] *= inverse;
      if (scale[j] > 0) residual[j] = std::max(0.0, residual[j] - (row[j] / scale[j]) * (row[j] / scale[j]));
    }
    residual[pivot] = 0;
  }
}

}  // namespace

PlainSection encodeCovariance(std::string name, std::span<const double> covariance, std::uint32_t m,
                              double tolerance) {
  constexpr double kFloatRounding = 0x1p-23;  // both of a product's factors, or one stored entry
  const std::vector<double> rows = factorize(covariance, m, tolerance, m / 2);
  const bool constant = std::all_of(covariance.begin(), covariance.end(), [](double v) { return v == 0; });
  if (!rows.empty() || constant) {
    const std::vector<float> l(rows.begin(), rows.end());
    return plainSection(std::move(name), ElementType::kFloat32, Encoding::kFactored,
                        static_cast<std::uint32_t>(l.size() / m), m, encodeFloatPlanes(l),
                        static_cast<float>(tolerance + kFloatRounding));
  }
  std::vector<float> packed;
  packed.reserve(std::size_t{m} * (m + 1) / 2);
  for (std::uint32_t i = 0; i < m; ++i)
    for (std::uint32_t j = i; j < m; ++j)
      packed.push_back(static_cast<float>(covariance[std::size_t{i} * m + j]));
  const auto count = static_cast<std::uint32_t>(packed.size());
  return plainSection(std::move(name), ElementType::kFloat32, Encoding::kPacked, count, 1,
                      encodeFloatPlanes(packed), static_cast<float>(kFloatRounding));
}

std::string decodeCovariance(const SceneSection& section, std::span<const std::uint8_t> bytes,
                             std::uint32_t m, std::vector<double>& covariance) {
  const bool packed = section.encoding == Encoding::kPacked;
  const bool fits =
      packed ? section.rows == std::uint64_t{m} * (m + 1) / 2 && section.columns == 1
             : section.encoding == Encoding::kFactored && section.columns == m && section.rows <= m;
  if (section.type != ElementType::kFloat32 || !fits)
    return "its shape is not that of the covariances of the sites";
  const std::vector<float> values = decodeFloatPlanes(bytes);
  for (float v : values)
    if (!std::isfinite(v)) return "it holds a value that is no number";
  covariance.assign(std::size_t{m} * m, 0);
  std::size_t next = 0;
  for (std::uint32_t i = 0; packed && i < m; ++i)
    for (std::uint32_t j = i; j < m; ++j) covariance[std::size_t{i} * m + j] = values[next++];
  for (std::uint32_t r = 0; !packed && r < section.rows; ++r) {
    const float* row = &values[std::size_t{r} * m];
    for (std::uint32_t i = 0; i < m; ++i)
      for (std::uint32_t j = i; j < m; ++j) covariance[std::size_t{i} * m + j] += double{row[i]} * row[j];
  }
  for (std::uint32_t i = 0; i < m; ++i)
    for (std::uint32_t j = 0; j < i; ++j)
      covariance[std::size_t{i} * m + j] = covariance[std::size_t{j} * m + i];
  return "";
}

}  // namespace fiatlux
