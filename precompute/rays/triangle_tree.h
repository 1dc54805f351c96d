// A ray tracer of our own: a tree of boxes with eight children a node (binned surface area heuristic) over
// triangles in blocks of eight, each tested at once. The same bits natively and as Wasm, where Embree is not.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "core/base/result.h"
#include "precompute/rays/float8.h"
#include "precompute/rays/ray_tracer.h"

namespace fiatlux {

/// Immutable once built. A ray along an edge that two triangles share meets at least one of them. Of
/// triangles at the same distance the first in their order is met.
class TriangleTree {
 public:
  using Triangle = std::array<std::uint32_t, 3>;  // indices into the positions
  using Position = std::array<float, 3>;          // m, around the tracer's centre

  /// Triangles without area are never met. No errors; throws std::bad_alloc.
  static Result<TriangleTree> build(std::span<const Position> positions, std::span<const Triangle> triangles);

  void intersect(const RayPacket& rays, HitPacket& hits) const;
  /// `coherent`: the rays go nearly the same way; then boxes are tested for all of them at once.
  void occluded(const RayPacket& rays, bool* blocked, bool coherent) const;

 private:
  static constexpr std::uint32_t kWidth = 8;

  /// Bounds and references of up to eight children; those that are not there hold nothing.
  struct alignas(64) Node {
    float bounds[6][kWidth];      // low x, y, z, high x, y, z
    std::uint32_t child[kWidth];  // a node, or kBlock and a block
  };
  /// Up to eight triangles; lanes that are not used have no area.
  struct alignas(64) Block {
    float corner[3][3][kWidth];  // corner, axis, lane
    std::uint32_t triangle[kWidth];
    std::uint32_t count;
  };
  static constexpr std::uint32_t kBlock = 1u << 31;  // marks a reference to a block

  class Builder;
  struct Ray;
  struct Hit;
  struct Beam;
  struct Open;
  static std::uint32_t push(unsigned lanes, const Node& node, Float8 enter, bool sorted, Open* stack,
                            std::uint32_t size);

  bool meetBlock(const Block& block, const Ray& ray, Hit& hit) const;
  template <bool kAny>
  void trace(const Ray& ray, std::uint32_t& first, Hit& hit) const;

  void traceBeam(const Beam& beam, unsigned& blocked) const;

  std::vector<Node> nodes_;  // the root first; empty without triangles
  std::vector<Block> blocks_;
};

}  // namespace fiatlux
