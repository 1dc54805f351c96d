// The light of a room with other paint, from the light of the room as it was: with Delta = A (rho' - rho) on
// the repainted groups c,
//   g' = g + S_:c x,   (I - Delta_c S_cc) x = Delta_c g_c
// (S of core/scene/light_operator.h; x: lumens that the new paint reflects more). Whatever made the light,
// its direct part stays. Always from the reflectances of the scene file: no paint, and the light is what it
// was.
#pragma once

#include <memory>
#include <vector>

#include "core/base/result.h"
#include "core/scene/scene.h"
#include "core/transport/exchange.h"

namespace fiatlux {

/// All patches of a surface get one reflectance.
struct SurfacePaint {
  std::uint32_t surface = 0;
  double reflectance = 0;
  bool operator==(const SurfacePaint&) const = default;
};

/// What paint may reflect.
inline constexpr double kLeastPaint = 0.05, kMostPaint = 0.9;

/// An Error, one line, where the scene has no light operator, a surface is not there or only measures, or a
/// reflectance lies outside [kLeastPaint, kMostPaint].
Result<Done> checkPaint(const Scene& scene, const std::vector<SurfacePaint>& paint);

/// n, of the patches under paint; those of other surfaces keep what the scene file says. The latter of two
/// paints on one surface holds.
std::vector<float> paintedReflectance(const Scene& scene, const std::vector<SurfacePaint>& paint);

/// Refers to scene and exchange (of that scene), which must outlive it.
class Repaint {
 public:
  /// `reflectance`: n, of the patches as they are to be, within [0, 0.95].
  Repaint(const Scene& scene, const ExchangeOperator& exchange, const std::vector<float>& reflectance);
  ~Repaint();

  /// n, of the patches in the repainted room.
  const std::vector<float>& reflectance() const { return reflectance_; }
  /// Of the patches of a surface in the repainted room, by their areas.
  double meanReflectance(std::uint32_t surface) const;

  /// lx, column-major rows x columns: `light` (with all interreflections) in the repainted room.
  std::vector<float> light(const std::vector<float>& light, std::uint32_t columns) const;

 private:
  struct Solver;  // of I - Delta_c S_cc

  const Scene& scene_;
  const ExchangeOperator& exchange_;
  std::vector<float> reflectance_;     // n, rho'
  std::vector<float> change_;          // n, rho' - rho
  std::vector<std::uint32_t> groups_;  // c, ascending
  std::unique_ptr<const Solver> solver_;
};

/// What lightening surfaces does: lx of every row (column-major, a column a surface) per unit of reflectance
/// of all patches of each, at the paint of the scene file, for one column of light. Of a repainted room, for
/// its own light: Repaint::light of that.
std::vector<float> lightPerReflectance(const Scene& scene, const ExchangeOperator& exchange,
                                       const std::vector<float>& light,
                                       const std::vector<std::uint32_t>& surfaces);

}  // namespace fiatlux
