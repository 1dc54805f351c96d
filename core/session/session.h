// One person's sitting with a room: the scene that is open, what is asked of its light, and the search that
// answers. The one coarse class behind both the page's worker (wasm/bindings.cpp) and the native benchmarks.
// No clock and no I/O: who calls decides how much is done at a time.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "core/alpha/alpha_search.h"
#include "core/bound/layout_bound.h"
#include "core/scene/calculation_grid.h"
#include "core/scene/scene_reader.h"
#include "core/search/intentions.h"
#include "core/search/layout_search.h"
#include "core/search/shown.h"
#include "core/transport/mounted_luminaire.h"
#include "core/transport/photometric_light.h"
#include "core/transport/repaint.h"

namespace fiatlux {

struct SearchProgress {
  std::uint64_t evaluations = 0;  // since start()
  std::uint64_t foundAt = 0;      // the count at which the incumbent was found; 0 = it is the start
  Evaluation evaluation;          // of the incumbent
  bool proved = false;            // all layouts that the rules allow have been tried
};

/// What a search has found.
struct Found {
  Layout layout;
  Evaluation evaluation;
  /// Of the one evenness on a grid that is asked for and missed: none is above.
  std::optional<double> limit = {};
};

class Session {
 public:
  // --- The scene: openTable or openHead, then provide() every section with needed(), then finish(). In
  // between, when every section with early() has been provided, readOutline() tells what is to be seen first.

  /// Checks a file and remembers its table; the scene that was open stays until finish().
  Result<Done> openTable(std::span<const std::uint8_t> file);
  /// The same for a file of which only the head is there (sceneHeadBytes).
  Result<Done> openHead(std::span<const std::uint8_t> head, std::uint64_t fileBytes);
  /// Precondition of the next nine: one of the two succeeded (an Error says so otherwise).
  const SceneTable* table() const { return reader_ ? &reader_->table() : nullptr; }
  bool needed(std::uint32_t section) const { return reader_ && reader_->needed(section); }
  /// A section that the light of other photometries needs: provide() all of them before finish(), or between
  /// finish() and finishOperator(), or none.
  bool ofOperator(std::uint32_t section) const { return reader_ && reader_->ofOperator(section); }
  /// A section that squares of light need, and luminaires of other photometries do not: provide() all of them
  /// before finish(), or between finishLight() and finishStatistics().
  bool ofStatistics(std::uint32_t section) const { return reader_ && reader_->ofStatistics(section); }
  bool early(std::uint32_t section) const { return reader_ && reader_->early(section); }
  Result<Done> verify(std::uint32_t section, std::span<const std::uint8_t> bytes) const;
  Result<Done> provide(std::uint32_t section, std::vector<std::uint8_t> bytes);
  Result<Done> readOutline();
  const Scene* outline() const { return reader_ ? reader_->outline() : nullptr; }
  const OpeningLight* opening() const { return reader_ ? reader_->opening() : nullptr; }
  /// Decodes the sections into the scene; drops the old one, its intentions and searches.
  Result<Done> finish();
  /// Completes the scene of finish() by what the light of other photometries needs; the file is then done
  /// with.
  Result<Done> finishOperator();
  /// Does some of what luminaires of other photometries will want to know of a room, while its responses are
  /// still on their way or once it is open: what is seen from the places of its observers where `looks` (not
  /// once it is open), then of `count` sites. True when nothing is left to do, or the operator is not there.
  bool prepareLight(bool looks, std::uint32_t count);
  /// Decodes all but the statistics: the light of other photometries can be asked for, but no intentions may
  /// be set before finishStatistics() has completed the scene; the file is then done with.
  Result<Done> finishLight();
  Result<Done> finishStatistics();
  /// Takes a scene that did not come from a file. `room`: whose candidates it has, with the same grids and
  /// observers; nullptr: the scene is a room itself.
  void adopt(Scene scene, Session* room = nullptr);
  const Scene* scene() const { return scene_.get(); }
  /// The light of luminaires on the sites of the scene, which keeps what it finds out about them.
  /// Precondition: the scene has a light operator.
  std::shared_ptr<const PhotometricLight> photometricLight();
  /// The sampled type of a photometric file; those of the latest files are kept.
  Result<PhotometricType> photometricType(std::span<const std::uint8_t> file);
  /// The room under other paint, kept until another paint is asked for. An Error where the scene has no light
  /// operator, or a surface is none that can be painted. Refers to the scene and to its photometricLight().
  Result<std::shared_ptr<const Repaint>> repaint(const std::vector<SurfacePaint>& paint);

  // --- Intentions: surfaces are sorted leaf indices, none for "all".

  /// What a luminaire of each type of the scene's hangings draws, W; before setIntentions.
  void setPowers(const std::vector<double>& watts);
  /// Replaces what is asked; running searches end, statistics of surface sets are kept. On an Error nothing
  /// changes.
  Result<Done> setIntentions(const Intentions& intentions);
  const Intentions& intentions() const { return intentions_; }

  /// Is there room on the scene's sites for luminaires as these rules want them? False where no scene is
  /// open.
  bool hasRoom(const LuminaireRules& rules) const;

  /// Some of what a search for the intentions will want to know of the scene: true when nothing is left that
  /// takes longer than reading `rows` rows of its light. Whoever does not wait has it made by start().
  bool prepareSearch(std::size_t rows);

  // --- The search. Each of the next five is an Error without scene or intentions.

  /// Begins a search, from `start` where given (fitted to the rules), at random otherwise. A luminaire of
  /// `start` that hangs on a pinned site is the one that is pinned there, and keeps its number; without a
  /// start the first ones are.
  Result<Done> start(std::uint64_t seed, const Layout* start);
  /// Likewise from a layout some of whose luminaires have just been moved: these stay, and at most four of
  /// those beside them follow (near_search.h). Where none may, as start().
  Result<Done> startNear(std::uint64_t seed, const Layout& start, const std::vector<std::uint32_t>& moved);
  /// Spends that many evaluations. Nothing happens before start().
  SearchProgress advance(std::uint32_t evaluations);
  /// Where the incumbent misses a bound: spends that many evaluations on layouts that miss it by hardly more
  /// and serve the goals better (eased.h), to be told by incumbent() until the search goes on. Nothing
  /// happens before start().
  SearchProgress settle(std::uint32_t evaluations);
  /// Begins to try what `evaluations` find for other intentions, from `start` where given; of a regular field
  /// all are tried. What is asked and the searches that run stay as they are; what is asked next ends it.
  Result<Done> startAside(const Intentions& intentions, std::uint64_t seed, const Layout* start,
                          std::uint32_t evaluations);
  /// Something of what that starts from, which costs no evaluations; true when all of it is there. What is
  /// missing advanceAside() makes.
  bool enterAside() { return !aside_ || aside_->search.enterNext(); }
  /// Some of that, with at most so many evaluations: what has been found once it is done, nothing before. Who
  /// hung in the layout that it started from keeps the number.
  /// Where nothing but an evenness on a grid is asked and missed, it says what no layout can exceed
  /// (evenness_limit.h). An Error where nothing has begun.
  Result<std::optional<Found>> advanceAside(std::uint32_t evaluations);
  /// Readings of the best layout so far. Its luminaires are numbered as in the start, each the one that has
  /// the shorter way to its place (identity.h), and goes no further than what it gains is worth (steady.h).
  Result<Shown> incumbent();
  /// Readings of any layout.
  Result<Shown> show(const Layout& layout);
  /// The calculation grids of the room. Precondition: the scene is open.
  std::shared_ptr<const CalculationGrids> grids();
  /// Those who look in the room by themselves (observersInRoom). Likewise.
  std::shared_ptr<const std::vector<Observer>> observers();
  /// What they, and those of the task areas that are asked about, read of a light (lx, one a row). Likewise.
  std::vector<GridReading> gridsOf(const std::vector<float>& light);

  /// The alpha-search of paper section 4 for the true minima and maxima that are asked for: nullptr before
  /// startAlpha succeeded. `held`: whose luminaires are pinned, as for start(); nothing else is read of it.
  Result<Done> startAlpha(std::uint64_t seed, const Layout* held = nullptr);
  AlphaSearch* alpha() { return alpha_.get(); }

  /// A provable bound on the goal of the search that runs or has run; nullptr before startBound succeeded. An
  /// Error without a search.
  Result<Done> startBound();
  LayoutBound* bound() { return bound_.get(); }
  /// Takes the bound's last stage away for another thread to go through, each step of which is as long as an
  /// answer may take: numbers that pairGoalFrom reads; none where there is no such stage.
  std::vector<double> takePairs();
  /// What it has proved of them, a goal. Nothing happens after another startBound.
  void provedByPairs(double goal);
  /// The best possible is better than the incumbent by at most this share; nothing while nothing is proved.
  std::optional<double> boundGap() const;

 private:
  Result<Done> isComplete() const;
  Result<Done> ready() const;
  Result<Done> lightFor(const Intentions& intentions);
  void pinAsIn(const Layout& layout);
  bool isOfRoom(const Layout& layout) const;
  Layout numberedSince(const Layout& before, const LuminaireRules& rules, const Layout& layout) const;
  void adopt(std::unique_ptr<Scene> scene, Session* room);

  std::optional<SceneReader> reader_;
  // note: in the order of who refers to whom; the prepared scene refers to the scene, searches to both.
  std::unique_ptr<Scene> scene_;
  std::shared_ptr<const PhotometricLight> light_;
  std::shared_ptr<const PhotometricLight> arrivingLight_;  // of the outline of reader_
  std::size_t looked_ = 0;  // observers from whose places it has been looked around there
  struct KnownType {
    std::vector<std::uint8_t> file;
    PhotometricType type;
  };
  std::vector<KnownType> types_;     // the latest one last
  std::vector<SurfacePaint> paint_;  // of repaint_
  std::shared_ptr<const Repaint> repaint_;
  std::unique_ptr<PreparedScene> prepared_;                 // nullptr while the scene has no statistics
  std::shared_ptr<const CalculationGrids> grids_;           // once somebody wants them
  std::shared_ptr<const std::vector<Observer>> observers_;  // likewise
  bool asked_ = false;
  Intentions intentions_;
  std::optional<Layout> before_;                  // that the search started from,
  bool isNear_ = false;                           // and that only a few luminaires may leave
  std::optional<Evaluation> told_;                // of the layout that incumbent() told of it
  std::unique_ptr<LayoutSearch> search_, eased_;  // for what is asked; for that as far as it can be met
  /// For other intentions.
  struct Aside {
    Intentions intentions;
    LayoutSearch search;
    std::uint32_t left = 0;        // evaluations
    std::optional<Layout> before;  // that it started from: who hangs there keeps the number
  };
  std::unique_ptr<Aside> aside_;
  std::unique_ptr<AlphaSearch> alpha_;
  std::unique_ptr<LayoutBound> bound_;
  bool pairsAreTaken_ = false;  // of it
};

}  // namespace fiatlux
