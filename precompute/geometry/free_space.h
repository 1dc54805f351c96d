// What lies before a plane: how far one sees from it, which floor is below it, and whether that floor lies
// under the open sky. By these a ceiling differs from the inside of a wall, of a slab or of a cabinet.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

#include "precompute/geometry/faces.h"
#include "precompute/rays/ray_sequence.h"
#include "precompute/rays/ray_tracer.h"

namespace fiatlux {

/// Looks into a welded mesh, whose triangles the `tracer` knows; both must outlive it. Deterministic.
class FreeSpace {
 public:
  /// `faces`: all sides that are surfaces, fronts and backs.
  FreeSpace(const WeldedMesh& mesh, const RayTracer& tracer, const std::vector<Face>& faces);

  struct View {
    std::vector<double> floors;  // m, straight down to a surface that faces up; ascending; a ray each
    std::vector<std::pair<std::uint32_t, bool>> floorSides;  // of those: triangle, and whether its back
    double path = 0;  // m, mean way of rays by the cosine; those that meet nothing count as 10 m
    double lost = 0;  // share of them that meet nothing, or a back that is no surface
    double sky = 0;   // share of the rays up from the floors, by the cosine, that meet nothing

    /// Share of the rays straight down that meet a floor between `low` and `high` metres beneath.
    double floorsWithin(double low, double high) const;
    /// m, down to the floor; 0 where there is none.
    double height() const { return floors.empty() ? 0 : floors[floors.size() / 2]; }
  };
  /// From points on faces, not all of which are without area; `seed` scrambles them.
  View from(const std::vector<Face>& faces, std::uint64_t seed) const;

  /// m, straight down from a point to a surface that faces up, if that is what is met first.
  std::optional<double> floorBelow(const Vec3& point) const;
  /// Whether a point lies within a body: to all four sides it sees backs that are no surfaces.
  bool isWithinBody(const Vec3& point) const;
  /// m, straight up from points on faces to what is there; ascending, infinite where that is nothing.
  std::vector<double> heightsAbove(const std::vector<Face>& faces) const;
  /// Share of the rays up from a point, by the cosine, that meet nothing.
  double skyAbove(const Vec3& point) const;

 private:
  /// What a ray meets first: its triangle or kNone, how far it is, and whether it is a surface.
  struct Met {
    std::uint32_t triangle = kNone;
    double distance = 0;  // m
    bool back = false, isSurface = false;
  };
  Met meet(const Vec3& origin, const Vec3& direction) const;
  std::optional<double> floorAt(const Met& met) const;

  const WeldedMesh& mesh_;
  const RayTracer& tracer_;
  const RaySequence sequence_;
  std::vector<std::array<bool, 2>> isSurface_;  // by triangle, front and back
};

}  // namespace fiatlux
