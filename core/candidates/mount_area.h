// What the sites of a room tell of the surfaces that luminaires hang on: squares as large as a site, or as
// far as to the next one. A luminous area must lie on them, not hang over an edge.
#pragma once

#include <cstdint>
#include <vector>

#include "core/scene/luminaire.h"
#include "core/scene/scene.h"

namespace fiatlux {

/// The luminous area of a luminaire on a site, laid flat on the mount.
Body bodyOf(const Luminaire& luminaire, const Site& site);

/// Refers to the sites, which must outlive it.
class MountArea {
 public:
  explicit MountArea(const std::vector<Site>& sites);

  /// Whether the luminous area of a luminaire on a site, laid flat on the mount, stays on it: its corners and
  /// the middles of its edges do.
  bool holds(std::uint32_t site, const Luminaire& luminaire) const;

 private:
  bool isOn(std::uint32_t site, const Vec3& point) const;
  bool covers(std::uint32_t site, const Vec3& point) const;

  const std::vector<Site>& sites_;
  std::vector<double> reach_;  // m, half the edge of each site's square
};

}  // namespace fiatlux
