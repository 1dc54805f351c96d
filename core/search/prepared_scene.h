// What a search needs of a scene beyond the scene itself, computed once and shared by every search in it: the
// candidates, statistics of surface sets in the form that the kernels read, and each candidate's nearest
// ones.
#pragma once

#include <cassert>
#include <cstdint>
#include <memory>
#include <optional>
#include <unordered_map>
#include <vector>

#include "core/scene/scene.h"
#include "core/scene/stored_statistics.h"
#include "core/search/arrangements.h"
#include "core/search/bodies.h"
#include "core/search/light_factor.h"
#include "core/search/statistics.h"

namespace fiatlux {

/// Statistics of one surface set for m = stride() candidates: `mean` m entries, `covariance` m x m row-major
/// and symmetric, `diagonal` its m diagonal entries; or instead of these two a factor of the covariance; or
/// nothing of that, where means alone are asked for. Means stay in double, so that the N largest of a row are
/// exactly that.
struct KernelStatistics {
  std::vector<double> mean;
  std::vector<float> covariance, diagonal;
  std::shared_ptr<const LightFactor> factor = nullptr;

  bool hasVariance() const { return factor || !covariance.empty(); }
};

/// How statistics know the variance.
enum class VarianceForm : std::uint8_t {
  kBySize,  // up to kMostInCovariance candidates as covariance, also where the scene has that
  kCovariance,
  kFactor,
};

/// Candidates of which covariances are made. One takes O(rows m^2) to make, a factor O(rows m); a trial then
/// costs O(1) and O(rows). At 2048 making one costs as much as half a million trials by the factor.
inline constexpr std::uint32_t kMostInCovariance = 2048;

/// Mean and variance under a layout of `count` luminaires, by the kernels; the variance only where asked for,
/// else 0.
Moments momentsOf(const KernelStatistics& statistics, const std::uint32_t* sites, const double* flux,
                  std::uint32_t count, bool withVariance = true);

/// The candidates of a search: the sites, or ties of sites that are lit together (arrangements.h). A
/// candidate has a column (its members' summed), a weight (how many luminaires it is) and conflicts. Refers
/// to the scene, which must outlive it.
class PreparedScene {
 public:
  /// Each site is a candidate.
  explicit PreparedScene(const Scene& scene, VarianceForm form = VarianceForm::kBySize);
  /// Each tie is one; beside them stands nobody(), so that layouts may differ in their number of candidates.
  /// `sites`, of the first kind, must outlive it.
  PreparedScene(PreparedScene& sites, Ties ties);

  const Scene& scene() const { return scene_; }
  /// Whose candidates are the sites: itself, unless this one is of ties.
  PreparedScene& sites() { return sites_ ? *sites_ : *this; }
  bool isTied() const { return sites_ != nullptr; }
  const Ties& ties() const { return ties_; }

  std::uint32_t candidateCount() const { return candidateCount_; }
  /// Entries of a row of the statistics: one a candidate, nobody() included.
  std::uint32_t stride() const { return isTied() ? candidateCount_ + 1 : candidateCount_; }
  /// The candidate without light, weight or place, which may be there many times. Precondition: isTied().
  std::uint32_t nobody() const { return candidateCount_; }

  /// Its luminaires.
  std::uint32_t weight(std::uint32_t candidate) const {
    if (!isTied()) return 1;
    return candidate == candidateCount_ ? 0 : static_cast<std::uint32_t>(ties_.members[candidate].size());
  }
  /// Are they ways to hang luminaires of types?
  bool isOfTypes() const { return !scene_.hangings.empty(); }
  /// Ties of one site each, of one of the types?
  bool isOfOneType() const { return isTied() && ties_.key.rule == Rule::kFree && ties_.key.type != kNone; }
  /// The most of them at one place.
  std::uint32_t waysPerPlace() const { return waysPerPlace_; }
  /// The type of its luminaires; 0 where there are no types.
  std::uint32_t typeOf(std::uint32_t candidate) const {
    if (scene_.hangings.empty() || (isTied() && candidate == candidateCount_)) return 0;
    return scene_.hangings[isTied() ? ties_.members[candidate].front() : candidate].type;
  }
  /// The candidate that hangs where `there` does in the way of `like`, or kNone. Precondition: they are of
  /// types and not tied.
  std::uint32_t inWayOf(std::uint32_t like, std::uint32_t there) const;
  std::uint32_t heaviest() const { return heaviest_; }
  std::uint32_t lightest() const { return lightest_; }
  /// Appends the sites of a candidate.
  void appendSites(std::uint32_t candidate, std::vector<std::uint32_t>& sites) const;

  /// Of a set of leaves (empty = all), made at first use and kept (the 64 latest). Without variance it may be
  /// means alone, which are there in no time.
  std::shared_ptr<const KernelStatistics> statistics(Quantity quantity, const SurfaceSet& surfaces,
                                                     bool withVariance = true);
  /// Some of that beforehand, by `rows` rows of light: true when it is there, or is made at once anyway. What
  /// has begun is dropped when another set is asked for. Precondition: !isTied().
  bool prepare(Quantity quantity, const SurfaceSet& surfaces, std::size_t rows);
  /// The covariance of the candidates without nobody(), in double, candidateCount() square.
  std::vector<double> exactCovariance(Quantity quantity, const SurfaceSet& surfaces) const;
  /// What the candidates draw (powerAt) as a row of means, to be summed by the kernels: `mean` has stride()
  /// entries.
  std::shared_ptr<const KernelStatistics> powers() const;

  /// A row of means that an observer of the scene sees each candidate by: ObserverRows::glare or background.
  std::shared_ptr<const KernelStatistics> seenBy(std::uint32_t observer, bool glare) const;
  /// A row of means of the candidates for one of the sites: `ofSites` has an entry each.
  std::shared_ptr<const KernelStatistics> rowOf(const std::vector<double>& ofSites) const;

  /// What each site does at the points of a surface's calculation grid: rows are points. Made at first use
  /// and kept. Precondition: !isTied().
  std::shared_ptr<const Responses> lightOnGrid(Quantity quantity, std::uint32_t surface);

  /// The `nearCount()` candidates nearest to one, itself left out, nearest first, ties by index.
  const std::uint32_t* nearSites(std::uint32_t site) const {
    return near_.data() + std::size_t{site} * nearCount_;
  }
  std::uint32_t nearCount() const { return nearCount_; }

  /// Distance between the centres of two candidates, of ties between their nearest members, m.
  double distance(std::uint32_t a, std::uint32_t b) const;
  /// Do candidates keep each other away by their bodies, whatever their least distance?
  bool hasBodies() const { return hasBodies_; }
  /// May two candidates not be there at once? A layout has each at most once.
  bool conflict(std::uint32_t a, std::uint32_t b, double minDistance) const {
    if (!isTied())
      return a == b || (minDistance > 0 && isTooNear(distance(a, b), minDistance)) ||
             (hasBodies_ && collide(scene_, a, b));
    if (a == candidateCount_ || b == candidateCount_) return false;
    const double gap = gaps_[std::size_t{a} * candidateCount_ + b];
    return gap <= 0 || isTooNear(gap, minDistance);
  }
  /// Ties that share a site with one or run into it, itself included. Precondition: isTied().
  const std::vector<std::uint32_t>& overlapping(std::uint32_t tie) const {
    assert(isTied());
    return overlapping_[tie];
  }
  /// The least distance within a candidate, m; infinite for a single site, 0 where its bodies collide.
  double innerDistance(std::uint32_t candidate) const { return innerDistance_[candidate]; }

  /// The scene of these ties, made at first use and kept while there is room. Precondition: !isTied().
  std::shared_ptr<PreparedScene> tied(const Ties& ties);
  /// Where the sites lie. Precondition: !isTied().
  const SiteGrid& grid();

 private:
  struct Entry {
    Quantity quantity;
    SurfaceSet surfaces;
    std::shared_ptr<const KernelStatistics> statistics;
  };
  struct GridEntry {
    Quantity quantity;
    std::uint32_t surface = 0;
    std::shared_ptr<const Responses> light;
  };
  void findNear(const std::vector<Vec3>& centers);
  /// Between two sites, m; 0 where they may not be at once. Precondition: !isTied().
  double gapOfSites(std::uint32_t a, std::uint32_t b) const;
  /// Of all pairs, made at first use; empty where they are too many to keep.
  const std::vector<double>& siteGaps();
  std::shared_ptr<const KernelStatistics> tiedStatistics(const KernelStatistics& ofSites) const;

  bool isFactored(Quantity quantity) const;
  /// Are covariances made from the light, by as many sums as there are pairs?
  bool isMadeOfLight(Quantity quantity) const;
  const Entry* entryOf(Quantity quantity, const SurfaceSet& surfaces, bool withVariance) const;
  void keep(Entry entry);

  const Scene& scene_;
  bool hasBodies_ = false;
  VarianceForm form_ = VarianceForm::kBySize;
  PreparedScene* sites_ = nullptr;  // where this one is of ties
  Ties ties_;
  std::uint32_t candidateCount_ = 0, heaviest_ = 1, lightest_ = 1, waysPerPlace_ = 1;
  std::vector<Entry> entries_;
  std::vector<GridEntry> grids_;
  struct Begun {
    Quantity quantity;
    SurfaceSet surfaces;
    StatisticsInTurn statistics;
  };
  std::optional<Begun> begun_;
  std::uint32_t nearCount_ = 0;
  std::vector<std::uint32_t> near_;
  std::unordered_map<std::uint64_t, std::uint32_t> inWay_;  // of types: candidate of a place and a way
  std::vector<float>
      gaps_;  // of ties: distances of all pairs, 0 with itself and where they may not be at once
  std::vector<double> innerDistance_;  // of ties
  std::vector<double> siteGaps_;       // of sites, for the ties of them
  std::vector<std::vector<std::uint32_t>> overlapping_;
  std::vector<std::shared_ptr<PreparedScene>> tied_;
  std::optional<SiteGrid> grid_;
};

}  // namespace fiatlux
