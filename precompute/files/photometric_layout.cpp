#include "precompute/files/photometric_layout.h"

#include <algorithm>

#include "core/transport/candidate_fit.h"
#include "core/transport/photometric_light.h"
#include "core/transport/room_view.h"

namespace fiatlux {

bool hasPhotometry(const LayoutFile& file) {
  return std::any_of(file.luminaires.begin(), file.luminaires.end(),
                     [](const LayoutEntry& entry) { return entry.photometric.has_value(); });
}

Result<std::vector<float>> photometricIlluminance(const LayoutFile& file, const Layout& layout,
                                                  const Scene& scene, std::vector<std::string>& notes) {
  if (!scene.lightOperator)
    return Error{
        "the scene file knows Lambertian squares only; make it again with fiatlux precompute, without "
        "--no-exchange"};
  Layout squares;
  squares.dimming = layout.dimming;
  std::vector<PhotometricCandidate> candidates;
  const CandidateFit fit(scene);
  for (std::size_t i = 0; i < layout.sites.size(); ++i) {
    const std::uint32_t site = layout.sites[i];
    const auto& photometric = file.luminaires[i].photometric;
    if (photometric) {
      const PhotometricType type = exactType(photometric->photometry);
      candidates.push_back(
          {site, mountedLuminaire(type, photometric->flux, scene.sites[site], photometric->mounting)});
      if (!fit.fits(candidates.back().luminaire, type.luminous.height))
        notes.push_back("luminaires[" + std::to_string(i) + "]: it does not fit on site " +
                        std::to_string(site) +
                        ": something of the room crosses it; choose another site, or a smaller \"size\"");
    } else {
      squares.sites.push_back(site);
      squares.flux.push_back(layout.flux[i]);
    }
  }
  std::vector<float> light = illuminanceOf(scene, squares);
  const PhotometricLight operatorLight(scene);
  const std::vector<float> columns = operatorLight.total(candidates, operatorLight.direct(candidates));
  for (std::size_t i = 0; i < columns.size(); ++i)
    light[i % light.size()] += static_cast<float>(layout.dimming) * columns[i];
  return light;
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
  const Result<Done> checked = checkLuminousAreas(luminaires);
  if (!checked) return checked.error();
  return RoomView(scene).readings(observers, luminaires, layout.dimming, light);
}

}  // namespace fiatlux
