// The outside of a room: sides that look into the void. Sheets are turned so that their front looks into the
// room, and sides that no light can reach are left out before there are patches.
#pragma once

#include <string>
#include <vector>

#include "precompute/geometry/free_space.h"
#include "precompute/geometry/outlook.h"
#include "precompute/geometry/surfaces.h"

namespace fiatlux {

/// Turns over the triangles of double-sided sheets whose front looks into the void while their back looks
/// into the room; `faces` (fronts first, one per triangle) and `outlook` follow. False where there were none.
bool turnOutwardSheets(WeldedMesh& mesh, std::vector<Face>& faces, Outlook& outlook);

/// Turns over the one-sided surfaces that look into the void while what they enclose looks at their backs:
/// all is to be found anew then. A closed body is turned as a whole or not at all. One line on them; "" where
/// there were none.
std::string turnWhatEncloses(const SourceScene& source, WeldedMesh& mesh, const SurfaceTree& tree,
                             const Outlook& outlook, const FreeSpace& space);

/// What was left out of a room.
struct Outside {
  std::vector<std::string> names;             // of the surfaces that are gone, or partly gone
  std::vector<std::uint32_t> nameOfTriangle;  // of its front, where that was left out; else kNone
  std::string note;                           // one line; "" where next to nothing was left out
};

/// Takes the regions that face the void (by triangle, front and back) out of the tree, and the leaves that
/// have no region left.
Outside leaveOut(const std::vector<std::array<bool, 2>>& sides, SurfaceTree& tree);

/// One line about what stays in the room but is shut off from the light; "" where that is next to nothing.
std::string noteOfShutOff(const std::vector<std::array<bool, 2>>& sides, const SurfaceTree& tree);

}  // namespace fiatlux
