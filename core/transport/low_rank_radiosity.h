// (I - R U V^T)^-1 by Sherman-Morrison-Woodbury: the paper's low-rank radiosity, equations (3) and (4).
#pragma once

#include <memory>
#include <vector>

#include "core/base/result.h"
#include "core/scene/patches.h"
#include "core/transport/form_factors.h"

namespace fiatlux {

/// Y = -R U (I - V^T R U)^-1, so that (I - R U V^T)^-1 = I - Y V^T. Holds the factorised k x k core; Y itself
/// (n x k) is only formed for the paper's formulation.
class LowRankRadiosity {
 public:
  /// Factorises I - V^T R U. `factors` must outlive the result and stay where it is. An error where it is
  /// singular (reflectances must be below 1).
  static Result<LowRankRadiosity> factorize(const FormFactors& factors, const Patches& patches);
  LowRankRadiosity(LowRankRadiosity&&) noexcept;
  LowRankRadiosity& operator=(LowRankRadiosity&&) noexcept;
  ~LowRankRadiosity();

  /// b = (I - Y V^T) e for `width` columns, both n x width row-major.
  void solve(const float* e, std::uint32_t width, float* b) const;
  /// The same, and F b (rows x width, as irradiance()) beside it: V^T b is known on the way, so that both
  /// need one product with U.
  void solve(const float* e, std::uint32_t width, float* b, float* gathered) const;
  /// (I - V^T R U)^-1, k x k row-major.
  std::vector<double> coreInverse() const;
  /// The n x k matrix Y, row-major.
  std::vector<float> y() const;

 private:
  struct Parts;
  std::vector<float> clusterMeans(const float* e, std::uint32_t width) const;
  void reflect(const float* e, std::uint32_t width, const float* gathered, float* b) const;
  explicit LowRankRadiosity(std::unique_ptr<Parts> parts);
  std::unique_ptr<Parts> parts_;
};

}  // namespace fiatlux
