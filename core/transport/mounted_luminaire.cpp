#include "core/transport/mounted_luminaire.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/photometry/intensity.h"
#include "core/photometry/luminous_area.h"
#include "core/photometry/photometric_values.h"
#include "core/transport/intensity_map.h"
#include "core/transport/photometric_light.h"

namespace fiatlux {
namespace {

constexpr double kRadian = std::numbers::pi / 180;  // of a degree
constexpr double kNarrowest = 2;                    // degrees: beams below that are sampled as if they had it

/// `wish` turned into the plane of `normal`; any direction of the plane where the two are parallel.
Vec3 inPlane(const Vec3& wish, const Vec3& normal) {
  for (const Vec3& direction : {wish, Vec3{1, 0, 0}, Vec3{0, 0, 1}}) {
    const Vec3 flat = direction - dot(direction, normal) * normal;
    if (length(flat) > 1e-6) return normalized(flat);
  }
  return {0, 1, 0};
}

/// The table's light ends there, as a cosine of gamma; -2 where it goes all around.
double leastCosine(const Photometry& photometry) {
  std::size_t end = photometry.gamma.size();
  const auto isDark = [&](std::size_t gamma) {
    for (std::size_t plane = 0; plane < photometry.c.size(); ++plane)
      if (photometry.at(plane, gamma) != 0) return false;
    return true;
  };
  while (end > 0 && isDark(end - 1)) --end;
  const double last = photometry.gamma[std::min(end, photometry.gamma.size() - 1)];
  return last < 180 ? std::cos(kRadian * last) - 1e-9 : -2;
}

}  // namespace

PhotometricType exactType(std::shared_ptr<const Photometry> photometry) {
  PhotometricType type{
      photometry->luminous, photometry->longAxis, integratedFlux(*photometry), 0, {}, nullptr};
  type.beam = kRadian * std::max(openingAngle(*photometry, 0.5), kNarrowest);
  // Much of the sphere is dark, and an angle takes long to find.
  const double least = leastCosine(*photometry);
  type.candela = [table = std::move(photometry), least](const Vec3& direction) {
    return direction.z < least ? 0 : intensity(*table, direction);
  };
  return type;
}

PhotometricType sampledType(std::shared_ptr<const Photometry> photometry) {
  const PhotometricSymmetry symmetry = photometry->symmetry;
  PhotometricType type = exactType(std::move(photometry));
  const bool mirrored = symmetry == PhotometricSymmetry::kAxial || symmetry == PhotometricSymmetry::kQuadrant;
  const auto map = std::make_shared<const IntensityMap>(type.candela, mirrored);
  type.candela = [map](const Vec3& direction) { return map->at(direction); };
  type.map = map;
  return type;
}

Luminaire photometricLuminaire(const PhotometricType& type, double flux, double width, double height) {
  const LuminousArea& area = type.luminous;
  const bool lengthAlongC0 = type.longAxis == PhotometricAxis::kC0;
  Luminaire luminaire;
  luminaire.distribution = Luminaire::Distribution::kPhotometric;
  luminaire.width = width > 0 ? width : lengthAlongC0 ? area.length : area.width;
  luminaire.height = height > 0 ? height : lengthAlongC0 ? area.width : area.length;
  luminaire.flux = flux > 0 ? flux : type.flux;
  luminaire.beam = type.beam;
  const double scale = flux > 0 && type.flux > 0 ? flux / type.flux : 1;
  luminaire.intensity = [candela = type.candela, scale](const Vec3& direction) {
    return scale * candela(direction);
  };
  LuminousArea seen = area;
  (lengthAlongC0 ? seen.length : seen.width) = luminaire.width;
  (lengthAlongC0 ? seen.width : seen.length) = luminaire.height;
  luminaire.luminousArea = [seen, axis = type.longAxis](const Vec3& direction) {
    return projectedArea(seen, axis, direction);
  };
  return luminaire;
}

Luminaire mountedLuminaire(const PhotometricType& type, double flux, const Site& site,
                           const Mounting& mounting) {
  Luminaire luminaire = photometricLuminaire(type, flux, mounting.width, mounting.height);
  const double turn = kRadian * mounting.turn;
  const Vec3 turned = std::cos(turn) * site.axis + std::sin(turn) * cross(site.normal, site.axis);
  luminaire.normal = site.normal;
  if (mounting.aim && length(*mounting.aim - site.position) > 1e-6)
    luminaire.normal = normalized(*mounting.aim - site.position);
  if (mounting.normal) luminaire.normal = normalized(*mounting.normal);
  luminaire.axis = inPlane(mounting.axis.value_or(turned), luminaire.normal);
  luminaire.position =
      mountedPosition(site, luminaire.normal, luminaire.axis, luminaire.width, luminaire.height);
  return luminaire;
}

}  // namespace fiatlux
