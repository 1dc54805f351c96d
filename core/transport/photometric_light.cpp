#include "core/transport/photometric_light.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace fiatlux {
namespace {

constexpr double kNearField = 4;      // a part of a luminaire is that many times smaller than its distance
constexpr double kNearest = 0.15;     // of the distance of the centres: what touches is not infinitely near
constexpr double kBeamParts = 6;      // steps of a patch's quadrature within a beam
constexpr double kWidestStep = 0.25;  // rad, of a patch's quadrature whatever the beam
/// Of the exchanged light: responses that differ more from it do so because of direct light that its
/// quadrature missed, on patches beside a luminaire.
constexpr double kMostMissed = 0.3;
constexpr double kMostParts = 12;  // on a luminaire's edge, on a patch's edge

std::uint32_t partsFor(double size, double step) {
  return static_cast<std::uint32_t>(std::clamp(std::ceil(size / std::max(step, 1e-9)), 1.0, kMostParts));
}

}  // namespace

Luminaire lambertianOn(const Site& site) {
  Luminaire luminaire = luminaireOf(site);
  luminaire.distribution = Luminaire::Distribution::kPhotometric;
  luminaire.intensity = [](const Vec3& d) { return std::max(0.0, d.z) / std::numbers::pi; };
  return luminaire;
}

Vec3 mountedPosition(const Site& site, const Vec3& normal, const Vec3& axis, double width, double height) {
  const Vec3 across = cross(normal, axis);
  const double depth =
      0.5 * (width * std::abs(dot(axis, site.normal)) + height * std::abs(dot(across, site.normal)));
  return site.position + depth * site.normal;
}

PhotometricLight::PhotometricLight(const Scene& scene)
    : scene_(scene),
      exchange_(scene.patches, scene.lightOperator->groups, scene.lightOperator->exchange),
      tiles_(patchTiles(scene.patches, scene.lightOperator->charts)) {}

double PhotometricLight::directOn(std::uint32_t row, const Luminaire& luminaire) const {
  const PatchTile& tile = tiles_[row];
  const Vec3& normal = scene_.patches.normal[row];
  const Vec3 apart = scene_.patches.center[row] - luminaire.position;
  const double distance = length(apart);
  const double reach = 0.5 * (tile.lengthU + tile.lengthV + std::max(luminaire.width, luminaire.height));
  const double nearest = std::max(distance - reach, kNearest * distance);
  const double angle = std::min(luminaire.beam / kBeamParts, kWidestStep);
  const std::uint32_t nu = partsFor(tile.lengthU, angle * nearest),
                      nv = partsFor(tile.lengthV, angle * nearest);
  const std::uint32_t lu = partsFor(luminaire.width, nearest / kNearField),
                      lv = partsFor(luminaire.height, nearest / kNearField);
  const Vec3 across = cross(luminaire.normal, luminaire.axis);
  double sum = 0;
  for (std::uint32_t i = 0; i < nu * nv; ++i) {
    const Vec3 on =
        apart + ((i % nu + 0.5) / nu - 0.5) * tile.edgeU + ((i / nu + 0.5) / nv - 0.5) * tile.edgeV;
    for (std::uint32_t k = 0; k < lu * lv; ++k) {
      const Vec3 d = on - (((k % lu + 0.5) / lu - 0.5) * luminaire.width) * luminaire.axis -
                     (((k / lu + 0.5) / lv - 0.5) * luminaire.height) * across;
      const double incidence = -dot(d, normal), squared = dot(d, d);
      if (incidence <= 0) continue;
      const double inverse = 1 / std::sqrt(squared);
      const Vec3 local = inverse * Vec3{dot(d, luminaire.axis), dot(d, across), dot(d, luminaire.normal)};
      sum += luminaire.intensity(local) * incidence * inverse / squared;
    }
  }
  return sum / (nu * nv * lu * lv);
}

void PhotometricLight::directColumn(const PhotometricCandidate& candidate, float* column) const {
  const std::uint8_t* visible = scene_.lightOperator->visibility.column(candidate.site);
  for (std::uint32_t p = 0; p < scene_.patches.rows(); ++p) {
    const double share = SiteVisibility::shareOf(visible[p]);
    column[p] = share > 0 ? static_cast<float>(share * directOn(p, candidate.luminaire)) : 0;
  }
}

std::vector<float> PhotometricLight::direct(const std::vector<PhotometricCandidate>& candidates) const {
  const std::size_t rows = scene_.patches.rows();
  std::vector<float> light(rows * candidates.size());
  for (std::size_t i = 0; i < candidates.size(); ++i) directColumn(candidates[i], &light[i * rows]);
  return light;
}

double PhotometricLight::controlShare(const float* direct, const float* lambertian) const {
  const Patches& patches = scene_.patches;
  double both = 0, own = 0;
  for (std::uint32_t p = 0; p < patches.count; ++p) {
    const double weight = patches.area[p] * patches.reflectance[p] * patches.reflectance[p];
    both += weight * direct[p] * lambertian[p];
    own += weight * lambertian[p] * lambertian[p];
  }
  return own > 0 ? both / own : 0;
}

std::vector<float> PhotometricLight::total(const std::vector<PhotometricCandidate>& candidates,
                                           const std::vector<float>& direct) const {
  const std::size_t rows = scene_.patches.rows();
  std::vector<std::uint32_t> sites;
  for (const PhotometricCandidate& candidate : candidates) sites.push_back(candidate.site);
  std::sort(sites.begin(), sites.end());
  sites.erase(std::unique(sites.begin(), sites.end()), sites.end());
  std::vector<PhotometricCandidate> lambertians;
  for (const std::uint32_t site : sites) lambertians.push_back({site, lambertianOn(scene_.sites[site])});
  const std::vector<float> control = this->direct(lambertians);
  const std::vector<float> exchanged = exchange_.indirect(control, static_cast<std::uint32_t>(sites.size()));

  std::vector<float> light = exchange_.indirect(direct, static_cast<std::uint32_t>(candidates.size()));
  for (std::size_t i = 0; i < candidates.size(); ++i) {
    const std::size_t at = std::lower_bound(sites.begin(), sites.end(), candidates[i].site) - sites.begin();
    const float *lambertian = &control[at * rows], *smooth = &exchanged[at * rows];
    const float* response = scene_.responses.column(candidates[i].site);
    const double alpha = controlShare(&direct[i * rows], lambertian);
    for (std::size_t p = 0; p < rows; ++p) {
      float& lit = light[i * rows + p];
      const double own = std::max(0.0f, lit), theirs = std::max(0.0f, smooth[p]);
      const double missed = theirs > 0 ? (response[p] - lambertian[p]) / theirs - 1 : 0;
      const double trust = std::max(0.0, 1 - missed * missed / (kMostMissed * kMostMissed));
      lit = direct[i * rows + p] + static_cast<float>(own + trust * missed * std::min(alpha * theirs, own));
    }
  }
  return light;
}

}  // namespace fiatlux
