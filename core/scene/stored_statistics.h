// Mean rows and covariances of quantised responses: what writer and reader of a file both know, so that only
// the difference to the true ones need be stored. Quick rather than exact: single precision, one order of
// sums.
#pragma once

#include <cstdint>
#include <vector>

#include "core/scene/patches.h"
#include "core/scene/scene.h"

namespace fiatlux {

/// The rows of each surface that count in its statistics, ascending.
std::vector<std::vector<std::uint32_t>> rowsOfSurfaces(const Patches& patches, std::uint32_t surfaces);

/// Area-weighted statistics of `rows` (at least one) of the responses: paper (8) and (11), of illuminance or
/// of exitance (reflectance times that).
SurfaceStatistics storedStatistics(const Patches& patches, const Responses& responses, Quantity quantity,
                                   const std::vector<std::uint32_t>& rows);

/// The same, some rows at a time. Refers to patches and responses, which must outlive it.
class StatisticsInTurn {
 public:
  StatisticsInTurn(const Patches& patches, const Responses& responses, Quantity quantity,
                   std::vector<std::uint32_t> rows);

  /// Takes at least `count` more rows; true when all are taken.
  bool advance(std::size_t count);
  /// Precondition: advance() said true. Once only.
  SurfaceStatistics take();

 private:
  double factor(std::uint32_t row) const;
  void addChunk(std::size_t count);

  const Patches& patches_;
  const Responses& responses_;
  Quantity quantity_;
  std::vector<std::uint32_t> rows_;
  std::size_t taken_ = 0, stride_;  // rows; entries of a row of the products
  double area_ = 0;
  SurfaceStatistics statistics_;
  std::vector<float> deviations_;
  std::vector<double> products_;
};

}  // namespace fiatlux
