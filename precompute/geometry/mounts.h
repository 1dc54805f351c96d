// Where luminaires may hang: the mounts of a room, marked, named or proposed, and the sites on them.
#pragma once

#include <string>
#include <vector>

#include "precompute/geometry/free_space.h"
#include "precompute/geometry/outlook.h"
#include "precompute/geometry/room_options.h"
#include "precompute/geometry/surfaces.h"
#include "precompute/rays/ray_tracer.h"
#include "precompute/room/room.h"

namespace fiatlux {

struct Mount {
  std::string name;
  std::vector<Face> faces;
  double spacing = 0;       // m, 0 = not said
  double size = 0;          // m, side of a site's square; 0 = not said
  double drop = 0;          // m, from the mount to its sites
  bool isProposed = false;  // nobody has looked: sites only where there is free space below
  bool isIndoors = false;   // and no open sky above that
  double lift = 0;          // m, above its faces, which look up: a plane of sites where there is no ceiling
};

/// The names of the file that a person may ask for: nodes, and surfaces that extras name.
std::vector<std::string> askedNames(const SourceScene& source);

/// Throws the CommandError of an option that names nothing.
[[noreturn]] void unknownName(const char* option, const std::string& name,
                              const std::vector<std::string>& names);

/// Mounts marked in the file, then those of `options`; where sites are required and there is none, ceilings
/// are proposed, a mount a storey, with a remark; none where nothing is a ceiling. Throws CommandError where
/// a name is unknown.
std::vector<Mount> findMounts(const SourceScene& source, const WeldedMesh& mesh, const SurfaceTree& tree,
                              const std::vector<Face>& faces, const FreeSpace& space,
                              const RoomOptions& options, std::vector<std::string>& warnings);

/// A plane over the largest floor, options.ceiling high, or with a remark as high as is proposed. Throws
/// CommandError where there is no floor.
Mount planeMount(const WeldedMesh& mesh, const SurfaceTree& tree, const FreeSpace& space,
                 const RoomOptions& options, std::vector<std::string>& warnings);

/// The faces of mounts on which sites will hang; of lifted ones none.
std::vector<Face> facesWithSites(const WeldedMesh& mesh, const std::vector<Mount>& mounts);

/// Where light starts on planes of sites that are lifted off a floor.
std::vector<LightPlace> placesInTheOpen(const WeldedMesh& mesh, const std::vector<Mount>& mounts,
                                        const FreeSpace& space);

/// Hangs the sites of all mounts, as far below as they drop; those that something stands in the way of are
/// left out, with a warning. `tracer`: of the mesh; `space`: within it. Throws CommandError where there are
/// too many, or none though required.
void addSites(const WeldedMesh& mesh, const std::vector<Mount>& mounts, const RayTracer& tracer,
              const FreeSpace& space, const RoomOptions& options, Room& room);

}  // namespace fiatlux
