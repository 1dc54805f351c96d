// Everything that luminaires of some types could do in a room: each type on each site, turned and aimed in
// every way that is allowed, as far as it fits there.
#pragma once

#include <vector>

#include "core/candidates/candidate_scene.h"

namespace fiatlux {

/// The ways in which luminaires of a type may hang.
struct TypeWays {
  std::vector<double> turns = {0};  // degrees about the site's normal, at least one
  std::vector<Vec3> aims;           // m; none: they shine along the site's normal
  double maxAimingAngle = 180;      // degrees from the site's normal to where they are aimed
};

/// Site by site, of each the types in their order; `ways` of each type. Left out is what is aimed too far
/// from the normal, what hangs over the edge of its mount (MountArea) and what something of the room crosses
/// (CandidateFit). Precondition: the room has a light operator.
std::vector<Candidate> candidatesOf(const Scene& room, const std::vector<CandidateType>& types,
                                    const std::vector<TypeWays>& ways);

/// How a candidate hangs on its site.
Mounting mountingOf(const Candidate& candidate);

}  // namespace fiatlux
