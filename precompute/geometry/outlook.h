// What the sides of a room's triangles see of each other, and which of them no light can reach: the outsides
// of a shell, the underside of what rests on a floor. Those look into the void and are no part of the room.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "precompute/geometry/charts.h"
#include "precompute/rays/area_sampler.h"
#include "precompute/rays/ray_sequence.h"
#include "precompute/rays/ray_tracer.h"

namespace fiatlux {

/// Where light starts or may start: into the half space of `normal`, or all around where that is zero.
struct LightPlace {
  Vec3 position, normal;  // m; unit or zero
};

/// Rays from every side of a welded mesh that takes part in the light. Sides are looked at in pieces, planes
/// or gently bent parts of one surface. Deterministic: the same mesh and pieces give the same answers.
class Outlook {
 public:
  /// `mesh` and the `tracer` of its triangles must outlive it; `pieces` are charts of any grid. Too many
  /// pieces (beyond 65 536) are not looked at: then nothing counts as lost or unlit.
  Outlook(const WeldedMesh& mesh, const RayTracer& tracer, const std::vector<ChartDraft>& pieces);

  /// Share of the rays from this side's piece that met nothing, or a side that is no surface.
  double lost(std::uint32_t triangle, bool back) const;

  /// How many rays of surfaces met this side of a triangle, which is none.
  std::uint32_t swallowed(std::uint32_t triangle, bool back) const { return swallowed_[triangle][back]; }
  bool isSurface(std::uint32_t triangle, bool back) const { return pieceOfSide_[triangle][back] != kNone; }

  /// To be told when a triangle of the mesh has been turned over.
  void turn(std::uint32_t triangle) { std::swap(pieceOfSide_[triangle][0], pieceOfSide_[triangle][1]); }

  /// Sides that no light reaches from `mounts` and `places`: at most 0.5 % of their rays meet anything lit.
  struct Unlit {
    /// By triangle, front and back: with the dark sides it sees it loses half of its rays: it faces the void.
    std::vector<std::array<bool, 2>> outside;
    /// The others: shut off from the light, a sealed room or the inside of a wall.
    std::vector<std::array<bool, 2>> shutOff;
  };
  /// None where there is no light at all.
  Unlit unlit(const std::vector<Face>& mounts, const std::vector<LightPlace>& places);

 private:
  struct Piece {
    AreaSampler sampler;
    std::uint32_t rays = 0, lost = 0;
    std::vector<std::uint32_t> met;  // the pieces that the other rays met
  };
  void cast(std::uint32_t piece, std::uint32_t rays, std::uint64_t seed);
  bool seesLight(std::uint32_t piece, const std::vector<LightPlace>& places, std::uint32_t rays) const;
  void spread(std::vector<bool>& lit) const;
  std::vector<bool> open(const std::vector<bool>& lit) const;

  const WeldedMesh& mesh_;
  const RayTracer& tracer_;
  const RaySequence sequence_;
  std::vector<Piece> pieces_;                              // none: not looked at
  std::vector<std::array<std::uint32_t, 2>> pieceOfSide_;  // kNone: no surface
  std::vector<std::array<std::uint32_t, 2>> swallowed_;    // rays, of those
};

}  // namespace fiatlux
