// Ties and fields; see arrangements.h.
#include "core/search/arrangements.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/base/random.h"
#include "core/search/bodies.h"

namespace fiatlux {
namespace {

constexpr std::size_t kMostCovers = 16;  // ways to hold the pinned sites
constexpr int kRandomOrders = 12;        // tried to find room for a layout
constexpr double kSameLine = 2e-3;       // m, as a grid tells coordinates apart

// --- Symmetry

/// The image of each site under the mirror that maps a coordinate v to twice - v; kNone where there is none.
std::vector<std::uint32_t> imagesUnder(const SiteGrid& grid, std::uint32_t sites, int direction,
                                       double twice) {
  std::vector<std::uint32_t> indices;
  for (const double value : grid.values(direction)) indices.push_back(grid.indexOf(direction, twice - value));
  std::vector<std::uint32_t> images(sites, kNone);
  for (std::uint32_t j = 0; j < sites; ++j) {
    std::array<std::uint32_t, 3> cell = grid.cell(j);
    cell[direction] = indices[cell[direction]];
    if (cell[direction] != kNone && grid.isSquare(cell[2]))
      images[j] = grid.siteAt(cell[0], cell[1], cell[2]);
  }
  return images;
}

/// Of the mirrors across a direction the one that keeps the most sites, nearest to the middle.
std::vector<std::uint32_t> bestMirror(const SiteGrid& grid, std::uint32_t sites, int direction) {
  const std::vector<double>& values = grid.values(direction);
  std::vector<double> sums;
  for (std::size_t i = 0; i < values.size(); ++i)
    for (std::size_t j = i; j < values.size(); ++j) sums.push_back(values[i] + values[j]);
  const double middle = values.front() + values.back();
  std::sort(sums.begin(), sums.end(), [&](double a, double b) {
    const double offA = std::fabs(a - middle), offB = std::fabs(b - middle);
    return offA < offB - 1e-4 || (offA < offB + 1e-4 && a < b);
  });
  std::vector<std::uint32_t> best;
  std::size_t kept = 0;
  double last = kUnbounded;
  for (const double sum : sums) {
    if (std::fabs(sum - last) < 1e-3) continue;
    last = sum;
    std::vector<std::uint32_t> images = imagesUnder(grid, sites, direction, sum);
    const std::size_t here =
        sites - static_cast<std::size_t>(std::count(images.begin(), images.end(), kNone));
    if (here <= kept) continue;
    kept = here;
    best = std::move(images);
    if (kept == sites) break;
  }
  return best;
}

/// Orbits of the sites under the mirrors; a site that a mirror throws off the sites drops out with its orbit.
Ties orbitsUnder(const std::vector<std::vector<std::uint32_t>>& mirrors, std::uint32_t sites, PlanAxis axis) {
  Ties ties{{Rule::kSymmetric, axis, 1, 0}, {}};
  std::vector<char> seen(sites, 0);
  for (std::uint32_t j = 0; j < sites; ++j) {
    if (seen[j]) continue;
    std::vector<std::uint32_t> orbit = {j};
    bool whole = true;
    seen[j] = 1;
    for (std::size_t k = 0; k < orbit.size(); ++k)
      for (const std::vector<std::uint32_t>& mirror : mirrors) {
        const std::uint32_t image = mirror[orbit[k]];
        if (image == kNone) {
          whole = false;
        } else if (!seen[image]) {
          seen[image] = 1;
          orbit.push_back(image);
        }
      }
    if (!whole) continue;
    std::sort(orbit.begin(), orbit.end());
    ties.members.push_back(std::move(orbit));
  }
  return ties;
}

std::vector<Ties> symmetricTies(const SiteGrid& grid, std::uint32_t sites, PlanAxis asked) {
  if (asked == PlanAxis::kBoth)
    return {orbitsUnder({bestMirror(grid, sites, 1), bestMirror(grid, sites, 0)}, sites, asked)};
  std::vector<Ties> result;
  for (const PlanAxis axis : {PlanAxis::kX, PlanAxis::kZ})
    if (asked == axis || asked == PlanAxis::kFound)
      result.push_back(orbitsUnder({bestMirror(grid, sites, axis == PlanAxis::kX ? 1 : 0)}, sites, axis));
  return result;
}

// --- Rows

/// All rows on chains of one length along a direction, one P a pitch.
void addRows(const SiteGrid& grid, int direction, const std::vector<Chain>& chains,
             std::vector<Ties>& result) {
  const PlanAxis axis = direction == 0 ? PlanAxis::kX : PlanAxis::kZ;
  const auto lines = static_cast<std::uint32_t>(grid.values(1 - direction).size());
  const std::size_t first = result.size();
  for (const Chain& chain : chains) {
    const auto count = static_cast<std::uint32_t>(chain.at.size());
    const TieKey key{Rule::kRows, axis, count, static_cast<std::uint32_t>(std::lround(1e3 * chain.pitch))};
    auto ties = std::find_if(
        result.begin() + static_cast<std::ptrdiff_t>(first), result.end(),
        [&](const Ties& t) { return t.key.pitch + 2 >= key.pitch && t.key.pitch <= key.pitch + 2; });
    if (ties == result.end()) ties = result.insert(result.end(), {key, {}});
    for (std::uint32_t plane = 0; plane < grid.planeCount(); ++plane)
      for (std::uint32_t line = 0; line < lines; ++line) {
        std::vector<std::uint32_t> row;
        for (const std::uint32_t at : chain.at) {
          const std::uint32_t site =
              direction == 0 ? grid.siteAt(at, line, plane) : grid.siteAt(line, at, plane);
          if (site == kNone) break;
          row.push_back(site);
        }
        if (row.size() != count) continue;
        std::sort(row.begin(), row.end());
        ties->members.push_back(std::move(row));
      }
  }
}

std::vector<Ties> rowTies(const SiteGrid& grid, const LuminaireRules& rules) {
  const std::uint32_t most = mostOf(rules);
  std::vector<Ties> result;
  for (const PlanAxis axis : {PlanAxis::kX, PlanAxis::kZ}) {
    if (rules.arrangement.axis != axis && rules.arrangement.axis != PlanAxis::kFound) continue;
    const int direction = axis == PlanAxis::kX ? 0 : 1;
    const Chains chains(grid, direction);
    const std::uint32_t longest = std::min(most, chains.longest());
    for (std::uint32_t count = std::min(rules.arrangement.leastInRow, most); count <= longest; ++count)
      if (most / count * count >= rules.count) addRows(grid, direction, chains.of(count), result);
  }
  result.erase(std::remove_if(result.begin(), result.end(), [](const Ties& t) { return t.members.empty(); }),
               result.end());
  return result;
}

// --- Room for a layout

/// Sites that are taken, and whether a tie may come to them.
class Occupied {
 public:
  Occupied(const Scene& scene, const LuminaireRules& rules)
      : scene_(scene),
        types_(scene, rules),
        minDistance_(rules.minDistance),
        hasBodies_(haveBodies(scene)),
        areRows_(rules.arrangement.rule == Rule::kRows),
        barred_(scene.sites.size(), 0) {
    for (const std::uint32_t site : rules.excluded) barred_[site] = 1;
  }

  bool accepts(const std::vector<std::uint32_t>& tie) const {
    if (areRows_) {
      const RowSpan span(scene_, tie);
      for (const RowSpan& row : rows_)
        if (row.runsInto(span)) return false;
    }
    for (std::size_t i = 0; i < tie.size(); ++i) {
      if (barred_[tie[i]]) return false;
      if (minDistance_ <= 0 && !hasBodies_) continue;
      for (std::size_t k = 0; k < i; ++k)
        if (areTooNear(tie[i], tie[k])) return false;
      for (const std::uint32_t site : taken_)
        if (areTooNear(tie[i], site)) return false;
    }
    return true;
  }
  void take(const std::vector<std::uint32_t>& tie) {
    if (areRows_) rows_.emplace_back(scene_, tie);
    for (const std::uint32_t site : tie) {
      barred_[site] = 1;
      taken_.push_back(site);
      types_.add(typeOf(scene_, site), 1);
    }
  }
  /// A site that only the ties taken so far may hold.
  void bar(std::uint32_t site) { barred_[site] = 1; }
  std::size_t count() const { return taken_.size(); }
  bool typesAreMet() const { return types_.areMet(); }
  /// May it join where there may be `most` luminaires, so that each type can still have as many as it must?
  bool leavesRoom(const std::vector<std::uint32_t>& tie, std::uint32_t most) const {
    const auto size = static_cast<std::uint32_t>(tie.size()),
               count = static_cast<std::uint32_t>(taken_.size());
    return count + size <= most && types_.leaveRoom(typeOf(scene_, tie[0]), size, most - count - size);
  }

 private:
  bool areTooNear(std::uint32_t a, std::uint32_t b) const {
    return isTooNear(length(scene_.sites[a].position - scene_.sites[b].position), minDistance_) ||
           collide(scene_, a, b);
  }

  const Scene& scene_;
  TypeCounts types_;
  double minDistance_;
  bool hasBodies_, areRows_;
  std::vector<char> barred_;
  std::vector<std::uint32_t> taken_;
  std::vector<RowSpan> rows_;  // that were taken
};

/// The ways to hold the pinned sites from the `next`-th on by ties.
void cover(const Ties& ties, const std::vector<std::uint32_t>& pins, std::size_t next,
           const Occupied& occupied, std::vector<std::uint32_t>& chosen,
           std::vector<std::vector<std::uint32_t>>& covers) {
  const auto holds = [&](std::uint32_t tie, std::uint32_t site) {
    return std::binary_search(ties.members[tie].begin(), ties.members[tie].end(), site);
  };
  while (next < pins.size() &&
         std::any_of(chosen.begin(), chosen.end(), [&](std::uint32_t tie) { return holds(tie, pins[next]); }))
    ++next;
  if (next == pins.size()) {
    covers.push_back(chosen);
    return;
  }
  for (std::uint32_t tie = 0; tie < ties.members.size() && covers.size() < kMostCovers; ++tie) {
    if (!holds(tie, pins[next]) || !occupied.accepts(ties.members[tie])) continue;
    Occupied with = occupied;
    with.take(ties.members[tie]);
    chosen.push_back(tie);
    cover(ties, pins, next + 1, with, chosen, covers);
    chosen.pop_back();
  }
}

/// Adds ties in the given order until there are `wanted` luminaires, or as many as are allowed.
bool fill(const Ties& ties, const std::vector<std::uint32_t>& order, const LuminaireRules& rules,
          std::size_t wanted, Occupied occupied, std::vector<std::uint32_t>& chosen) {
  for (const std::uint32_t tie : order) {
    if (occupied.count() >= wanted && occupied.typesAreMet()) break;
    if (!occupied.accepts(ties.members[tie]) || !occupied.leavesRoom(ties.members[tie], mostOf(rules)))
      continue;
    occupied.take(ties.members[tie]);
    chosen.push_back(tie);
  }
  return occupied.count() >= rules.count && occupied.count() <= mostOf(rules) && occupied.typesAreMet();
}

/// Orders in which to look for room: spread after the ties of the given sites, from the first on, and some at
/// random.
std::vector<std::vector<std::uint32_t>> ordersOf(const Ties& ties, const std::vector<std::uint32_t>& given,
                                                 std::uint32_t wanted) {
  const auto count = static_cast<std::uint32_t>(ties.members.size());
  std::vector<std::uint32_t> inOrder(count), spread;
  for (std::uint32_t i = 0; i < count; ++i) inOrder[i] = i;
  std::vector<std::uint32_t> sites = given;
  std::sort(sites.begin(), sites.end());
  for (std::uint32_t i = 0; i < count && !sites.empty(); ++i)
    if (std::includes(sites.begin(), sites.end(), ties.members[i].begin(), ties.members[i].end()))
      spread.push_back(i);
  for (std::uint64_t i = 0; i < wanted; ++i)
    spread.push_back(static_cast<std::uint32_t>((2 * i + 1) * count / (2 * wanted)));
  spread.insert(spread.end(), inOrder.begin(), inOrder.end());
  std::vector<std::vector<std::uint32_t>> orders = {std::move(spread), inOrder};
  Random random(0x5eed);
  for (int k = 0; k < kRandomOrders; ++k) {
    for (std::uint32_t i = count; i > 1; --i) std::swap(inOrder[i - 1], inOrder[random.below(i)]);
    orders.push_back(inOrder);
  }
  return orders;
}

/// Is a chain its own mirror image about the middle of all coordinates?
bool isCentred(const Chain& chain, const std::vector<double>& values) {
  const double ends = values[chain.at.front()] + values[chain.at.back()];
  return std::fabs(ends - values.front() - values.back()) < 4e-3;  // two millimetres each
}

}  // namespace

std::vector<Ties> tiesUnder(const SiteGrid& grid, const LuminaireRules& rules) {
  const std::uint32_t sites = grid.siteCount();
  switch (rules.arrangement.rule) {
    case Rule::kSymmetric:
      return symmetricTies(grid, sites, rules.arrangement.axis);
    case Rule::kRows:
      return rowTies(grid, rules);
    case Rule::kField:
      return {};
    case Rule::kFree:
      break;
  }
  Ties alone;
  for (std::uint32_t j = 0; j < sites; ++j) alone.members.push_back({j});
  return {alone};
}

RowSpan::RowSpan(const Scene& scene, const std::vector<std::uint32_t>& row) {
  if (row.size() < 2) return;
  const auto place = [&](std::uint32_t site) { return scene.sites[site].position; };
  origin_ = place(row[0]);
  along_ = normalized(place(row[1]) - origin_);
  for (const std::uint32_t site : row) {
    const double at = dot(place(site) - origin_, along_);
    if (at <= begin_) begin_ = at, ends_[0] = place(site);
    if (at >= end_) end_ = at, ends_[1] = place(site);
  }
  pitch_ = (end_ - begin_) / static_cast<double>(row.size() - 1);
}

bool RowSpan::runsInto(const RowSpan& other) const {
  if (pitch_ == 0 || other.pitch_ == 0) return false;
  const Vec3 across = other.origin_ - origin_;
  if (length(across - dot(across, along_) * along_) > kSameLine) return false;
  const double a = dot(other.ends_[0] - origin_, along_), b = dot(other.ends_[1] - origin_, along_);
  return std::max(begin_, std::min(a, b)) - std::min(end_, std::max(a, b)) < pitch_ - kSameLine;
}

std::vector<Ties> tiesOfEachType(const Scene& scene, const Ties& ties, const LuminaireRules& rules) {
  const std::uint32_t types = typeCountOf(scene);
  if (types < 2) return {};
  const std::vector<TypeRange> ranges = rangesOf(rules, types);
  const auto others = [&](std::uint32_t type) {
    std::uint32_t least = 0;
    for (std::uint32_t t = 0; t < ranges.size(); ++t) least += t == type ? 0 : ranges[t].least;
    return least;
  };
  std::vector<Ties> each;
  for (std::uint32_t type = 0; type < types; ++type) {
    if (others(type) > 0 || ranges[type].most < rules.count) continue;
    Ties alone{ties.key, {}};
    alone.key.type = type;
    for (const std::vector<std::uint32_t>& members : ties.members)
      if (scene.hangings[members.front()].type == type) alone.members.push_back(members);
    if (!alone.members.empty()) each.push_back(std::move(alone));
  }
  return each;
}

std::vector<TiedStart> startsOf(const Scene& scene, const Ties& ties, const LuminaireRules& rules,
                                const std::vector<std::uint32_t>& given) {
  std::vector<std::uint32_t> pins;
  for (const std::uint32_t site : rules.pinned)
    if (site != kNone) pins.push_back(site);
  const Occupied empty(scene, rules);
  std::vector<std::vector<std::uint32_t>> covers;
  std::vector<std::uint32_t> chosen;
  cover(ties, pins, 0, empty, chosen, covers);
  const std::size_t wanted = std::clamp<std::size_t>(given.size(), rules.count, mostOf(rules));
  std::vector<TiedStart> starts;
  std::vector<std::vector<std::uint32_t>> orders;
  for (const std::vector<std::uint32_t>& held : covers) {
    Occupied occupied = empty;
    for (const std::uint32_t tie : held) occupied.take(ties.members[tie]);
    if (orders.empty()) orders = ordersOf(ties, given, rules.count);
    for (const std::vector<std::uint32_t>& order : orders) {
      TiedStart start{held, static_cast<std::uint32_t>(held.size())};
      if (!fill(ties, order, rules, wanted, occupied, start.ties)) continue;
      starts.push_back(std::move(start));
      break;
    }
  }
  return starts;
}

bool hasRoom(const Scene& scene, const LuminaireRules& rules) {
  if (rules.arrangement.rule == Rule::kFree) return true;
  const SiteGrid grid(scene);
  if (rules.arrangement.rule != Rule::kField) {
    for (const Ties& ties : tiesUnder(grid, rules))
      if (!startsOf(scene, ties, rules).empty()) return true;
    return false;
  }
  bool found = false;
  const Fields fields(grid, rules.count, mostOf(rules), rules.arrangement.axis);
  const FieldRules allowed(scene, rules);
  std::vector<std::uint32_t> sites;
  fields.visit([&](const Field& field) {
    found = allowed.allow(fields, field, sites);
    return !found;
  });
  return found;
}

// --- Fields

Fields::Fields(const SiteGrid& grid, std::uint32_t least, std::uint32_t most, PlanAxis axis)
    : grid_(grid), least_(least), most_(most) {
  for (int d = 0; d < 2; ++d) {
    // Mirrored about a line along x it is the same across.
    const bool isMirrored = axis == PlanAxis::kBoth || axis == (d == 1 ? PlanAxis::kX : PlanAxis::kZ);
    const Chains chains(grid, d);
    for (std::uint32_t count = 1; count <= std::min(most, chains.longest()); ++count)
      for (Chain& chain : chains.of(count))
        if (!isMirrored || isCentred(chain, grid.values(d))) chains_[d].push_back(std::move(chain));
  }
}

void Fields::visit(const std::function<bool(const Field&)>& visit) const {
  for (std::uint32_t columns = 0; columns < chains_[0].size(); ++columns)
    for (std::uint32_t rows = 0; rows < chains_[1].size(); ++rows) {
      const std::size_t count = chains_[0][columns].at.size() * chains_[1][rows].at.size();
      if (count > most_) break;  // note: shorter chains come first
      if (count < least_) continue;
      for (std::uint32_t plane = 0; plane < grid_.planeCount(); ++plane)
        if (!visit({columns, rows, plane})) return;
    }
}

bool Fields::sitesOf(const Field& field, std::vector<std::uint32_t>& sites) const {
  sites.clear();
  for (const std::uint32_t row : chains_[1][field.rows].at)
    for (const std::uint32_t column : chains_[0][field.columns].at) {
      sites.push_back(grid_.siteAt(column, row, field.plane));
      if (sites.back() == kNone) return false;
    }
  return true;
}

double Fields::pitchOf(const Field& field) const {
  double pitch = kUnbounded;
  for (const Chain& chain : {std::cref(chains_[0][field.columns]), std::cref(chains_[1][field.rows])})
    if (chain.at.size() > 1) pitch = std::min(pitch, chain.pitch);
  return pitch;
}

FieldRules::FieldRules(const Scene& scene, const LuminaireRules& rules)
    : scene_(scene), minDistance_(rules.minDistance), types_(scene, rules), marks_(scene.sites.size(), 0) {
  for (const std::uint32_t site : rules.excluded) marks_[site] = 2;
  for (const std::uint32_t site : rules.pinned)
    if (site != kNone) {
      marks_[site] = 1;
      ++pinned_;
    }
}

bool FieldRules::allow(const Fields& fields, const Field& field, std::vector<std::uint32_t>& sites) const {
  return !isTooNear(fields.pitchOf(field), minDistance_) && fields.sitesOf(field, sites) &&
         types_.allowAlone(typeOf(scene_, sites[0]), static_cast<std::uint32_t>(sites.size())) &&
         holdsPins(sites) && !fieldCollides(scene_, sites, fields.columnsOf(field));
}

bool FieldRules::holdsPins(const std::vector<std::uint32_t>& sites) const {
  std::uint32_t held = 0;
  for (const std::uint32_t site : sites) {
    if (marks_[site] == 2) return false;
    held += marks_[site];
  }
  return held == pinned_;
}

}  // namespace fiatlux
