// A small memory of good layouts that differ, and what two of them give together: on one side of a line
// across the plan the child hangs as one parent does, on the other side as the other. Where parts of a room
// know little of each other, their good solutions come together so.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "core/base/random.h"
#include "core/search/free_sites.h"
#include "core/search/objective.h"

namespace fiatlux {

class LayoutMemory {
 public:
  /// `flux`: of each luminaire, lm.
  LayoutMemory(const PreparedScene& prepared, std::vector<double> flux);

  /// Keeps a layout unless it is there already. Where `room` layouts are, the worst has to go, which may be
  /// this one. Returns whether it was kept.
  bool offer(const std::vector<std::uint32_t>& sites, const Evaluation& evaluation, std::size_t room);

  /// How many luminaires of this layout have no like one on their site in the kept one that has most of them
  /// (Hamming); 0 where one is kept that lights alike. Precondition: no two on one site.
  std::uint32_t distanceTo(const std::vector<std::uint32_t>& sites);

  /// Forgets all.
  void clear() { kept_.clear(); }

  /// Are there two to cross?
  bool hasParents() const { return kept_.size() > 1; }

  /// To `child` a layout from two of those kept, drawn at random as the line is. Luminaires for which there
  /// is no room under the rules stay where the first parent has them. `freeSites` follows it. Preconditions:
  /// hasParents(), two luminaires that may move, candidates of one weight.
  void cross(FreeSites& freeSites, Random& random, std::vector<std::uint32_t>& child);

 private:
  struct Kept {
    std::vector<std::uint32_t> sites;
    std::vector<std::uint32_t> key;  // equal for layouts that light alike
    Evaluation evaluation;
  };

  struct Placed {
    double key;
    std::uint32_t before, luminaire;

    bool operator<(const Placed& other) const {
      return key < other.key || (key == other.key && before < other.before);
    }
  };

  std::vector<std::uint32_t> keyOf(std::vector<std::uint32_t> sites) const;
  template <class Key>
  void orderBy(Key key, std::vector<std::uint32_t>& luminaires);
  static void takeElsewhere(const std::vector<std::uint32_t>& luminaires,
                            const std::vector<std::uint32_t>& sites, const std::vector<std::uint32_t>& others,
                            const std::vector<std::uint32_t>& otherSites, std::vector<std::uint32_t>& out);

  std::vector<double> flux_;
  bool isOneFlux_;
  std::vector<Kept> kept_;
  std::vector<Vec3> positions_;  // of each candidate: of its sites together
  std::vector<double> fluxOn_;   // scratch of distanceTo(): of each candidate, lm; 0 between two calls
  // Scratch of cross(): making them anew took longer than all else.
  std::vector<Placed> order_;
  std::vector<std::uint32_t> leaving_, coming_, movers_, targets_;
};

}  // namespace fiatlux
