// What closes a part of a building: rectangles where its air goes on, and the panes of its windows, through
// which light would leave it.
#pragma once

#include <cstdint>
#include <vector>

#include "precompute/geometry/spaces.h"

namespace fiatlux {

class Lid {
 public:
  /// `air`: of the cubes of `spaces`, which is kept. Both must outlive it.
  Lid(const Spaces& spaces, const std::vector<std::uint8_t>& air);

  /// Takes a triangle of something transparent, turned into the place; false where it does not part it from
  /// what is left out.
  bool takePane(Vec3 a, Vec3 b, Vec3 c);
  /// As one mesh, "lid", that reflects most or nothing; where there is anything to close.
  void addTo(SourceScene& source, bool isWhite);

 private:
  struct Slice;
  bool isOpen(const Slice& slice, int u, int v) const;
  void close(const Slice& slice);
  void addRectangle(const Slice& slice, int left, int right, int low, int high);

  const Spaces& spaces_;
  const std::vector<std::uint8_t>& air_;
  std::vector<std::uint8_t> nearOther_;  // cubes beside air that is left out
  SourceMesh mesh_;
};

}  // namespace fiatlux
