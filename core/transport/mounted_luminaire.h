// A luminaire of a photometric file on a site: where it hangs, which way it points and is turned.
#pragma once

#include <memory>
#include <optional>

#include "core/photometry/photometry.h"
#include "core/scene/luminaire.h"
#include "core/scene/patches.h"

namespace fiatlux {

/// How a luminaire hangs; as its site says where nothing is said.
struct Mounting {
  double turn = 0;                   // degrees about the site's normal, from its axis towards normal x axis
  std::optional<Vec3> aim;           // m, a point that gamma 0 goes through
  std::optional<Vec3> normal, axis;  // gamma 0 and C0 (or near it), instead of turn and aim
  double width = 0, height = 0;      // m, along C0 and C90; 0: the file's luminous area
};

/// The luminaire of `photometry` anywhere, emitting `flux` lm (0: what its table holds), width and height as
/// in Mounting.
Luminaire photometricLuminaire(std::shared_ptr<const Photometry> photometry, double flux, double width,
                               double height);

/// The same on a site; a tilted one hangs so far before its mount that none of its luminous area lies behind.
Luminaire mountedLuminaire(std::shared_ptr<const Photometry> photometry, double flux, const Site& site,
                           const Mounting& mounting);

}  // namespace fiatlux
