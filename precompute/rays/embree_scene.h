// The only door to Embree, which is native alone.
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <span>

#include "core/base/result.h"
#include "precompute/rays/ray_tracer.h"

namespace fiatlux {

/// Immutable once built; the same face as TriangleTree.
class EmbreeScene {
 public:
  using Triangle = std::array<std::uint32_t, 3>;  // indices into the positions
  using Position = std::array<float, 3>;          // m, around the tracer's centre

  /// Errors: no memory, or triangles that Embree refuses.
  static Result<EmbreeScene> build(std::span<const Position> positions, std::span<const Triangle> triangles);
  EmbreeScene(EmbreeScene&&) noexcept;
  EmbreeScene& operator=(EmbreeScene&&) noexcept;
  ~EmbreeScene();

  void intersect(const RayPacket& rays, HitPacket& hits) const;
  void occluded(const RayPacket& rays, bool* blocked, bool coherent) const;

 private:
  struct Parts;
  explicit EmbreeScene(std::unique_ptr<Parts> parts);
  std::unique_ptr<Parts> parts_;
};

}  // namespace fiatlux
