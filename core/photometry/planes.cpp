#include "core/photometry/planes.h"

#include <cmath>

namespace fiatlux {

double foldedPlane(PhotometricSymmetry symmetry, double c) {
  if (symmetry == PhotometricSymmetry::kAxial) return 0;
  c -= 360 * std::floor(c / 360);
  switch (symmetry) {
    case PhotometricSymmetry::kQuadrant:
      if (c > 180) c = 360 - c;
      return c > 90 ? 180 - c : c;
    case PhotometricSymmetry::kC0C180:
      return c > 180 ? 360 - c : c;
    case PhotometricSymmetry::kC90C270:
      return c < 90 ? 180 - c : c > 270 ? 540 - c : c;
    default:
      return c;
  }
}

void closeRound(Photometry& photometry) {
  if (photometry.symmetry != PhotometricSymmetry::kNone || photometry.c.back() >= 360) return;
  photometry.c.push_back(360);
  const std::size_t size = photometry.candela.size();
  photometry.candela.resize(size + photometry.gamma.size());
  for (std::size_t g = 0; g < photometry.gamma.size(); ++g)
    photometry.candela[size + g] = photometry.candela[g];
}

}  // namespace fiatlux
