// Where a luminaire may go next: candidates (sites, or ties of them) that are free under the rules and keep
// the counts within their ranges, near ones first; and gatherings, which throw some luminaires together.
#pragma once

#include <cassert>
#include <cstdint>
#include <vector>

#include "core/base/random.h"
#include "core/search/intentions.h"
#include "core/search/prepared_scene.h"
#include "core/search/type_counts.h"

namespace fiatlux {

/// Follows one layout: keeps how many luminaires stand in the way of each site.
class FreeSites {
 public:
  /// `slots`: how many candidates there are in a layout, nobody included; rules as for Vns.
  FreeSites(const PreparedScene& prepared, const LuminaireRules& rules, std::uint32_t slots);

  void load(const std::vector<std::uint32_t>& sites);
  void relocate(std::uint32_t from, std::uint32_t to);

  /// May the luminaire on `from` hang on `to`, the others staying?
  bool mayMove(std::uint32_t from, std::uint32_t to) const {
    return isFree(from, to) && keepsCount(from, to);
  }
  /// May two luminaires not be on a and b at once?
  bool conflict(std::uint32_t a, std::uint32_t b) const { return prepared_.conflict(a, b, minDistance_); }
  /// Are the counts allowed, those of the types too, when candidates `to` are there instead of `from`, one of
  /// each or two?
  bool keepsCount(std::uint32_t from, std::uint32_t to) const {
    if (counts_ && !isAllowed(total_ - prepared_.weight(from) + prepared_.weight(to))) return false;
    if (!types_.isAsked()) return true;
    const TypeCounts::Change change = changeOf(from, to);
    return types_.allow(&change, 1);
  }
  bool keepsCount(std::uint32_t fromA, std::uint32_t toA, std::uint32_t fromB, std::uint32_t toB) const {
    if (counts_ && !isAllowed(total_ - prepared_.weight(fromA) - prepared_.weight(fromB) +
                              prepared_.weight(toA) + prepared_.weight(toB)))
      return false;
    if (!types_.isAsked()) return true;
    const TypeCounts::Change changes[2] = {changeOf(fromA, toA), changeOf(fromB, toB)};
    return types_.allow(changes, 2);
  }
  /// Where a luminaire comes to when it takes the place of another in its own way: the candidate there, kNone
  /// where it does not fit.
  std::uint32_t exchanged(std::uint32_t luminaireOn, std::uint32_t there) const {
    if (prepared_.isTied() || !prepared_.isOfTypes()) return there;
    const std::uint32_t to = prepared_.inWayOf(luminaireOn, there);
    return to == kNone || excluded_[to] ? kNone : to;
  }
  /// Do these two then hang in no other's way? Of what has no body: yes, others hang where they hung.
  bool mayExchange(std::uint32_t fromA, std::uint32_t toA, std::uint32_t fromB, std::uint32_t toB) const {
    if (!prepared_.hasBodies()) return true;
    const auto isClear = [&](std::uint32_t to) {
      return blocked_[to] == (conflict(fromA, to) ? 1u : 0u) + (conflict(fromB, to) ? 1u : 0u);
    };
    return isClear(toA) && isClear(toB) && !conflict(toA, toB);
  }
  std::uint32_t candidateCount() const { return prepared_.candidateCount(); }
  bool isTied() const { return prepared_.isTied(); }
  /// Are they the sites of one type, each a tie of its own, and as many as luminaires?
  bool isOfOneType() const { return !counts_ && prepared_.isTied() && prepared_.isOfOneType(); }
  /// Is each candidate free for all luminaires or for none, whatever the others do?
  bool isSimple() const {
    return !counts_ && minDistance_ <= 0 && !types_.isAsked() && !prepared_.hasBodies();
  }
  /// Luminaires in the way of each candidate; more than there are where it is excluded.
  const std::vector<std::uint32_t>& inTheWay() const { return blocked_; }
  /// The most candidates that a place has.
  std::uint32_t waysPerPlace() const { return prepared_.waysPerPlace(); }
  /// Do candidates differ in weight, or layouts in their count?
  bool counts() const { return counts_; }
  /// Where they do: is this the one without luminaires?
  bool isNobody(std::uint32_t candidate) const { return counts_ && candidate == prepared_.nobody(); }

  /// Free sites for the luminaire on `from` among its `reach` nearest, nearest first; all of them for nobody.
  void nearMoves(std::uint32_t from, std::uint32_t reach, std::vector<std::uint32_t>& out) const;
  /// All free sites for the luminaire on `from`.
  void farMoves(std::uint32_t from, std::vector<std::uint32_t>& out) const;
  /// As nearMoves, but whatever it does to the counts; about `reach` of them, for nobody too.
  void anyNearMoves(std::uint32_t from, std::uint32_t reach, Random& random,
                    std::vector<std::uint32_t>& out) const;

  /// Some free sites for the luminaire on `from`, at most `count`, drawn with repetition: most of them among
  /// its `reach` nearest, a few anywhere.
  void drawMoves(std::uint32_t from, std::uint32_t reach, std::uint32_t count, Random& random,
                 std::vector<std::uint32_t>& out) const;

  /// `count` candidates, `from` itself first, then its `near` nearest (of several ways a place: as many drawn
  /// from so many places' worth) and random ones, free or not: mayMove tells.
  void around(std::uint32_t from, std::uint32_t near, std::uint32_t count, Random& random,
              std::vector<std::uint32_t>& out) const;

  /// Relocates `strength` random movable luminaires of `sites` (drawn with repetition) to the sites nearest
  /// to a random one, and follows. A luminaire that finds no free site stays.
  void gather(std::vector<std::uint32_t>& sites, std::uint32_t strength, Random& random);

  /// Relocates all movable luminaires of `sites`, which it follows, to the sites nearest to one, as far as
  /// there is room.
  void gatherAll(std::vector<std::uint32_t>& sites, std::uint32_t center);

  /// The luminaires that are not pinned, in order.
  const std::vector<std::uint32_t>& movable() const { return movable_; }
  /// One of them. Precondition: there is one.
  std::uint32_t randomMovable(Random& random) const {
    assert(!movable_.empty());
    return movable_[random.below(static_cast<std::uint32_t>(movable_.size()))];
  }

 private:
  void block(std::uint32_t site, int change);
  const std::vector<std::uint32_t>& inTheWayOf(std::uint32_t site);
  bool isFree(std::uint32_t from, std::uint32_t to) const {
    if (counts_ && to == prepared_.nobody()) return from != to;
    return blocked_[to] == 0 || (blocked_[to] == 1 && conflict(from, to) && from != to);
  }
  TypeCounts::Change changeOf(std::uint32_t from, std::uint32_t to) const {
    return {prepared_.typeOf(from), prepared_.weight(from), prepared_.typeOf(to), prepared_.weight(to)};
  }
  bool isAllowed(std::uint32_t total) const { return total >= least_ && total <= most_; }

  const PreparedScene& prepared_;
  double minDistance_;
  bool counts_;
  TypeCounts types_;                        // of the layout that it follows
  std::uint32_t least_, most_, total_ = 0;  // luminaires: allowed, and of the layout that it follows
  std::vector<std::uint32_t> movable_;
  std::vector<char> excluded_;
  std::vector<std::vector<std::uint32_t>>
      inTheWay_;                        // of each site, once asked for; of halls, the latest only
  std::vector<std::uint32_t> blocked_;  // per site: luminaires in its way; excluded sites never reach 0 or 1
};

}  // namespace fiatlux
