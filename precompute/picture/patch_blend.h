// Which patches a point of the picture blends, so that light is smooth on a wall and sharp at its edges.
#pragma once

#include <array>
#include <cstdint>
#include <unordered_map>
#include <vector>

#include "precompute/room/room.h"

namespace fiatlux {

/// Up to four patches and their shares in 1/255, which sum to 255. Unused entries repeat a patch with share
/// 0.
struct PatchBlend {
  std::array<std::uint32_t, 4> patch{};
  std::array<std::uint8_t, 4> share{};
  bool operator==(const PatchBlend&) const = default;
};

/// Blends of a room's charts; the room must outlive it.
class PatchBlender {
 public:
  explicit PatchBlender(const Room& room);

  /// Bilinear among the 2 x 2 cells of the chart around a point (those that exist).
  PatchBlend inChart(std::uint32_t chart, const Vec3& point) const;

  /// At vertex v of the room, for a face of `chart` with unit `normal`: also with charts of the same surface
  /// whose faces meet there within 30 degrees, so that curved things are not faceted.
  PatchBlend atVertex(std::uint32_t v, std::uint32_t chart, const Vec3& normal) const;

 private:
  struct Corner {
    std::uint32_t chart;
    Vec3 normal;
  };
  const Room& room_;
  std::unordered_map<std::uint32_t, std::vector<Corner>>
      shared_;  // vertices where charts of one surface meet
};

}  // namespace fiatlux
