// Kernel statistics of surface sets and nearest sites; see prepared_scene.h.
#include "core/search/prepared_scene.h"

#include <algorithm>
#include <cassert>
#include <utility>

#include "core/scene/calculation_grid.h"
#include "core/search/arrangements.h"
#include "core/search/kernels.h"
#include "core/search/variance_sums.h"

namespace fiatlux {
namespace {

constexpr std::uint32_t kNearSites = 48;
constexpr std::size_t kKeptSets = 64;
std::uint64_t keyOf(std::uint32_t place, std::uint32_t way) { return (std::uint64_t{place} << 32) | way; }

constexpr std::size_t kMostTiedEntries = 4'000'000;  // of one covariance of each of the ties that are kept

/// Of the candidates at one place; `type`: of those of one type, kNone of all.
std::uint32_t mostWays(const Scene& scene, std::uint32_t type) {
  std::unordered_map<std::uint32_t, std::uint32_t> ways;
  std::uint32_t most = 1;
  for (const Hanging& hanging : scene.hangings)
    if (type == kNone || hanging.type == type) most = std::max(most, ++ways[hanging.place]);
  return most;
}

std::shared_ptr<const KernelStatistics> kernelStatistics(SurfaceStatistics exact) {
  auto result = std::make_shared<KernelStatistics>();
  const std::size_t m = exact.mean.size();
  result->mean = std::move(exact.mean);
  result->covariance.assign(exact.covariance.begin(), exact.covariance.end());
  result->diagonal.resize(m);
  for (std::size_t i = 0; i < m; ++i) result->diagonal[i] = result->covariance[i * m + i];
  return result;
}

/// What each site does at the points of a surface's grid.
std::shared_ptr<const Responses> gridLight(const Scene& scene, std::uint32_t surface, Quantity quantity) {
  const Responses& rows = responsesOf(scene, quantity);
  const std::vector<std::vector<PatchShare>> points = gridPointsOf(scene, surface);
  auto light = std::make_shared<Responses>();
  light->rows = static_cast<std::uint32_t>(points.size());
  light->sites = rows.sites;
  for (std::uint32_t j = 0; j < rows.sites; ++j) {
    const float* column = rows.column(j);
    for (const std::vector<PatchShare>& point : points) {
      double sum = 0;
      for (const PatchShare& share : point) sum += share.share * column[share.row];
      light->illuminance.push_back(static_cast<float>(sum));
    }
  }
  return light;
}

/// What storedStatistics() says of means, without the rest.
std::shared_ptr<const KernelStatistics> meansAlone(const Scene& scene, Quantity quantity,
                                                   const SurfaceSet& surfaces) {
  struct Row {
    std::uint32_t row;
    double weight;
  };
  const Patches& patches = scene.patches;
  const Responses& light = responsesOf(scene, quantity);
  std::vector<Row> rows;
  double area = 0;
  for (const std::uint32_t p : rowsOf(scene, surfaces)) area += patches.area[p], rows.push_back({p, 0});
  for (Row& row : rows) {
    const double factor = quantity == Quantity::kExitance ? double{patches.reflectance[row.row]} : 1.0;
    row.weight = patches.area[row.row] / area * factor;
  }
  auto result = std::make_shared<KernelStatistics>();
  for (std::uint32_t j = 0; j < light.sites; ++j) {
    const float* column = light.column(j);
    double mean = 0;
    for (const Row& row : rows) mean += row.weight * column[row.row];
    result->mean.push_back(mean);
  }
  return result;
}

std::shared_ptr<const KernelStatistics> factoredStatistics(std::shared_ptr<const LightFactor> factor) {
  return std::make_shared<KernelStatistics>(KernelStatistics{factor->mean(), {}, {}, factor});
}

}  // namespace

Moments momentsOf(const KernelStatistics& statistics, const std::uint32_t* sites, const double* flux,
                  std::uint32_t count, bool withVariance) {
  const auto m = static_cast<std::uint32_t>(statistics.mean.size());
  Moments moments{meanOf(statistics.mean.data(), sites, flux, count), 0};
  if (!withVariance) return moments;
  if (statistics.factor)
    moments.variance = VarianceInTurn(statistics).of(sites, flux, count);
  else
    moments.variance = varianceOf(statistics.covariance.data(), m, sites, flux, count);
  return moments;
}

PreparedScene::PreparedScene(const Scene& scene, VarianceForm form)
    : scene_(scene),
      hasBodies_(haveBodies(scene)),
      form_(form),
      candidateCount_(static_cast<std::uint32_t>(scene.sites.size())) {
  std::vector<Vec3> centers;
  for (const Site& site : scene.sites) centers.push_back(site.position);
  findNear(centers);
  for (std::uint32_t c = 0; c < scene.hangings.size(); ++c)
    inWay_.emplace(keyOf(scene.hangings[c].place, scene.hangings[c].way), c);
  waysPerPlace_ = mostWays(scene, kNone);
}

PreparedScene::PreparedScene(PreparedScene& sites, Ties ties)
    : scene_(sites.scene_),
      hasBodies_(sites.hasBodies_),
      sites_(&sites),
      ties_(std::move(ties)),
      candidateCount_(static_cast<std::uint32_t>(ties_.members.size())),
      waysPerPlace_(mostWays(scene_, ties_.key.type)),
      gaps_(std::size_t{candidateCount_} * candidateCount_, 0.0f),
      innerDistance_(candidateCount_, kUnbounded) {
  const std::vector<double>& known = sites.siteGaps();
  const auto gapBetween = [&](std::uint32_t i, std::uint32_t j) {
    return known.empty() ? sites.gapOfSites(i, j) : known[std::size_t{i} * sites.candidateCount_ + j];
  };
  std::vector<RowSpan> spans;
  if (ties_.key.rule == Rule::kRows)
    for (const std::vector<std::uint32_t>& members : ties_.members) spans.emplace_back(scene_, members);
  const auto gapOf = [&](std::uint32_t a, std::uint32_t b) {
    if (!spans.empty() && spans[a].runsInto(spans[b])) return 0.0;
    double gap = kUnbounded;
    for (const std::uint32_t i : ties_.members[a])
      for (const std::uint32_t j : ties_.members[b]) gap = std::min(gap, gapBetween(i, j));
    return gap;
  };
  std::vector<Vec3> centers;
  for (std::uint32_t a = 0; a < candidateCount_; ++a) {
    const std::vector<std::uint32_t>& members = ties_.members[a];
    heaviest_ = a == 0 ? weight(a) : std::max(heaviest_, weight(a));
    lightest_ = a == 0 ? weight(a) : std::min(lightest_, weight(a));
    Vec3 sum;
    for (const std::uint32_t site : members) sum += scene_.sites[site].position;
    centers.push_back((1.0 / static_cast<double>(members.size())) * sum);
    for (std::size_t i = 0; i < members.size(); ++i)
      for (std::size_t k = 0; k < i; ++k)
        innerDistance_[a] = std::min(innerDistance_[a], gapBetween(members[i], members[k]));
    for (std::uint32_t b = 0; b < a; ++b)
      gaps_[std::size_t{a} * candidateCount_ + b] = gaps_[std::size_t{b} * candidateCount_ + a] =
          static_cast<float>(gapOf(a, b));
  }
  findNear(centers);
  overlapping_.resize(candidateCount_);
  for (std::uint32_t a = 0; a < candidateCount_; ++a)
    for (std::uint32_t b = 0; b < candidateCount_; ++b)
      if (conflict(a, b, 0)) overlapping_[a].push_back(b);
}

double PreparedScene::gapOfSites(std::uint32_t a, std::uint32_t b) const {
  return conflict(a, b, 0) ? 0 : distance(a, b);
}

/// Every rule ties the same sites again and again: what lies between two is looked up.
const std::vector<double>& PreparedScene::siteGaps() {
  assert(!isTied());
  if (!siteGaps_.empty() || candidateCount_ > kMostInCovariance) return siteGaps_;
  siteGaps_.resize(std::size_t{candidateCount_} * candidateCount_);
  for (std::uint32_t a = 0; a < candidateCount_; ++a)
    for (std::uint32_t b = 0; b <= a; ++b)
      siteGaps_[std::size_t{a} * candidateCount_ + b] = siteGaps_[std::size_t{b} * candidateCount_ + a] =
          gapOfSites(a, b);
  return siteGaps_;
}

void PreparedScene::findNear(const std::vector<Vec3>& centers) {
  const std::uint32_t m = candidateCount_;
  nearCount_ = m == 0 ? 0 : std::min(m - 1, kNearSites);
  near_.reserve(std::size_t{m} * nearCount_);
  std::vector<std::pair<double, std::uint32_t>> order;
  for (std::uint32_t a = 0; a < m; ++a) {
    order.clear();
    for (std::uint32_t b = 0; b < m; ++b)
      if (b != a) order.emplace_back(length(centers[a] - centers[b]), b);
    const auto last = order.begin() + nearCount_;
    std::nth_element(order.begin(), last, order.end());
    std::sort(order.begin(), last);
    for (std::uint32_t k = 0; k < nearCount_; ++k) near_.push_back(order[k].second);
  }
}

void PreparedScene::appendSites(std::uint32_t candidate, std::vector<std::uint32_t>& sites) const {
  if (!isTied()) return sites.push_back(candidate);
  if (candidate == candidateCount_) return;
  sites.insert(sites.end(), ties_.members[candidate].begin(), ties_.members[candidate].end());
}

/// Covariances that the scene has are at hand, whatever they cost.
bool PreparedScene::isFactored(Quantity quantity) const {
  if (form_ != VarianceForm::kBySize) return form_ == VarianceForm::kFactor;
  return candidateCount_ > kMostInCovariance && leafStatistics(scene_, quantity)[0].covariance.empty();
}

bool PreparedScene::isMadeOfLight(Quantity quantity) const {
  return leafStatistics(scene_, quantity)[0].covariance.empty() && !isFactored(quantity);
}

const PreparedScene::Entry* PreparedScene::entryOf(Quantity quantity, const SurfaceSet& surfaces,
                                                   bool withVariance) const {
  for (const Entry& entry : entries_)
    if (entry.quantity == quantity && entry.surfaces == surfaces &&
        (!withVariance || entry.statistics->hasVariance()))
      return &entry;
  return nullptr;
}

/// In place of what is known of the same set.
void PreparedScene::keep(Entry entry) {
  std::erase_if(entries_, [&](const Entry& known) {
    return known.quantity == entry.quantity && known.surfaces == entry.surfaces;
  });
  if (entries_.size() == kKeptSets) entries_.erase(entries_.begin());
  entries_.push_back(std::move(entry));
}

std::shared_ptr<const KernelStatistics> PreparedScene::statistics(Quantity quantity,
                                                                  const SurfaceSet& surfaces,
                                                                  bool withVariance) {
  if (const Entry* known = entryOf(quantity, surfaces, withVariance)) return known->statistics;
  const auto made = [&]() -> std::shared_ptr<const KernelStatistics> {
    if (isTied()) return tiedStatistics(*sites_->statistics(quantity, surfaces, withVariance));
    if (isFactored(quantity))
      return factoredStatistics(std::make_shared<LightFactor>(scene_, quantity, surfaces));
    if (!withVariance && isMadeOfLight(quantity)) return meansAlone(scene_, quantity, surfaces);
    return kernelStatistics(unionStatistics(scene_, quantity, surfaces));
  };
  keep({quantity, surfaces, made()});
  return entries_.back().statistics;
}

bool PreparedScene::prepare(Quantity quantity, const SurfaceSet& surfaces, std::size_t rows) {
  assert(!isTied());
  if (!isMadeOfLight(quantity) || entryOf(quantity, surfaces, true)) return true;
  if (!begun_ || begun_->quantity != quantity || begun_->surfaces != surfaces)
    begun_.emplace(Begun{
        quantity, surfaces,
        StatisticsInTurn(scene_.patches, responsesOf(scene_, quantity), quantity, rowsOf(scene_, surfaces))});
  if (!begun_->statistics.advance(rows)) return false;
  keep({quantity, surfaces, kernelStatistics(begun_->statistics.take())});
  begun_.reset();
  return true;
}

namespace {

/// P^T C P, both row-major; `stride` entries a row of the result.
template <class Number>
std::vector<Number> tiedCovariance(const Ties& ties, const std::vector<Number>& covariance, std::size_t sites,
                                   std::size_t stride) {
  std::vector<Number> result(stride * stride, Number{0});
  std::vector<double> sum(sites);
  for (std::size_t a = 0; a < ties.members.size(); ++a) {
    std::fill(sum.begin(), sum.end(), 0.0);
    for (const std::uint32_t site : ties.members[a]) {
      const Number* row = covariance.data() + site * sites;
      for (std::size_t j = 0; j < sites; ++j) sum[j] += row[j];
    }
    for (std::size_t b = 0; b <= a; ++b) {
      double entry = 0;
      for (const std::uint32_t site : ties.members[b]) entry += sum[site];
      result[a * stride + b] = result[b * stride + a] = static_cast<Number>(entry);
    }
  }
  return result;
}

}  // namespace

std::shared_ptr<const KernelStatistics> PreparedScene::tiedStatistics(const KernelStatistics& ofSites) const {
  if (ofSites.factor) return factoredStatistics(std::make_shared<LightFactor>(*ofSites.factor, ties_));
  auto result = std::make_shared<KernelStatistics>();
  result->mean.assign(stride(), 0.0);
  for (std::uint32_t c = 0; c < candidateCount_; ++c)
    for (const std::uint32_t site : ties_.members[c]) result->mean[c] += ofSites.mean[site];
  if (!ofSites.hasVariance()) return result;
  result->covariance = tiedCovariance(ties_, ofSites.covariance, ofSites.mean.size(), stride());
  for (std::size_t c = 0; c < stride(); ++c) result->diagonal.push_back(result->covariance[c * stride() + c]);
  return result;
}

std::vector<double> PreparedScene::exactCovariance(Quantity quantity, const SurfaceSet& surfaces) const {
  std::vector<double> exact = unionStatistics(scene_, quantity, surfaces).covariance;
  return isTied() ? tiedCovariance(ties_, exact, scene_.sites.size(), candidateCount_) : exact;
}

std::shared_ptr<const KernelStatistics> PreparedScene::powers() const {
  auto result = std::make_shared<KernelStatistics>();
  std::vector<std::uint32_t> members;
  for (std::uint32_t c = 0; c < stride(); ++c) {
    members.clear();
    appendSites(c, members);
    double power = 0;
    for (const std::uint32_t site : members) power += powerAt(scene_, site);
    result->mean.push_back(power);
  }
  return result;
}

std::shared_ptr<const KernelStatistics> PreparedScene::seenBy(std::uint32_t observer, bool glare) const {
  const ObserverRows& rows = scene_.observers[observer];
  return rowOf(glare ? rows.glare : rows.background);
}

std::shared_ptr<const KernelStatistics> PreparedScene::rowOf(const std::vector<double>& ofSites) const {
  auto result = std::make_shared<KernelStatistics>();
  result->mean.assign(stride(), 0.0);
  std::vector<std::uint32_t> members;
  for (std::uint32_t c = 0; c < candidateCount_; ++c) {
    members.clear();
    appendSites(c, members);
    for (const std::uint32_t site : members) result->mean[c] += ofSites[site];
  }
  return result;
}

std::shared_ptr<const Responses> PreparedScene::lightOnGrid(Quantity quantity, std::uint32_t surface) {
  assert(!isTied());
  for (const GridEntry& known : grids_)
    if (known.quantity == quantity && known.surface == surface) return known.light;
  grids_.push_back({quantity, surface, gridLight(scene_, surface, quantity)});
  return grids_.back().light;
}

std::uint32_t PreparedScene::inWayOf(std::uint32_t like, std::uint32_t there) const {
  assert(!isTied() && !scene_.hangings.empty());
  const auto found = inWay_.find(keyOf(scene_.hangings[there].place, scene_.hangings[like].way));
  return found == inWay_.end() ? kNone : found->second;
}

double PreparedScene::distance(std::uint32_t a, std::uint32_t b) const {
  if (isTied()) return gaps_[std::size_t{a} * candidateCount_ + b];
  return length(scene_.sites[a].position - scene_.sites[b].position);
}

std::shared_ptr<PreparedScene> PreparedScene::tied(const Ties& ties) {
  assert(!isTied());
  std::size_t entries = ties.members.size() * ties.members.size();
  for (const std::shared_ptr<PreparedScene>& known : tied_) {
    if (known->ties_.key == ties.key) return known;
    entries += std::size_t{known->candidateCount_} * known->candidateCount_;
  }
  if (entries > kMostTiedEntries) tied_.clear();
  tied_.push_back(std::make_shared<PreparedScene>(*this, ties));
  return tied_.back();
}

const SiteGrid& PreparedScene::grid() {
  assert(!isTied());
  if (!grid_) grid_.emplace(scene_);
  return *grid_;
}

}  // namespace fiatlux
