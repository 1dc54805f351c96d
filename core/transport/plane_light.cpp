#include "core/transport/plane_light.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

namespace fiatlux {
namespace {

/// The directions of a wish and those that are there already.
PlaneWish joined(const PlaneWish& wish, const std::vector<PlaneLight>& planes) {
  PlaneWish all = wish;
  for (const PlaneLight& plane : planes) {
    if (plane.surface != wish.surface) continue;
    for (const PlaneLight::Vertical& vertical : plane.verticals) {
      const bool isAsked = std::any_of(wish.directions.begin(), wish.directions.end(), [&](const Vec3& each) {
        return length(each - vertical.direction) == 0;
      });
      if (!isAsked) all.directions.push_back(vertical.direction);
    }
  }
  return all;
}

Responses empty(std::size_t points, std::size_t sites) {
  return {static_cast<std::uint32_t>(points), static_cast<std::uint32_t>(sites),
          std::vector<float>(points * sites)};
}

}  // namespace

std::vector<PlaneLight> planeLight(const Scene& room, const RoomView& view,
                                   const std::vector<PlaneWish>& wishes,
                                   const std::vector<Luminaire>& luminaires, const Responses& responses) {
  const std::size_t sites = responses.sites;
  std::vector<PlaneLight> planes;
  for (const PlaneWish& wish : wishes) {
    const std::vector<PlanePoint> points = pointsOnPlane(room, wish.surface);
    PlaneLight plane{wish.surface, empty(points.size(), sites), empty(points.size(), sites), {}};
    for (const Vec3& direction : wish.directions)
      plane.verticals.push_back({direction, empty(points.size(), sites)});
    for (std::size_t p = 0; p < points.size(); ++p) {
      const UprightRows rows = view.upright(points[p].position, wish.directions, luminaires, responses);
      for (std::uint32_t j = 0; j < sites; ++j) {
        const std::size_t at = j * points.size() + p;
        float horizontal = 0;
        for (const PatchShare& share : points[p].shares)
          horizontal += static_cast<float>(share.share) * responses.column(j)[share.row];
        plane.horizontal.illuminance[at] = horizontal;
        plane.cylindrical.illuminance[at] = rows.cylindrical[j];
        for (std::size_t d = 0; d < wish.directions.size(); ++d)
          plane.verticals[d].light.illuminance[at] = rows.vertical[d][j];
      }
    }
    planes.push_back(std::move(plane));
  }
  return planes;
}

Result<Done> checkLit(const Scene& scene, const std::vector<PlaneLight>& planes) {
  for (const PlaneLight& plane : planes) {
    const std::vector<float>& light = plane.horizontal.illuminance;
    if (std::none_of(light.begin(), light.end(), [](float lux) { return lux > 0; }))
      return Error{"no light reaches \"" + scene.surfaces[plane.surface].name +
                   "\" from any place, so nothing can be told of it; name another measuring plane"};
  }
  return Done{};
}

Result<Done> addPlanes(Scene& scene, const std::vector<PlaneWish>& wishes) {
  std::vector<PlaneWish> missing;
  for (const PlaneWish& wish : wishes)
    if (!isToldBy(scene.planes, wish)) missing.push_back(joined(wish, scene.planes));
  if (missing.empty()) return Done{};
  if (!scene.lightOperator)
    return Error{
        "this room's file does not tell what light comes from where, so nobody can say how faces are seen; "
        "make it again with fiatlux precompute, without --no-exchange"};
  std::vector<Luminaire> luminaires;
  for (const Site& site : scene.sites) luminaires.push_back(luminaireOf(site));
  std::vector<PlaneLight> made = planeLight(scene, RoomView(scene), missing, luminaires, scene.responses);
  if (Result<Done> lit = checkLit(scene, made); !lit) return lit;
  for (PlaneLight& plane : made) {
    const auto isOld = [&](const PlaneLight& each) { return each.surface == plane.surface; };
    scene.planes.erase(std::remove_if(scene.planes.begin(), scene.planes.end(), isOld), scene.planes.end());
    scene.planes.push_back(std::move(plane));
  }
  return Done{};
}

}  // namespace fiatlux
