// What a place gets from a Lambertian area, or from a point, that nothing stands before.
#pragma once

#include "core/base/vec3.h"
#include "precompute/light/emission.h"
#include "precompute/rays/float8.h"
#include "precompute/rays/patch_sampler.h"

namespace fiatlux {

/// Whether a place gets any light of the source.
bool faces(const Emission& source, const Vec3& position, const Vec3& normal);

/// lx.
double openLight(const Emission& source, const Vec3& position, const Vec3& normal);

/// The same; of an area that is far away and all of it before the receiver, by Gauss's 2 x 2 points of it.
double openLightFar(const Emission& source, const Vec3& position, const Vec3& normal);

/// Relative light of eight square parts of an area; 0 from `count` on. `u` and `v` are their middles and
/// `edge` their edges, in those of the area. Exact nearby, by their middles further away.
Float8 lightOfParts(const Emission& source, const PatchPoint& receiver, Float8 u, Float8 v, double edge,
                    std::size_t count);

}  // namespace fiatlux
