// Start layouts under pins, exclusions and distances; see start_layout.h.
#include "core/search/start_layout.h"

#include <algorithm>

namespace fiatlux {
namespace {

/// Fills a layout site by site, pinned ones first, refusing those that the rules forbid.
class Packer {
 public:
  Packer(const PreparedScene& prepared, const LuminaireRules& rules)
      : prepared_(prepared), rules_(rules), allowed_(prepared.siteCount(), 1) {
    for (std::uint32_t site : rules.excluded) allowed_[site] = 0;
    for (std::uint32_t site : rules.pinned)
      if (site != kNone) sites_.push_back(site);
  }

  void offer(std::uint32_t site) {
    if (full() || site >= allowed_.size() || !allowed_[site]) return;
    for (std::uint32_t other : sites_)
      if (other == site || prepared_.distance(other, site) < rules_.minDistance) return;
    sites_.push_back(site);
  }
  bool full() const { return sites_.size() >= rules_.count; }
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
  const PreparedScene& prepared_;
  const LuminaireRules& rules_;
  std::vector<char> allowed_;
  std::vector<std::uint32_t> sites_;
};

std::vector<std::uint32_t> evenOrder(const PreparedScene& prepared, const LuminaireRules& rules) {
  const std::uint64_t m = prepared.siteCount(), n = std::max<std::uint32_t>(rules.count, 1);
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
                                  const std::vector<std::uint32_t>& order) {
  Packer packer(prepared, rules);
  for (std::uint32_t site : order) packer.offer(site);
  return packer.sites();
}

}  // namespace

std::vector<std::uint32_t> packSites(const PreparedScene& prepared, const LuminaireRules& rules) {
  const std::uint32_t m = prepared.siteCount();
  std::vector<std::uint32_t> best = packed(prepared, rules, evenOrder(prepared, rules));
  const auto consider = [&](const std::vector<std::uint32_t>& order) {
    if (best.size() >= rules.count) return;
    std::vector<std::uint32_t> sites = packed(prepared, rules, order);
    if (sites.size() > best.size()) best = std::move(sites);
  };
  // Rows from each corner pack a grid tightly; random orders serve everything else.
  for (const Vec3 corner : {Vec3{1, 1e-3, 1e-6}, {-1, 1e-3, 1e-6}, {1e-6, 1e-3, 1}, {1e-6, 1e-3, -1}}) {
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
  return sites.size() == rules.count ? sites : packSites(prepared, rules);
}

std::vector<std::uint32_t> randomSites(const PreparedScene& prepared, const LuminaireRules& rules,
                                       Random& random) {
  for (int attempt = 0; attempt < 20; ++attempt) {
    std::vector<std::uint32_t> sites = packed(prepared, rules, shuffledOrder(prepared.siteCount(), random));
    if (sites.size() == rules.count) return sites;
  }
  return packSites(prepared, rules);
}

std::vector<std::uint32_t> fittedSites(const PreparedScene& prepared, const LuminaireRules& rules,
                                       const std::vector<std::uint32_t>& given) {
  std::vector<std::uint32_t> order = given;
  const std::vector<std::uint32_t> rest = evenOrder(prepared, rules);
  order.insert(order.end(), rest.begin(), rest.end());
  std::vector<std::uint32_t> sites = packed(prepared, rules, order);
  return sites.size() == rules.count ? sites : packSites(prepared, rules);
}

std::vector<std::uint32_t> pinsAsIn(const LuminaireRules& rules, const std::vector<std::uint32_t>& given) {
  std::vector<std::uint32_t> pins(rules.count, kNone), left;
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
