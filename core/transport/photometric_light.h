// Light of a luminaire of any photometry on a site, without rays: visible share x mean over the patch of
// I cos / d^2, balanced so that no light is lost (shadow_balance.h), and all interreflections by the exchange
// of the scene. The responses that the file holds for a Lambertian square serve as control variate:
//   E_indirect = alpha E_lambert + S (phi - alpha phi_lambert),  alpha = <phi, phi_lambert> /
//   |phi_lambert|^2,
// of that site nearby whose light falls most like the luminaire's: a spot that leans lights what is below
// another site than its own. Where the file holds means over whole surfaces, reflected light gets these.
#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "core/scene/luminaire.h"
#include "core/scene/scene.h"
#include "core/transport/direct_quadrature.h"
#include "core/transport/exchange.h"
#include "core/transport/room_view.h"

namespace fiatlux {

/// One luminaire on one site.
struct PhotometricCandidate {
  std::uint32_t site = 0;
  Luminaire luminaire;  // photometric
  /// Where it is there, the luminaire's intensities are `scale` times those of the map: many times faster.
  std::shared_ptr<const IntensityMap> map = nullptr;
  float scale = 1;
};

/// The Lambertian square of 1 lm that a site's response knows, as a photometry.
Luminaire lambertianOn(const Site& site);

/// Where a luminaire hangs whose light leaves along `normal`: at the site, or so far before it that no corner
/// of its luminous area lies behind the mount.
Vec3 mountedPosition(const Site& site, const Vec3& normal, const Vec3& axis, double width, double height);

/// Refers to the scene, which must have a light operator and outlive it. Columns are column-major rows x
/// candidates, lx. What it finds out about a site it keeps for the next luminaire there: not for several
/// threads.
class PhotometricLight {
 public:
  explicit PhotometricLight(const Scene& scene);
  const ExchangeOperator& exchange() const { return exchange_; }
  /// Made when it is asked for first.
  std::shared_ptr<const SightLines> sightLines() const;

  /// Finds out about `count` more sites what total() will want to know; true when nothing is left. The
  /// scene's responses need not be there yet.
  bool prepare(std::uint32_t count) const;

  std::vector<float> direct(const std::vector<PhotometricCandidate>& candidates) const;
  /// Direct light and all interreflections, given what direct() said.
  std::vector<float> total(const std::vector<PhotometricCandidate>& candidates,
                           const std::vector<float>& direct) const;

 private:
  /// Of a site's Lambertian square, for 1 lm.
  struct Control {
    std::vector<float> direct, exchanged;  // rows: lx, and what it becomes by the exchange
    double squared = 0;                    // <phi_lambert, phi_lambert>
  };
  double fluxBeforeMount(const PhotometricCandidate& candidate) const;
  void makeControls(std::vector<std::uint32_t> sites) const;
  double product(const float* a, const float* b) const;
  std::vector<std::uint32_t> sitesAround(std::uint32_t site) const;
  std::uint32_t mostAlike(std::uint32_t site, const float* direct) const;
  void correct(std::uint32_t site, const float* direct, float* light) const;
  std::vector<double> reflectedMeans(const float* direct) const;
  void settleMeans(const float* direct, float* light) const;

  const Scene& scene_;
  ExchangeOperator exchange_;
  DirectQuadrature quadrature_;
  bool isClosed_;                          // light that leaves arrives
  std::vector<float> weight_;              // patches: of <phi, phi>
  std::vector<double> edge_;               // m, rows
  std::vector<double> counted_;            // m2, of what counts of the surfaces that the file knows means of
  mutable std::vector<Control> controls_;  // of each site, made when its light is asked for, or before
  mutable std::shared_ptr<const SightLines> sightLines_;
};

}  // namespace fiatlux
