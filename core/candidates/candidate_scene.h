// A room seen through the luminaires that may hang in it: each candidate (a site, a luminaire type on it, its
// turn and aim) becomes a site of its own, whose response is the light of that luminaire. Searches, bounds
// and readings then work as they do for squares of light; a layout's flux is 1 for each luminaire. The room
// may be painted otherwise than its file says, and then the squares of its sites are such candidates, too.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "core/base/result.h"
#include "core/scene/plane_points.h"
#include "core/scene/scene.h"
#include "core/transport/mounted_luminaire.h"
#include "core/transport/photometric_light.h"
#include "core/transport/repaint.h"

namespace fiatlux {

struct CandidateType {
  PhotometricType photometric;  // a sampled one: its light is asked for many times
  double flux = 0;              // lm of one luminaire
  double power = 0;             // W of one luminaire; Session::setPowers may say it later
};

struct Candidate {
  std::uint32_t site = 0;   // of the room
  std::uint32_t type = 0;   // index of a CandidateType
  std::uint32_t way = 0;    // of type, turn and aim (Hanging)
  double turn = 0;          // degrees about the site's normal
  std::optional<Vec3> aim;  // m, a point that gamma 0 goes through
};

inline constexpr std::uint32_t kMaxCandidates = 5000;
/// Bytes of the light of all candidates on all patches, so that a search fits into a browser's tab.
inline constexpr std::size_t kMaxCandidateLight = 420'000'000;

/// m: at this least distance no two luminaires hang on one site.
inline constexpr double kCandidatesApart = 1e-3;

/// Makes the scene of some candidates, a few at a time. The room must outlive it.
class CandidateScene {
 public:
  /// An error where the room has no light operator, a candidate no site or type, or there are none or too
  /// many. `light`: the room's, where it is there already. `paint`: of that room; nullptr: it stays as it is.
  static Result<CandidateScene> begin(const Scene& room, std::vector<CandidateType> types,
                                      std::vector<Candidate> candidates,
                                      std::shared_ptr<const PhotometricLight> light = nullptr,
                                      std::shared_ptr<const Repaint> paint = nullptr);
  /// Squares of 1 lm on some sites of a painted room: candidate i on sites[i]. Layouts have fluxes in lm. An
  /// error where a site is not there, or there are none.
  static Result<CandidateScene> ofSquares(const Scene& room, const std::vector<std::uint32_t>& sites,
                                          std::shared_ptr<const Repaint> paint);

  /// Takes what another scene of candidates knows of some of these, in the same room under the same paint:
  /// `there` has the index of each candidate's equal in `known`, kNone where there is none. Before the first
  /// advance(), from several where they are.
  void take(const Scene& known, const std::vector<std::uint32_t>& there);

  /// Leaves some of them dark: their columns are zeros, and nobody sees anything of them. After what is
  /// taken, before the first advance().
  void leaveDark(const std::vector<std::uint32_t>& some);

  /// Takes the light of all candidates as somebody else has computed it: column-major rows x candidates, lx,
  /// each at its type's flux. An error where there is not so much of it, or it is no light.
  Result<Done> know(std::vector<float> columns);

  /// Computes the columns of `count` more; true when all are there. What lies on one site costs less
  /// together.
  bool advance(std::uint32_t count);

  /// The same candidates under other paint: advance() makes their light of what is here, which is kept as
  /// long as anybody needs it. Precondition: advance() said true, and this is the room as its file has it.
  CandidateScene repainted(std::shared_ptr<const Repaint> paint) const;

  const Scene& room() const { return *room_; }
  /// Looks from one more place of these observers; true when seenBy() has nothing left to look for.
  /// Precondition: as for finish(), before it.
  bool look(const std::vector<Observer>& observers);
  /// What observers see of each candidate, for the scene's `observers`. Precondition: likewise.
  std::vector<ObserverRows> seenBy(const std::vector<Observer>& observers);

  /// What they do at the points of measuring planes, for the scene's `planes`; an error where one of these is
  /// no measuring plane, or dark. Precondition: likewise.
  Result<std::vector<PlaneLight>> planesOf(const std::vector<PlaneWish>& wishes) const;
  /// Their light before anything reflects it, for the scene's `direct`. The room must have a light operator.
  DirectLight directLight() const;

  /// Column j and entry j of the mean rows are candidate j's at its type's flux (lx, lm/m2). Statistics of
  /// `quantity` alone, and no covariances: unionStatistics makes them of the responses where they are asked
  /// for. Candidates of one site lie at one place: kCandidatesApart keeps them from each other. Precondition:
  /// advance() said true. Once only.
  Scene finish(Quantity quantity);

 private:
  /// What observers see of candidates, taken from other scenes: of each its rows there, kNone where none has
  /// them.
  struct Seen {
    std::vector<ObserverRows> rows;
    std::vector<std::uint32_t> there;
  };

  CandidateScene(const Scene& room, std::vector<CandidateType> types, std::vector<Candidate> candidates,
                 std::shared_ptr<const PhotometricLight> light, std::shared_ptr<const Repaint> paint);
  RoomView view() const;
  std::vector<const Seen*> knownTo(const std::vector<Observer>& observers) const;
  void takeMeans(const std::vector<SurfaceStatistics>& means, const std::vector<std::uint32_t>& there);
  std::vector<float> columnsOf(std::span<const std::uint32_t> some) const;
  std::vector<PhotometricCandidate> photometric(std::span<const std::uint32_t> some) const;
  Luminaire luminaireOf(const Candidate& candidate) const;
  std::vector<Luminaire> luminaires() const;

  const Scene* room_;
  std::shared_ptr<const PhotometricLight> light_;  // nullptr of squares
  std::shared_ptr<const Repaint> paint_;           // nullptr: as in the file
  std::vector<CandidateType> types_;               // none of squares
  std::vector<Candidate> candidates_;
  std::vector<std::uint32_t> left_;  // candidates whose columns are not there, the next one last
  std::vector<char> isDark_;         // a candidate
  std::shared_ptr<Responses> responses_;
  std::vector<SurfaceStatistics> means_;  // mean rows of the illuminance that is there, one a surface
  std::vector<Seen> seen_;
  std::vector<ObserverRows>
      looked_;  // what the first of the latest observers see of all that is not in seen_
  std::shared_ptr<const Responses> unpainted_;  // of all candidates, where that is known
};

}  // namespace fiatlux
