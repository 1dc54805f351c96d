// Steps of a tabu search (Glover 1989): of all moves of a few luminaires the best one, though it leads to a
// worse layout, but never back to where somebody has just left, nor of a luminaire that has just moved.
#pragma once

#include <cstdint>
#include <vector>

#include "core/search/neighborhood.h"

namespace fiatlux {

class Tabu {
 public:
  /// Can steps be taken so? Where moves may be surveyed, luminaires are alike, and a candidate is free for
  /// all of them or for none.
  static bool isPossible(const Surroundings& at);

  /// Forgets what has moved.
  void clear();

  /// Draws the luminaires of a step; its size says how many trials last as long.
  void open(const Surroundings& at, Scan& scan);
  /// Chooses the move.
  void choose(const Surroundings& at, Scan& scan);

 private:
  std::uint32_t step_ = 0;
  std::vector<std::uint32_t> siteUntil_, luminaireUntil_;  // the step until which each is tabu
  std::vector<std::uint32_t> luminaires_;                  // of the step
  std::vector<float> closed_;                              // of each candidate
};

}  // namespace fiatlux
