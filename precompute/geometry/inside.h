// What of a model is the room: its reflectors, the surfaces that light can reach, and where luminaires hang.
// All that is known before there are patches.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "precompute/geometry/mounts.h"
#include "precompute/geometry/outside.h"
#include "precompute/geometry/surfaces.h"

namespace fiatlux {

/// The source's meshes by what they are to the light.
struct Roles {
  std::vector<std::uint32_t> reflectors, measures;
};

/// What lets light through is no reflector. Throws CommandError where options.measures names nothing.
Roles assignRoles(const SourceScene& source, const RoomOptions& options, std::vector<std::string>& warnings);

/// The reflectors on common vertices; refuses what is no room, and warns of what was dropped.
WeldedMesh weldReflectors(const SourceScene& source, const Roles& roles, std::vector<std::string>& warnings);

RayTracer tracerOf(const WeldedMesh& mesh);

/// One a triangle, in their order.
std::vector<Face> frontFaces(const WeldedMesh& mesh);

/// The room's surfaces without its outside, and where luminaires may hang.
struct Inside {
  SurfaceTree tree;
  UniqueNames names;  // those that are taken
  std::optional<FreeSpace> space;
  std::vector<Mount> mounts;
  Outside outside;
  bool turned = false;  // one-sided faces that looked outward
};

/// Finds surfaces and mounts; turns sheets that look outward, and where no ceiling looks into the room, faces
/// of any material; leaves out what no light can reach. `mesh` and `tracer`, of its triangles, must outlive
/// it.
Inside findInside(const SourceScene& source, const RoomOptions& options, const RayTracer& tracer,
                  WeldedMesh& mesh, std::vector<std::string>& warnings);

}  // namespace fiatlux
