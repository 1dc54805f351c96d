// The colour that light takes from what it has met, for the picture. Luminous light E (lx) is known; with
// rho_k, the reflectance of a patch in channel k of linear RGB, and Delta_k = A (rho_k - rho), a channel has
//   E_k = E + D_k,   D_k = S Delta_k (E + D_k)
// (S of core/scene/light_operator.h; core/transport/repaint.h has the same equation). Under other paint,
// rho', E is the light of the repainted room: D_k = S (A (rho_k - rho') E + Delta_k D_k). D_k is found
// between groups: of what E makes each patch reflect more, in full; of what D_k makes it, by the mean over a
// surface.
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <vector>

#include "core/scene/scene.h"
#include "core/transport/group_interpolation.h"

namespace fiatlux {

class ColoredLight {
 public:
  /// `colors`: 3 x n, linear RGB of each patch, of which the hue is taken and the luminance left to the
  /// patch's reflectance. Refers to the scene, which must outlive it and has a light operator.
  ColoredLight(const Scene& scene, const std::vector<float>& colors)
      : ColoredLight(scene, colors, scene.patches.reflectance) {}
  /// Under other paint, for light of the painted room: `reflectance` of the patches.
  ColoredLight(const Scene& scene, const std::vector<float>& colors, const std::vector<float>& reflectance);
  ~ColoredLight();

  /// Whether every patch is grey: light keeps its colour then.
  bool isGrey() const { return grey_; }

  /// rows x 2: red and blue of the light on each row for white light of the luminaires, where luminance is 1;
  /// green is what then lacks: 0.2126 red + 0.7152 green + 0.0722 blue = 1. `illuminance`: rows, lx.
  std::vector<float> of(const std::vector<float>& illuminance) const;

 private:
  static constexpr int kChannels = 3;
  struct Regions;  // surfaces, and what a lumen more or less on one does to the mean of another

  void setChanges(const std::vector<float>& colors, const std::vector<float>& reflectance);

  const Scene& scene_;
  bool grey_ = true;
  std::array<std::vector<float>, kChannels> change_;  // n: rho_k - rho'
  std::array<std::vector<float>, kChannels> lumens_;  // groups: Delta_k, lumens more per lux
  GroupInterpolation interpolation_;
  std::unique_ptr<const Regions> regions_;
};

}  // namespace fiatlux
