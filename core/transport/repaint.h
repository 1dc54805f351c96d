// The light of a room with other paint, from the light of the room as it was: with Delta = A (rho' - rho) on
// the repainted groups c,
//   g' = g + S_:c x,   (I - Delta_c S_cc) x = Delta_c g_c
// (S of core/scene/light_operator.h; x: lumens that the new paint reflects more). Whatever made the light,
// its direct part stays. Always from the reflectances of the scene file: no paint, and the light is what it
// was.
#pragma once

#include <memory>
#include <vector>

#include "core/scene/scene.h"
#include "core/transport/exchange.h"

namespace fiatlux {

/// Refers to scene and exchange (of that scene), which must outlive it.
class Repaint {
 public:
  /// `reflectance`: n, of the patches as they are to be, within [0, 0.95].
  Repaint(const Scene& scene, const ExchangeOperator& exchange, const std::vector<float>& reflectance);
  ~Repaint();

  /// lx, column-major rows x columns: `light` (with all interreflections) in the repainted room.
  std::vector<float> light(const std::vector<float>& light, std::uint32_t columns) const;

 private:
  struct Solver;  // of I - Delta_c S_cc

  const Scene& scene_;
  const ExchangeOperator& exchange_;
  std::vector<float> change_;          // n, rho' - rho
  std::vector<std::uint32_t> groups_;  // c, ascending
  std::unique_ptr<const Solver> solver_;
};

/// What lightening a surface does: lx of every row per unit of reflectance of all patches of `surface`, at
/// the paint of the scene file, for one column of light.
std::vector<float> lightPerReflectance(const Scene& scene, const ExchangeOperator& exchange,
                                       const std::vector<float>& light, std::uint32_t surface);

}  // namespace fiatlux
