#include "core/search/plane_values.h"

#include <algorithm>
#include <cassert>

namespace fiatlux {
namespace {

const PlaneLight& planeOf(const Scene& scene, std::uint32_t surface) {
  const auto plane = std::find_if(scene.planes.begin(), scene.planes.end(),
                                  [&](const PlaneLight& each) { return each.surface == surface; });
  assert(plane != scene.planes.end());
  return *plane;
}

const Responses& verticalOf(const PlaneLight& plane, const Vec3& direction) {
  const auto vertical =
      std::find_if(plane.verticals.begin(), plane.verticals.end(),
                   [&](const PlaneLight::Vertical& each) { return length(each.direction - direction) == 0; });
  assert(vertical != plane.verticals.end());
  return vertical->light;
}

/// light += flux x the column of a site.
void add(const Responses& responses, std::uint32_t site, double flux, std::vector<double>& light) {
  const float* column = responses.column(site);
  for (std::size_t p = 0; p < light.size(); ++p) light[p] += flux * column[p];
}

}  // namespace

std::vector<PlaneWish> planesAskedOf(const Intentions& intentions) {
  std::vector<PlaneWish> wishes;
  for (const Constraint& c : intentions.constraints) {
    if (!traitsOf(c.statistic).ofPlanes) continue;
    for (const std::uint32_t surface : c.surfaces) {
      auto wish = std::find_if(wishes.begin(), wishes.end(),
                               [&](const PlaneWish& each) { return each.surface == surface; });
      if (wish == wishes.end()) wish = wishes.insert(wish, {surface, {}});
      const bool isThere = std::any_of(wish->directions.begin(), wish->directions.end(),
                                       [&](const Vec3& each) { return length(each - c.direction) == 0; });
      if (c.statistic == Statistic::kVertical && !isThere) wish->directions.push_back(c.direction);
    }
  }
  return wishes;
}

std::vector<std::shared_ptr<const Responses>> lightAtPoints(PreparedScene& prepared,
                                                            const Constraint& constraint) {
  std::vector<std::shared_ptr<const Responses>> all;
  for (const std::uint32_t surface : constraint.surfaces) {
    if (constraint.onGrid) {
      all.push_back(prepared.sites().lightOnGrid(*constraint.quantity, surface));
      continue;
    }
    const PlaneLight& plane = planeOf(prepared.scene(), surface);
    const Responses& upright = constraint.statistic == Statistic::kVertical
                                   ? verticalOf(plane, constraint.direction)
                                   : plane.cylindrical;
    all.emplace_back(std::shared_ptr<const Responses>(), &upright);  // the scene's
  }
  return all;
}

double valueOf(const Constraint& constraint, const MeanAndLeast& points) {
  if (constraint.statistic == Statistic::kUniformity)
    return points.mean > 0 ? points.least / points.mean : 0;  // a dark surface is not called even
  return constraint.isLeast || constraint.statistic == Statistic::kMinimum ? points.least : points.mean;
}

std::vector<double> meanOfPoints(PreparedScene& prepared, const Constraint& constraint) {
  std::vector<double> mean(prepared.scene().sites.size());
  std::size_t points = 0;
  for (const std::shared_ptr<const Responses>& light : lightAtPoints(prepared, constraint)) {
    points += light->rows;
    for (std::uint32_t j = 0; j < light->sites; ++j)
      for (std::uint32_t p = 0; p < light->rows; ++p) mean[j] += light->column(j)[p];
  }
  for (double& value : mean) value /= static_cast<double>(points);
  return mean;
}

PlaneValues::PlaneValues(PreparedScene& prepared, const Constraint& constraint) {
  const std::vector<std::shared_ptr<const Responses>> asked = lightAtPoints(prepared, constraint);
  const bool isRatio = constraint.statistic == Statistic::kModelling;
  for (std::size_t i = 0; i < asked.size(); ++i) {
    const Responses* horizontal =
        isRatio ? &planeOf(prepared.scene(), constraint.surfaces[i]).horizontal : nullptr;
    planes_.push_back({asked[i], horizontal, {}, {}});
    points_ += asked[i]->rows;
  }
}

void PlaneValues::load(const std::uint32_t* sites, const double* flux, std::uint32_t count) {
  for (Plane& plane : planes_) {
    plane.light.assign(plane.asked->rows, 0.0);
    if (plane.horizontal) plane.on.assign(plane.horizontal->rows, 0.0);
    for (std::uint32_t i = 0; i < count; ++i) {
      add(*plane.asked, sites[i], flux[i], plane.light);
      if (plane.horizontal) add(*plane.horizontal, sites[i], flux[i], plane.on);
    }
  }
}

MeanAndLeast PlaneValues::changed(const FluxChange* changes, std::uint32_t count) {
  MeanAndLeast result{0, kUnbounded};
  for (const Plane& plane : planes_) {
    light_ = plane.light;
    on_ = plane.on;
    for (std::uint32_t c = 0; c < count; ++c) {
      add(*plane.asked, changes[c].site, changes[c].flux, light_);
      if (plane.horizontal) add(*plane.horizontal, changes[c].site, changes[c].flux, on_);
    }
    for (std::size_t p = 0; p < light_.size(); ++p) {
      const double value = plane.horizontal ? modellingOf(light_[p], on_[p]) : light_[p];
      result.mean += value / static_cast<double>(points_);
      if (!(value >= result.least)) result.least = value;
    }
  }
  return result;
}

MeanAndLeast planeValueUnder(PreparedScene& prepared, const Constraint& constraint, const Layout& layout) {
  std::vector<double> flux = layout.flux;
  for (double& lumens : flux) lumens *= layout.dimming;
  PlaneValues values(prepared, constraint);
  values.load(layout.sites.data(), flux.data(), static_cast<std::uint32_t>(flux.size()));
  return values.current();
}

}  // namespace fiatlux
