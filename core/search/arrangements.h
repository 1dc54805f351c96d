// Layouts that can be installed: luminaires that are tied together come and go as one, and a rule says which
// ties there are. With P the matrix of ties (sites x ties, ones), a tie has the column of its members' sum:
// a' = a P, C' = P^T C P, and a search over ties is a search over sites of another shape (prepared_scene.h).
// A regular field has so few layouts that they are all tried (field_scan.h).
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <vector>

#include "core/search/intentions.h"
#include "core/search/site_grid.h"
#include "core/search/type_counts.h"

namespace fiatlux {

/// Which ties these are: equal keys mean equal ties in one scene.
struct TieKey {
  Rule rule = Rule::kFree;
  PlanAxis axis = PlanAxis::kFound;     // that they are mirrored about, or run along
  std::uint32_t perTie = 1, pitch = 0;  // of rows: luminaires in each, and their distance in mm
  std::uint32_t type = kNone;           // whose ties alone; kNone = of all types

  bool operator==(const TieKey& other) const {
    return rule == other.rule && axis == other.axis && perTie == other.perTie && pitch == other.pitch &&
           type == other.type;
  }
};

/// One P: the sites of each tie, ascending. A tie weighs as many luminaires as it has members.
struct Ties {
  TieKey key;
  std::vector<std::vector<std::uint32_t>> members;
};

/// Every P that a rule allows, of which a layout uses one. Free: each site alone. Symmetric: the orbits of
/// the sites under the mirror that keeps most of them, about each axis asked for. Rows: for each axis, number
/// in a row (as many as are asked for at least) and pitch the rows that fit on the sites, of which a layout
/// has no two that run together. A field has none.
std::vector<Ties> tiesUnder(const SiteGrid& grid, const LuminaireRules& rules);

/// Where a row lies: a tie of Rule::kRows.
class RowSpan {
 public:
  RowSpan(const Scene& scene, const std::vector<std::uint32_t>& row);
  /// Does another row of the same P run into this one on one line, or come nearer than their pitch? Nobody
  /// would read them as rows: on a ceiling they are one line of uneven gaps.
  bool runsInto(const RowSpan& other) const;

 private:
  Vec3 origin_, along_;         // m; unit
  double begin_ = 0, end_ = 0;  // m along it from the origin
  double pitch_ = 0;            // m; 0 of a single luminaire, which runs into nothing
  Vec3 ends_[2];                // m
};

/// Those of `ties` whose luminaires are of one type, for each type of which a layout may consist alone; none
/// where the scene has one type only. A search among these finds what one among all is slow to find.
std::vector<Ties> tiesOfEachType(const Scene& scene, const Ties& ties, const LuminaireRules& rules);

/// Ties that make a layout, those that hold the pinned sites first.
struct TiedStart {
  std::vector<std::uint32_t> ties;
  std::uint32_t pinned = 0;  // so many of them hold a pinned site, and nothing else holds one
};

/// A layout of an allowed count that leaves excluded sites free and keeps the least distance, for each way to
/// hold the pinned sites (the first 16); empty where none is found. Ties of the `given` sites are taken
/// first.
std::vector<TiedStart> startsOf(const Scene& scene, const Ties& ties, const LuminaireRules& rules,
                                const std::vector<std::uint32_t>& given = {});

/// Is there room for a layout under the arrangement's rule? Of a free rule: yes.
bool hasRoom(const Scene& scene, const LuminaireRules& rules);

/// columns x rows sites of equal pitches on one plane.
struct Field {
  std::uint32_t columns = 0, rows = 0;  // chains along the two directions of the grid
  std::uint32_t plane = 0;
};

/// All regular fields of some counts, in one fixed order.
class Fields {
 public:
  /// Of `least` to `most` luminaires; mirrored about lines through the middle of the grid where an axis is
  /// said. The grid must outlive them.
  Fields(const SiteGrid& grid, std::uint32_t least, std::uint32_t most, PlanAxis axis = PlanAxis::kFound);

  /// Calls `visit` for each until it returns false; `sites` are the field's, `pitch` its smaller one, m
  /// (infinite for a single luminaire).
  void visit(const std::function<bool(const Field&)>& visit) const;
  /// The sites of a field, row by row; false where one is missing.
  bool sitesOf(const Field& field, std::vector<std::uint32_t>& sites) const;
  double pitchOf(const Field& field) const;
  std::size_t columnsOf(const Field& field) const { return chains_[0][field.columns].at.size(); }

 private:
  const SiteGrid& grid_;
  std::uint32_t least_, most_;
  std::vector<Chain> chains_[2];  // of every length up to `most`, shorter ones first
};

/// Which fields may be layouts: those that are whole, hold all pinned sites and no excluded one, keep the
/// least distance and the bodies apart, and are of a type that may hang so often, and alone. The scene and
/// the rules must outlive it.
class FieldRules {
 public:
  FieldRules(const Scene& scene, const LuminaireRules& rules);
  /// `sites` become those of the field, which is one of `fields`.
  bool allow(const Fields& fields, const Field& field, std::vector<std::uint32_t>& sites) const;

 private:
  bool holdsPins(const std::vector<std::uint32_t>& sites) const;

  const Scene& scene_;
  double minDistance_;
  TypeCounts types_;
  std::vector<char> marks_;  // per site: 1 pinned, 2 excluded
  std::uint32_t pinned_ = 0;
};

}  // namespace fiatlux
