// The search for a layout under the arrangement that is asked for. Free and of a fixed count: a variable
// neighbourhood search over sites. A field: every one is tried. Else a search over each P that the rule
// allows (arrangements.h), the better half of which goes on for twice as long, until one is left and all
// begin again. Of several types each is also searched alone: a layout of one type is far from where types are
// mixed, for a bound may forbid every way between.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include "core/search/arrangements.h"
#include "core/search/field_scan.h"
#include "core/search/vns.h"

namespace fiatlux {

/// When the searches that run side by side are made: one a P takes long where there are many.
enum class Entering : std::uint8_t { kAtOnce, kInSteps };

class LayoutSearch {
 public:
  /// As Vns, for intentions with any arrangement and range of counts. `prepared` is of sites. `entering`:
  /// where it is in steps, nothing is known of a layout before enterNext() is true, or the first advance();
  /// `prepared` and `reference` are there until then.
  LayoutSearch(PreparedScene& prepared, const Intentions& intentions, std::uint64_t seed,
               const Layout* start = nullptr, const Layout* reference = nullptr,
               Entering entering = Entering::kAtOnce);

  /// Makes one more of the searches that run side by side: true when none is missing.
  bool enterNext();

  /// Spends `evaluations` more, or fewer when nothing is left to try. Slices of any size take the same path.
  void advance(std::uint32_t evaluations);

  /// The best layout so far: a pinned luminaire has the number that it is pinned by, and `ties` say what
  /// moves together (empty where the arrangement is free).
  Layout incumbent() const;
  const Evaluation& evaluation() const;
  std::uint64_t evaluations() const;
  std::uint64_t foundAt() const;
  /// All layouts that the rules allow have been tried: the incumbent is the best there is.
  bool isProved() const { return fields_ && fields_->isDone(); }

 private:
  /// One P with one way to hold the pinned sites, and the search over its ties.
  struct Entrant {
    std::shared_ptr<PreparedScene> scene;  // nullptr: that of the sites
    std::unique_ptr<Vns> search;
  };
  /// Those that are still to be made, and of what.
  struct Missing {
    PreparedScene& prepared;
    Intentions intentions;
    std::uint64_t seed = 0;
    const Layout* reference = nullptr;
    std::vector<std::pair<Ties, TiedStart>> starts;  // all of them; one an entrant
    std::size_t next = 0;
  };
  void addStarts(const std::vector<std::uint32_t>& given, bool onlyAlone);
  void enter(Entrant entrant);
  void begin();
  void closeTurn();
  const Vns& best() const { return *entrants_[ranking_[0]].search; }

  const Scene& scene_;
  LuminaireRules rules_;
  std::optional<Vns> free_;
  std::optional<FieldScan> fields_;
  std::unique_ptr<Missing> missing_;  // nullptr = none is
  std::vector<Entrant> entrants_;
  std::vector<std::uint32_t> ranking_;  // of the entrants, best first as far as they have been compared
  std::uint32_t running_ = 0;           // so many of them are in this round,
  std::uint32_t turn_ = 0;              // the one whose turn it is,
  std::uint32_t left_ = 0;              // and the evaluations of its turn that are left
  std::uint32_t perTurn_ = 0;
  std::uint64_t evaluations_ = 0, foundAt_ = 0;
  Layout best_;
  Evaluation bestEvaluation_;
};

}  // namespace fiatlux
