#include "precompute/files/photometric_layout.h"

#include <algorithm>
#include <numeric>

#include "core/transport/candidate_fit.h"
#include "core/transport/photometric_light.h"
#include "core/transport/plane_light.h"
#include "core/transport/room_view.h"

namespace fiatlux {

bool hasPhotometry(const LayoutFile& file) {
  return std::any_of(file.luminaires.begin(), file.luminaires.end(),
                     [](const LayoutEntry& entry) { return entry.photometric.has_value(); });
}

Result<std::vector<float>> photometricIlluminance(const LayoutFile& file, const Layout& layout,
                                                  const Scene& scene, std::vector<std::string>& notes) {
  if (!scene.lightOperator)
    return Error{file.directOnly
                     ? "the scene file does not tell direct light apart; make it again with fiatlux "
                       "precompute, without --no-exchange"
                     : "the scene file knows Lambertian squares only; make it again with fiatlux precompute, "
                       "without --no-exchange"};
  Layout squares;
  squares.dimming = layout.dimming;
  std::vector<PhotometricCandidate> candidates;
  std::vector<double> factors;
  const CandidateFit fit(scene);
  for (std::size_t i = 0; i < layout.sites.size(); ++i) {
    const std::uint32_t site = layout.sites[i];
    const auto& photometric = file.luminaires[i].photometric;
    if (photometric) {
      const PhotometricType type = exactType(photometric->photometry);
      candidates.push_back(
          {site, mountedLuminaire(type, photometric->flux, scene.sites[site], photometric->mounting)});
      factors.push_back(layout.dimming);
      if (!fit.fits(candidates.back().luminaire, type.luminous.height))
        notes.push_back("luminaires[" + std::to_string(i) + "]: it does not fit on site " +
                        std::to_string(site) +
                        ": something of the room crosses it; choose another site, or a smaller \"size\"");
    } else if (file.directOnly) {
      candidates.push_back({site, lambertianOn(scene.sites[site])});
      factors.push_back(layout.dimming * layout.flux[i]);
    } else {
      squares.sites.push_back(site);
      squares.flux.push_back(layout.flux[i]);
    }
  }
  std::vector<float> light = illuminanceOf(scene, squares);
  const PhotometricLight operatorLight(scene);
  std::vector<float> columns = operatorLight.direct(candidates);
  if (!file.directOnly) columns = operatorLight.total(candidates, columns);
  for (std::size_t i = 0; i < columns.size(); ++i)
    light[i % light.size()] += static_cast<float>(factors[i / light.size()]) * columns[i];
  return light;
}

namespace {

/// Each at its flux, before dimming.
std::vector<Luminaire> luminairesOf(const LayoutFile& file, const Layout& layout, const Scene& scene) {
  std::vector<Luminaire> luminaires;
  for (std::size_t i = 0; i < layout.sites.size(); ++i) {
    const Site& site = scene.sites[layout.sites[i]];
    const auto& photometric = file.luminaires[i].photometric;
    luminaires.push_back(luminaireOf(site));
    luminaires.back().flux = layout.flux[i];
    if (photometric)
      luminaires.back() = mountedLuminaire(exactType(photometric->photometry), photometric->flux, site,
                                           photometric->mounting);
  }
  return luminaires;
}

void dim(Luminaire& luminaire, double dimming) {
  luminaire.flux *= dimming;
  if (luminaire.intensity)
    luminaire.intensity = [whole = luminaire.intensity, dimming](const Vec3& way) {
      return dimming * whole(way);
    };
}

}  // namespace

Result<std::vector<PlaneReading>> planeReadings(const LayoutFile& file, const Layout& layout,
                                                const Scene& scene, const std::vector<float>& light) {
  if (!scene.lightOperator)
    return Error{
        "the scene file does not tell what light comes from where, so nobody can say how faces are seen; "
        "make "
        "it again with fiatlux precompute, without --no-exchange"};
  const Result<std::vector<PlaneWish>> wishes = planeWishes(file.planes, scene.surfaces);
  if (!wishes) return wishes.error();
  for (const PlaneWish& wish : *wishes)
    if (Result<Done> ok = checkPlane(scene, wish.surface); !ok) return Error{"planes: " + ok.error().message};
  // The light on the room's surfaces is that of all luminaires: it counts as the column of the first.
  std::vector<Luminaire> luminaires = luminairesOf(file, layout, scene);
  for (Luminaire& luminaire : luminaires) dim(luminaire, layout.dimming);
  const std::size_t count = luminaires.size();
  Responses responses{scene.patches.rows(), static_cast<std::uint32_t>(count), light};
  responses.illuminance.resize(std::size_t{responses.rows} * count);
  Layout all{std::vector<std::uint32_t>(count), std::vector<double>(count, 1), 1};
  std::iota(all.sites.begin(), all.sites.end(), 0u);
  return readPlanes(planeLight(scene, RoomView(scene), *wishes, luminaires, responses), all);
}

Result<std::vector<ObserverReading>> observerReadings(const LayoutFile& file, const Layout& layout,
                                                      const Scene& scene,
                                                      const std::vector<Observer>& observers,
                                                      const std::vector<float>& light) {
  if (!scene.lightOperator)
    return Error{
        "the scene file does not tell what stands in the way of sight, so nobody can say what glares; make "
        "it "
        "again with fiatlux precompute, without --no-exchange"};
  const std::vector<Luminaire> luminaires = luminairesOf(file, layout, scene);
  const Result<Done> checked = checkLuminousAreas(luminaires);
  if (!checked) return checked.error();
  return RoomView(scene).readings(observers, luminaires, layout.dimming, light);
}

}  // namespace fiatlux
