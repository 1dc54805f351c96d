// Direct light of a luminaire on patches, without shadows: the mean over the patch of I cos / d^2, summed
// over parts of the luminaire no larger than a quarter of the distance, nor of the beam there, and parts of
// the patch within the beam.
#pragma once

#include <cstdint>
#include <vector>

#include "core/scene/luminaire.h"
#include "core/scene/scene.h"
#include "core/transport/intensity_map.h"
#include "core/transport/patch_tiles.h"

namespace fiatlux {

/// Refers to the scene, which must have a light operator and outlive it.
class DirectQuadrature {
 public:
  explicit DirectQuadrature(const Scene& scene);

  /// lx of every row, in double, by the luminaire's own intensities. `visible`: steps of SiteVisibility, of
  /// which each row gets its share; `column` has rows() entries.
  void exact(const Luminaire& luminaire, const std::uint8_t* visible, float* column) const;
  /// The same in float and, for what is very near, with fewer samples: for many luminaires. The intensities
  /// are `scale` times those of the map. `column` must be zeros.
  void looked(const Luminaire& luminaire, const IntensityMap& map, float scale, const std::uint8_t* visible,
              float* column) const;
  /// The same of a Lambertian square of 1 lm.
  void lambertian(const Luminaire& luminaire, const std::uint8_t* visible, float* column) const;

 private:
  /// Along the two edges of a patch and of the luminaire.
  struct Parts {
    std::uint32_t u = 1, v = 1, width = 1, height = 1;
  };
  Parts partsOf(std::uint32_t row, const Vec3& apart, const Luminaire& luminaire) const;
  double exactOn(std::uint32_t row, const Luminaire& luminaire) const;
  template <class Add>
  void pairUp(const PatchTile& tile, const Luminaire& luminaire, const Add& add) const;
  template <class Look>
  void inFloat(const Luminaire& luminaire, const Look& look, const std::uint8_t* visible,
               float* column) const;

  const Scene& scene_;
  std::vector<PatchTile> tiles_;  // rows
  /// Of a tile, m: its longer edge, and from its centre to its farthest corner at most.
  struct Size {
    double longer, reach;
  };
  std::vector<Size> sizes_;  // rows
};

}  // namespace fiatlux
