// Pivoted Cholesky on the correlation matrix (C scaled to a unit diagonal): each step takes the site of the
// largest remaining variance, so that what is left is bounded for every site relative to its own sigma.
#include "core/scene/covariance_codec.h"

#include <algorithm>
#include <cmath>
#include <cstring>

#include "core/scene/section_codec.h"

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

constexpr double kUnit = 0x1p-20;  // of a packed correlation

/// Correlations by rows of the upper triangle, each predicted from its neighbours. `at(i, j)` yields the one
/// of row i, column j >= i - 1 that is already known.
class Triangle {
 public:
  explicit Triangle(std::uint32_t m) : above_(m), row_(m) {}
  void beginRow() { std::swap(above_, row_); }
  std::uint32_t predict(std::uint32_t i, std::uint32_t j) const {
    // note: left of the diagonal lies the mirror image of what is above it.
    const std::uint32_t left = j > i ? row_[j - 1] : j > 0 ? above_[j] : 0;
    return i > 0 ? left + above_[j] - (j > 0 ? above_[j - 1] : 0) : left;
  }
  void set(std::uint32_t j, std::uint32_t value) { row_[j] = value; }

 private:
  std::vector<std::uint32_t> above_, row_;  // modulo 2^32
};

std::uint32_t bitsOf(float value) {
  std::uint32_t bits;
  std::memcpy(&bits, &value, 4);
  return bits;
}

float floatOf(std::uint32_t bits) {
  float value;
  std::memcpy(&value, &bits, 4);
  return value;
}

/// The columns of a packed section: values, without the delta coding around them.
std::vector<std::uint32_t> pack(std::span<const double> c, std::uint32_t m) {
  std::vector<std::uint32_t> words;
  std::vector<double> scale(m);
  for (std::uint32_t i = 0; i < m; ++i) {
    words.push_back(bitsOf(static_cast<float>(std::sqrt(std::max(0.0, c[std::size_t{i} * m + i])))));
    scale[i] = floatOf(words.back());
  }
  Triangle triangle(m);
  for (std::uint32_t i = 0; i < m; ++i) {
    triangle.beginRow();
    for (std::uint32_t j = i; j < m; ++j) {
      const double both = scale[i] * scale[j];
      const double correlation = both > 0 ? std::clamp(c[std::size_t{i} * m + j] / both, -2.0, 2.0) : 0;
      const auto value = static_cast<std::uint32_t>(std::lround(correlation / kUnit));
      words.push_back(value - triangle.predict(i, j));
      triangle.set(j, value);
    }
  }
  return words;
}

std::string unpack(const std::vector<std::uint32_t>& words, std::uint32_t m, std::vector<double>& c) {
  std::vector<double> scale(m);
  for (std::uint32_t i = 0; i < m; ++i) {
    scale[i] = floatOf(words[i]);
    if (!(scale[i] >= 0 && scale[i] < 1e15)) return "it holds a value that is no number or out of range";
  }
  Triangle triangle(m);
  std::size_t next = m;
  for (std::uint32_t i = 0; i < m; ++i) {
    triangle.beginRow();
    for (std::uint32_t j = i; j < m; ++j) {
      const std::uint32_t value = words[next++] + triangle.predict(i, j);
      triangle.set(j, value);
      const double correlation = kUnit * static_cast<std::int32_t>(value);
      if (std::abs(correlation) > 2) return "it holds a correlation that is out of range";
      c[std::size_t{i} * m + j] = correlation * scale[i] * scale[j];
    }
  }
  return "";
}

}  // namespace

PlainSection encodeCovariance(std::string name, std::span<const double> covariance, std::uint32_t m,
                              double tolerance) {
  constexpr double kFloatRounding = 0x1p-23;  // of both factors of a product
  const std::vector<double> rows = factorize(covariance, m, tolerance, m / 4);
  const bool dark = std::all_of(covariance.begin(), covariance.end(), [](double v) { return v == 0; });
  if (!rows.empty() || dark) {
    const std::vector<float> l(rows.begin(), rows.end());
    return plainSection(std::move(name), ElementType::kFloat32, Encoding::kFactored,
                        static_cast<std::uint32_t>(l.size() / m), m, encodeFloatPlanes(l),
                        static_cast<float>(tolerance + kFloatRounding));
  }
  const std::vector<std::uint32_t> words = pack(covariance, m);
  return plainSection(std::move(name), ElementType::kUint32, Encoding::kPacked,
                      static_cast<std::uint32_t>(words.size()), 1, encodePlanes(words),
                      static_cast<float>(0.5 * kUnit + kFloatRounding));
}

std::string decodeCovariance(const SceneSection& section, std::span<const std::uint8_t> bytes,
                             std::uint32_t m, std::vector<double>& covariance) {
  const bool packed = section.encoding == Encoding::kPacked && section.type == ElementType::kUint32 &&
                      section.rows == m + std::uint64_t{m} * (m + 1) / 2 && section.columns == 1;
  const bool factored = section.encoding == Encoding::kFactored && section.type == ElementType::kFloat32 &&
                        section.columns == m && section.rows <= m;
  if (!packed && !factored) return "its shape is not that of the covariances of the sites";
  covariance.assign(std::size_t{m} * m, 0);
  if (packed) {
    const std::string fault = unpack(decodePlanes(bytes), m, covariance);
    if (!fault.empty()) return fault;
  } else {
    const std::vector<float> values = decodeFloatPlanes(bytes);
    for (float v : values)
      if (!(std::abs(v) < 1e15f)) return "it holds a value that is no number or out of range";
    for (std::uint32_t r = 0; r < section.rows; ++r) {
      const float* row = &values[std::size_t{r} * m];
      for (std::uint32_t i = 0; i < m; ++i)
        for (std::uint32_t j = i; j < m; ++j) covariance[std::size_t{i} * m + j] += double{row[i]} * row[j];
    }
  }
  for (std::uint32_t i = 0; i < m; ++i)
    for (std::uint32_t j = 0; j < i; ++j)
      covariance[std::size_t{i} * m + j] = covariance[std::size_t{j} * m + i];
  return "";
}

}  // namespace fiatlux
