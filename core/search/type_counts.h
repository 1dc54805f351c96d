// How many luminaires of each type a layout has, held against the ranges that are asked for: the moves of a
// search keep within them, and a layout that is being filled keeps room for what must still come.
#pragma once

#include <cstdint>
#include <vector>

#include "core/scene/scene.h"
#include "core/search/intentions.h"

namespace fiatlux {

/// Types of a scene's hangings; 0 where its sites hold squares.
std::uint32_t typeCountOf(const Scene& scene);

/// The type that hangs on a site; 0 of a square.
inline std::uint32_t typeOf(const Scene& scene, std::uint32_t site) {
  return scene.hangings.empty() ? 0 : scene.hangings[site].type;
}

/// Of each of `types` types; what single luminaires must be of is in the least.
std::vector<TypeRange> rangesOf(const LuminaireRules& rules, std::uint32_t types);

class TypeCounts {
 public:
  TypeCounts(const Scene& scene, const LuminaireRules& rules);

  /// Does any range say more than the count itself? Else all is allowed and nothing is counted.
  bool isAsked() const { return !ranges_.empty(); }

  void clear() { counts_.assign(ranges_.size(), 0); }
  void add(std::uint32_t type, int luminaires) {
    if (isAsked()) counts_[type] += static_cast<std::uint32_t>(luminaires);
  }
  /// Is each within its range?
  bool areMet() const;

  /// Luminaires of one type in the place of those of another.
  struct Change {
    std::uint32_t fromType, from, toType, to;
  };
  /// Would they be, after some changes?
  bool allow(const Change* changes, std::uint32_t count) const;

  /// May a layout be `luminaires` of one type?
  bool allowAlone(std::uint32_t type, std::uint32_t luminaires) const;

  /// May `luminaires` of a type join where up to `left` more may follow?
  bool leaveRoom(std::uint32_t type, std::uint32_t luminaires, std::uint32_t left) const;

 private:
  std::vector<TypeRange> ranges_;
  std::vector<std::uint32_t> counts_;
};

}  // namespace fiatlux
