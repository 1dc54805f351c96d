#include "core/transport/direct_part.h"

#include <utility>

#include "core/scene/luminaire.h"
#include "core/scene/zones.h"
#include "core/transport/direct_quadrature.h"

namespace fiatlux {

Result<Done> addDirect(Scene& scene) {
  if (scene.direct) return Done{};
  if (!scene.lightOperator)
    return Error{
        "this room's file does not tell direct light apart; make it again with fiatlux precompute, without "
        "--no-exchange"};
  const std::uint32_t rows = scene.patches.rows();
  const auto sites = static_cast<std::uint32_t>(scene.sites.size());
  DirectLight direct{{rows, sites, std::vector<float>(std::size_t{rows} * sites)}, {}};
  const DirectQuadrature quadrature(scene);
  for (std::uint32_t j = 0; j < sites; ++j)
    quadrature.lambertian(luminaireOf(scene.sites[j]), scene.lightOperator->visibility.column(j),
                          &direct.responses.illuminance[std::size_t{j} * rows]);
  direct.statistics = meanRows(scene.patches, firstZone(scene), direct.responses, Quantity::kDirect);
  for (const Zone& zone : scene.zones) direct.statistics.push_back(zoneMeans(scene, direct.responses, zone));
  scene.direct = std::move(direct);
  return Done{};
}

}  // namespace fiatlux
