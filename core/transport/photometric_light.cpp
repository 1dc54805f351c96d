#include "core/transport/photometric_light.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/transport/column_block.h"
#include "core/transport/shadow_balance.h"

namespace fiatlux {
namespace {

/// Of the exchanged light: responses that differ more from it, on patches beside a luminaire, do so because
/// of direct light that its quadrature missed.
constexpr float kMostMissed = 0.3f;
constexpr double kBeside = 1.5;     // edges of the site and the patch together
constexpr double kNearby = 1.05;    // m: sites whose light may fall as a luminaire's does
constexpr double kMostSettled = 4;  // times: what the exchange misses by more, it has no shape of

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
      quadrature_(scene),
      isClosed_(fiatlux::isClosed(scene)),
      controls_(scene.sites.size()) {
  const Patches& patches = scene.patches;
  for (std::uint32_t p = 0; p < patches.count; ++p)
    weight_.push_back(static_cast<float>(patches.area[p] * patches.reflectance[p] * patches.reflectance[p]));
  for (const double area : patches.area) edge_.push_back(std::sqrt(area));
  counted_.resize(scene.lightOperator->surfaces.surfaces);
  for (std::uint32_t p = 0; p < patches.rows() && !counted_.empty(); ++p)
    if (patches.counts(p)) counted_[patches.surface[p]] += patches.area[p];
}

std::shared_ptr<const SightLines> PhotometricLight::sightLines() const {
  if (!sightLines_) sightLines_ = std::make_shared<const SightLines>(scene_);
  return sightLines_;
}

std::vector<float> PhotometricLight::direct(const std::vector<PhotometricCandidate>& candidates) const {
  const std::size_t rows = scene_.patches.rows();
  std::vector<float> light(rows * candidates.size());
  for (std::size_t i = 0; i < candidates.size(); ++i) {
    const auto& [site, luminaire, map, scale] = candidates[i];
    const std::uint8_t* visible = scene_.lightOperator->visibility.column(site);
    if (map)
      quadrature_.looked(luminaire, *map, scale, visible, &light[i * rows]);
    else
      quadrature_.exact(luminaire, visible, &light[i * rows]);
    if (isClosed_ && mostBalance(scene_.sites[site], luminaire) > 0)
      balanceShadows(scene_, scene_.sites[site], luminaire, fluxBeforeMount(candidates[i]), visible,
                     &light[i * rows]);
  }
  return light;
}

/// lm that leave a luminaire to the side of its mount that the site shines to.
double PhotometricLight::fluxBeforeMount(const PhotometricCandidate& candidate) const {
  const auto& [site, luminaire, map, scale] = candidate;
  const Vec3& normal = scene_.sites[site].normal;
  const Vec3 before{dot(normal, luminaire.axis), dot(normal, cross(luminaire.normal, luminaire.axis)),
                    dot(normal, luminaire.normal)};
  return map ? scale * map->flux(before) : IntensityMap(luminaire.intensity).flux(before);
}

/// <a, b> of the first reflected lumens of two columns of direct light.
double PhotometricLight::product(const float* a, const float* b) const {
  constexpr std::size_t kBlock = 256;
  double sum = 0;
  for (std::size_t first = 0; first < weight_.size(); first += kBlock) {
    float part = 0;
    for (std::size_t p = first; p < std::min(first + kBlock, weight_.size()); ++p)
      part += weight_[p] * a[p] * b[p];
    sum += part;
  }
  return sum;
}

/// Of those sites that have none yet.
void PhotometricLight::makeControls(std::vector<std::uint32_t> sites) const {
  const std::size_t rows = scene_.patches.rows();
  std::erase_if(sites, [&](std::uint32_t site) { return !controls_[site].direct.empty(); });
  std::sort(sites.begin(), sites.end());
  sites.erase(std::unique(sites.begin(), sites.end()), sites.end());
  std::vector<float> direct(rows * sites.size());
  for (std::size_t i = 0; i < sites.size(); ++i)
    quadrature_.lambertian(luminaireOf(scene_.sites[sites[i]]),
                           scene_.lightOperator->visibility.column(sites[i]), &direct[i * rows]);
  const std::vector<float> exchanged = exchange_.indirect(direct, static_cast<std::uint32_t>(sites.size()));
  for (std::size_t i = 0; i < sites.size(); ++i) {
    Control& control = controls_[sites[i]];
    control.direct.assign(&direct[i * rows], &direct[i * rows] + rows);
    control.exchanged.assign(&exchanged[i * rows], &exchanged[i * rows] + rows);
    control.squared = product(control.direct.data(), control.direct.data());
  }
}

bool PhotometricLight::prepare(std::uint32_t count) const {
  std::vector<std::uint32_t> sites;
  for (std::uint32_t site = 0; site < controls_.size() && sites.size() <= count; ++site)
    if (controls_[site].direct.empty()) sites.push_back(site);
  const bool isLast = sites.size() <= count;
  if (!isLast) sites.pop_back();
  makeControls(std::move(sites));
  return isLast;
}

std::vector<std::uint32_t> PhotometricLight::sitesAround(std::uint32_t site) const {
  std::vector<std::uint32_t> sites;
  for (std::uint32_t j = 0; j < scene_.sites.size(); ++j)
    if (length(scene_.sites[j].position - scene_.sites[site].position) <= kNearby) sites.push_back(j);
  return sites;
}

/// The site around whose light leaves the least of the luminaire's to the exchange.
std::uint32_t PhotometricLight::mostAlike(std::uint32_t site, const float* direct) const {
  std::uint32_t best = site;
  double most = 0;
  for (const std::uint32_t j : sitesAround(site)) {
    const Control& control = controls_[j];
    const double both = product(direct, control.direct.data());
    if (both > 0 && both * both > most * control.squared) best = j, most = both * both / control.squared;
  }
  return best;
}

/// Indirect light by the exchange becomes the whole light of a luminaire.
void PhotometricLight::correct(std::uint32_t at, const float* direct, float* light) const {
  const std::uint32_t site = mostAlike(at, direct);
  const Control& control = controls_[site];
  const float* response = scene_.responses.column(site);
  const float alpha = control.squared > 0
                          ? static_cast<float>(product(direct, control.direct.data()) / control.squared)
                          : 0.0f;
  constexpr float kPerMissed = 1 / (kMostMissed * kMostMissed);
  const auto& [position, normal, axis, size] = scene_.sites[site];
  const float *lambertian = control.direct.data(), *exchanged = control.exchanged.data();
  for (std::size_t p = 0; p < control.direct.size(); ++p) {
    const float own = std::max(0.0f, light[p]), theirs = std::max(0.0f, exchanged[p]);
    const float missed = theirs > 0 ? (response[p] - lambertian[p]) / theirs - 1 : 0.0f;
    const Vec3 apart = scene_.patches.center[p] - position;
    const double beside = kBeside * (size + edge_[p]);
    const bool isSure = lambertian[p] == 0 || dot(apart, apart) > beside * beside;
    const float trust = isSure ? 1.0f : std::max(0.0f, 1 - missed * missed * kPerMissed);
    light[p] = direct[p] + std::max(0.0f, own + trust * missed * std::min(alpha * theirs, own));
  }
}

/// lx over each surface, of what direct light becomes.
std::vector<double> PhotometricLight::reflectedMeans(const float* direct) const {
  const SurfaceExchange& exchange = scene_.lightOperator->surfaces;
  const Patches& patches = scene_.patches;
  constexpr std::uint32_t kBlock = 64;  // patches whose light is summed in float
  std::vector<double> means(exchange.surfaces);
  std::vector<float> some(exchange.surfaces);
  for (std::uint32_t first = 0; first < patches.count; first += kBlock) {
    std::fill(some.begin(), some.end(), 0.0f);
    for (std::uint32_t p = first; p < std::min(first + kBlock, patches.count); ++p)
      if (direct[p] != 0)
        addScaled(some.data(), static_cast<float>(patches.area[p] * patches.reflectance[p]) * direct[p],
                  &exchange.means[std::size_t{p} * exchange.surfaces], exchange.surfaces);
    for (std::uint32_t s = 0; s < exchange.surfaces; ++s) means[s] += some[s];
  }
  return means;
}

/// Gives reflected light the means over surfaces that the file knows.
void PhotometricLight::settleMeans(const float* direct, float* light) const {
  const Patches& patches = scene_.patches;
  const std::vector<double> wanted = reflectedMeans(direct);
  std::vector<double> sums(counted_.size());
  for (std::uint32_t p = 0; p < patches.rows(); ++p)
    if (patches.counts(p)) sums[patches.surface[p]] += patches.area[p] * (light[p] - direct[p]);
  std::vector<float> factor(counted_.size(), 1.0f);
  for (std::size_t s = 0; s < factor.size(); ++s)
    if (sums[s] > 0)
      factor[s] =
          static_cast<float>(std::clamp(wanted[s] * counted_[s] / sums[s], 1 / kMostSettled, kMostSettled));
  for (std::uint32_t p = 0; p < patches.rows(); ++p)
    light[p] = direct[p] + factor[patches.surface[p]] * (light[p] - direct[p]);
}

std::vector<float> PhotometricLight::total(const std::vector<PhotometricCandidate>& candidates,
                                           const std::vector<float>& direct) const {
  const std::size_t rows = scene_.patches.rows();
  std::vector<std::uint32_t> sites;
  for (const PhotometricCandidate& candidate : candidates)
    for (const std::uint32_t site : sitesAround(candidate.site)) sites.push_back(site);
  makeControls(std::move(sites));
  std::vector<float> light = exchange_.indirect(direct, static_cast<std::uint32_t>(candidates.size()));
  for (std::size_t i = 0; i < candidates.size(); ++i) {
    correct(candidates[i].site, &direct[i * rows], &light[i * rows]);
    if (!counted_.empty()) settleMeans(&direct[i * rows], &light[i * rows]);
  }
  return light;
}

}  // namespace fiatlux
