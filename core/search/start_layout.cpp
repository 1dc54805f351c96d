// Start layouts under pins, exclusions and distances; see start_layout.h.
#include "core/search/start_layout.h"

#include <algorithm>

#include "core/search/type_counts.h"

namespace fiatlux {
namespace {

/// Fills a layout candidate by candidate, pinned ones first, refusing those that the rules forbid.
class Packer {
 public:
  /// Until there are `wanted` luminaires.
  Packer(const PreparedScene& prepared, const LuminaireRules& rules, std::uint32_t wanted)
      : prepared_(prepared),
        rules_(rules),
        wanted_(wanted),
        types_(prepared.scene(), rules),
        allowed_(prepared.candidateCount(), 1) {
    for (std::uint32_t site : rules.excluded) allowed_[site] = 0;
    for (std::uint32_t site : rules.pinned)
      if (site != kNone) take(site);
  }

  void offer(std::uint32_t site) {
    if (full() || site >= allowed_.size() || !allowed_[site]) return;
    const std::uint32_t count = count_ + prepared_.weight(site);
    if (count > wanted_) return;
    if (!types_.leaveRoom(prepared_.typeOf(site), prepared_.weight(site), wanted_ - count)) return;
    for (std::uint32_t other : sites_)
      if (prepared_.conflict(other, site, rules_.minDistance)) return;
    take(site);
  }
  bool full() const { return count_ >= wanted_; }
  /// Pinned luminaires on their sites, the others on the sites that were taken, in order.
  std::vector<std::uint32_t> sites() const {
    std::vector<std::uint32_t> result;
    std::size_t pinned = 0;
    for (std::uint32_t i = 0; i < rules_.pinned.size(); ++i) pinned += isPinned(rules_, i);
    for (std::size_t next = pinned; result.size() < sites_.size();)
      if (const auto i = static_cast<std::uint32_t>(result.size()); isPinned(rules_, i))
        result.push_back(rules_.pinned[i]);
      else if (next < sites_.size())
        result.push_back(sites_[next++]);
      else  // too few for its luminaires: only their number counts
        return sites_;
    return result;
  }

 private:
  void take(std::uint32_t site) {
    sites_.push_back(site);
    count_ += prepared_.weight(site);
    types_.add(prepared_.typeOf(site), static_cast<int>(prepared_.weight(site)));
  }

  const PreparedScene& prepared_;
  const LuminaireRules& rules_;
  std::uint32_t wanted_, count_ = 0;  // luminaires
  TypeCounts types_;
  std::vector<char> allowed_;
  std::vector<std::uint32_t> sites_;
};

std::vector<std::uint32_t> evenOrder(const PreparedScene& prepared, const LuminaireRules& rules) {
  const std::uint64_t m = prepared.candidateCount(),
                      n = std::max<std::uint32_t>(rules.count / prepared.heaviest(), 1);
  std::vector<std::uint32_t> order;
  for (std::uint64_t i = 0; i < n; ++i)
    order.push_back(static_cast<std::uint32_t>((2 * i + 1) * m / (2 * n)));
  for (std::uint32_t site = 0; site < m; ++site) order.push_back(site);
  return order;
}

std::vector<std::uint32_t> shuffledOrder(std::uint32_t m, Random& random) {
  std::vector<std::uint32_t> order(m);
  for (std::uint32_t i = 0; i < m; ++i) order[i] = i;
  for (std::uint32_t i = m; i > 1; --i) std::swap(order[i - 1], order[random.below(i)]);
  return order;
}

std::vector<std::uint32_t> packed(const PreparedScene& prepared, const LuminaireRules& rules,
                                  const std::vector<std::uint32_t>& order, std::uint32_t wanted) {
  Packer packer(prepared, rules, wanted);
  for (std::uint32_t site : order) packer.offer(site);
  return packer.sites();
}

/// The smallest layout.
std::vector<std::uint32_t> packed(const PreparedScene& prepared, const LuminaireRules& rules,
                                  const std::vector<std::uint32_t>& order) {
  return packed(prepared, rules, order, rules.count);
}

bool isComplete(const PreparedScene& prepared, const LuminaireRules& rules,
                const std::vector<std::uint32_t>& sites) {
  TypeCounts types(prepared.scene(), rules);
  for (const std::uint32_t site : sites)
    types.add(prepared.typeOf(site), static_cast<int>(prepared.weight(site)));
  return luminairesIn(prepared, sites) >= rules.count && types.areMet();
}

}  // namespace

std::uint32_t luminairesIn(const PreparedScene& prepared, const std::vector<std::uint32_t>& sites) {
  std::uint32_t count = 0;
  for (const std::uint32_t site : sites) count += prepared.weight(site);
  return count;
}

std::vector<std::uint32_t> packSites(const PreparedScene& prepared, const LuminaireRules& rules) {
  const std::uint32_t m = prepared.candidateCount();
  std::vector<std::uint32_t> best = packed(prepared, rules, evenOrder(prepared, rules));
  const auto consider = [&](const std::vector<std::uint32_t>& order) {
    if (isComplete(prepared, rules, best)) return;
    std::vector<std::uint32_t> sites = packed(prepared, rules, order);
    if (luminairesIn(prepared, sites) > luminairesIn(prepared, best)) best = std::move(sites);
  };
  // Rows from each corner pack a grid tightly; random orders serve everything else.
  for (const Vec3 corner : {Vec3{1, 1e-3, 1e-6}, {-1, 1e-3, 1e-6}, {1e-6, 1e-3, 1}, {1e-6, 1e-3, -1}}) {
    if (prepared.isTied()) break;
    std::vector<std::uint32_t> order(m);
    for (std::uint32_t i = 0; i < m; ++i) order[i] = i;
    std::stable_sort(order.begin(), order.end(), [&](std::uint32_t a, std::uint32_t b) {
      return dot(corner, prepared.scene().sites[a].position) <
             dot(corner, prepared.scene().sites[b].position);
    });
    consider(order);
  }
  Random random(0x5eed);
  for (int attempt = 0; attempt < 200; ++attempt) consider(shuffledOrder(m, random));
  return best;
}

std::vector<std::uint32_t> spreadSites(const PreparedScene& prepared, const LuminaireRules& rules) {
  std::vector<std::uint32_t> sites = packed(prepared, rules, evenOrder(prepared, rules));
  return isComplete(prepared, rules, sites) ? sites : packSites(prepared, rules);
}

std::vector<std::uint32_t> randomSites(const PreparedScene& prepared, const LuminaireRules& rules,
                                       Random& random) {
  for (int attempt = 0; attempt < 20; ++attempt) {
    const std::uint32_t more = countVaries(rules) ? random.below(rules.countHigh - rules.count + 1) : 0;
    std::vector<std::uint32_t> sites =
        packed(prepared, rules, shuffledOrder(prepared.candidateCount(), random), rules.count + more);
    if (isComplete(prepared, rules, sites)) return sites;
  }
  return packSites(prepared, rules);
}

std::vector<std::uint32_t> fittedSites(const PreparedScene& prepared, const LuminaireRules& rules,
                                       const std::vector<std::uint32_t>& given) {
  std::vector<std::uint32_t> order = given;
  const std::vector<std::uint32_t> rest = evenOrder(prepared, rules);
  order.insert(order.end(), rest.begin(), rest.end());
  const std::uint32_t wanted = std::clamp(luminairesIn(prepared, given), rules.count, mostOf(rules));
  std::vector<std::uint32_t> sites = packed(prepared, rules, order, wanted);
  return isComplete(prepared, rules, sites) ? sites : packSites(prepared, rules);
}

std::vector<std::uint32_t> pinsAsIn(const LuminaireRules& rules, const std::vector<std::uint32_t>& given) {
  std::vector<std::uint32_t> pins(mostOf(rules), kNone), left;
  for (std::uint32_t site : rules.pinned) {
    if (site == kNone) continue;
    const auto at = std::find(given.begin(), given.end(), site);
    const auto i = static_cast<std::size_t>(at - given.begin());
    if (at != given.end() && i < pins.size())
      pins[i] = site;
    else
      left.push_back(site);
  }
  for (std::uint32_t site : left) {
    const auto free = std::find(pins.begin(), pins.end(), kNone);
    if (free != pins.end()) *free = site;
  }
  return pins;
}

}  // namespace fiatlux
