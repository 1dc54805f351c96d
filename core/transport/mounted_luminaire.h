// A luminaire of a photometric file on a site: where it hangs, which way it points and is turned.
#pragma once

#include <memory>
#include <optional>

#include "core/photometry/photometry.h"
#include "core/scene/luminaire.h"
#include "core/scene/patches.h"
#include "core/transport/intensity_map.h"

namespace fiatlux {

/// How a luminaire hangs; as its site says where nothing is said.
struct Mounting {
  double turn = 0;                   // degrees about the site's normal, from its axis towards normal x axis
  std::optional<Vec3> aim;           // m, a point that gamma 0 goes through
  std::optional<Vec3> normal, axis;  // gamma 0 and C0 (or near it), instead of turn and aim
  double width = 0, height = 0;      // m, along C0 and C90; 0: the file's luminous area
};

/// A photometric file, prepared for many luminaires.
struct PhotometricType {
  LuminousArea luminous;
  PhotometricAxis longAxis = PhotometricAxis::kC0;
  double flux = 0;                          // lm, of the table
  double beam = 0;                          // rad, Luminaire::beam
  Intensity candela;                        // at that flux
  std::shared_ptr<const IntensityMap> map;  // of a sampled type: what `candela` looks up
};

/// Its intensities are those of the table.
PhotometricType exactType(std::shared_ptr<const Photometry> photometry);
/// Its intensities are looked up (intensity_map.h): several times faster, within a few thousandths of the
/// brightest.
PhotometricType sampledType(std::shared_ptr<const Photometry> photometry);

/// A luminaire of that type anywhere, emitting `flux` lm (0: what its table holds), width and height as in
/// Mounting.
Luminaire photometricLuminaire(const PhotometricType& type, double flux, double width, double height);

/// The same on a site; a tilted one hangs so far before its mount that none of its luminous area lies behind.
Luminaire mountedLuminaire(const PhotometricType& type, double flux, const Site& site,
                           const Mounting& mounting);

}  // namespace fiatlux
