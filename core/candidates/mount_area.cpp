#include "core/candidates/mount_area.h"

#include <algorithm>
#include <cmath>

namespace fiatlux {
namespace {

constexpr double kOverhang = 0.02;  // m that an edge may hang over

}  // namespace

MountArea::MountArea(const std::vector<Site>& sites) : sites_(sites) {
  for (const Site& site : sites) {
    double pitch = 2 * site.size;
    for (const Site& other : sites)
      if (&other != &site) pitch = std::min(pitch, length(other.position - site.position));
    reach_.push_back(0.5 * std::max(site.size, sites.size() > 1 ? pitch : 0) + kOverhang);
  }
}

Body bodyOf(const Luminaire& luminaire, const Site& site) {
  // The axis laid flat; one that points away from the mount stands for any.
  const Vec3 flat = luminaire.axis - dot(luminaire.axis, site.normal) * site.normal;
  return {length(flat) > 1e-6 ? normalized(flat) : site.axis, luminaire.width / 2, luminaire.height / 2};
}

bool MountArea::holds(std::uint32_t site, const Luminaire& luminaire) const {
  const Site& at = sites_[site];
  const Body body = bodyOf(luminaire, at);
  const Vec3 across = cross(at.normal, body.along);
  for (const double u : {-1, 0, 1})
    for (const double v : {-1, 0, 1}) {
      const Vec3 point = at.position + (u * body.halfLength) * body.along + (v * body.halfBreadth) * across;
      if (!isOn(site, point)) return false;
    }
  return true;
}

bool MountArea::isOn(std::uint32_t site, const Vec3& point) const {
  if (covers(site, point)) return true;
  for (std::uint32_t other = 0; other < sites_.size(); ++other)
    if (covers(other, point)) return true;
  return false;
}

bool MountArea::covers(std::uint32_t site, const Vec3& point) const {
  const Site& at = sites_[site];
  const Vec3 off = point - at.position;
  const double away = dot(off, at.normal), along = dot(off, at.axis),
               across = dot(off, cross(at.normal, at.axis));
  return std::abs(away) < kOverhang && std::abs(along) <= reach_[site] && std::abs(across) <= reach_[site];
}

}  // namespace fiatlux
