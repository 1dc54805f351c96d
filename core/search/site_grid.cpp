// Coordinates of sites; see site_grid.h.
#include "core/search/site_grid.h"

#include <algorithm>
#include <cmath>

namespace fiatlux {
namespace {

constexpr double kSame = 2e-3;  // m: coordinates that are one

/// The grid of a site's mount: two directions in its plane, and across it.
struct Frame {
  Vec3 along[2], normal;
};

/// `a` or its opposite: whichever points to +x, else to +z, else up.
Vec3 pointingOn(const Vec3& a) {
  for (const double part : {a.x, a.z, a.y})
    if (std::fabs(part) > 1e-6) return part > 0 ? a : -a;
  return a;
}

Frame frameOf(const Site& site) {
  const Vec3 u = pointingOn(site.axis), v = pointingOn(cross(site.normal, site.axis));
  // note: of a grid at 45 degrees both are as far along x; the axis of the site decides.
  const bool swapped = std::fabs(v.x) > std::fabs(u.x) + 1e-9;
  return {{swapped ? v : u, swapped ? u : v}, site.normal};
}

bool isSame(const Frame& a, const Frame& b) {
  return length(a.normal - b.normal) < 1e-3 && length(a.along[0] - b.along[0]) < 1e-3;
}

std::vector<double> distinct(std::vector<double> values) {
  std::sort(values.begin(), values.end());
  std::vector<double> result;
  for (const double value : values)
    if (result.empty() || value > result.back() + kSame) result.push_back(value);
  return result;
}

/// The index of the entry within kSame of a value, or kNone.
std::uint32_t indexIn(const std::vector<double>& sorted, double value) {
  const auto at = std::lower_bound(sorted.begin(), sorted.end(), value - kSame);
  return at != sorted.end() && *at <= value + kSame ? static_cast<std::uint32_t>(at - sorted.begin()) : kNone;
}

}  // namespace

SiteGrid::SiteGrid(const Scene& scene) {
  std::vector<Frame> frames;
  std::vector<std::uint32_t> frameOfSite;
  for (const Site& site : scene.sites) {
    const Frame frame = frameOf(site);
    std::uint32_t f = 0;
    while (f < frames.size() && !isSame(frames[f], frame)) ++f;
    if (f == frames.size()) frames.push_back(frame);
    frameOfSite.push_back(f);
  }
  const auto coordinate = [&](std::uint32_t site, const Vec3& direction) {
    return dot(scene.sites[site].position, direction);
  };
  const auto count = static_cast<std::uint32_t>(scene.sites.size());
  for (int d = 0; d < 2; ++d) {
    for (std::uint32_t j = 0; j < count; ++j)
      values_[d].push_back(coordinate(j, frames[frameOfSite[j]].along[d]));
    values_[d] = distinct(std::move(values_[d]));
  }
  // Planes: those of one frame by their heights, frame after frame, and of each one a layer for every way in
  // which luminaires of types may hang there.
  std::uint32_t ways = 1;
  for (const Hanging& hanging : scene.hangings) ways = std::max(ways, hanging.way + 1);
  const auto wayOf = [&](std::uint32_t site) {
    return scene.hangings.empty() ? 0 : scene.hangings[site].way;
  };
  std::vector<std::vector<double>> heights(frames.size());
  for (std::uint32_t j = 0; j < count; ++j)
    heights[frameOfSite[j]].push_back(coordinate(j, frames[frameOfSite[j]].normal));
  const auto most = std::max_element(heights.begin(), heights.end(),
                                     [](const auto& a, const auto& b) { return a.size() < b.size(); });
  const auto main = static_cast<std::size_t>(most - heights.begin());
  std::vector<std::uint32_t> firstPlane;
  for (std::size_t f = 0; f < frames.size(); ++f) {
    heights[f] = distinct(std::move(heights[f]));
    firstPlane.push_back(planeCount());
    squares_.insert(squares_.end(), heights[f].size() * ways,
                    length(frames[f].along[0] - frames[main].along[0]) < 1e-3);
  }
  for (std::uint32_t j = 0; j < count; ++j) {
    const std::uint32_t f = frameOfSite[j];
    const Frame& frame = frames[f];
    cells_.push_back({indexIn(values_[0], coordinate(j, frame.along[0])),
                      indexIn(values_[1], coordinate(j, frame.along[1])),
                      firstPlane[f] + ways * indexIn(heights[f], coordinate(j, frame.normal)) + wayOf(j)});
    siteOfCell_.emplace(keyOf(cells_.back()), j);
  }
}

std::uint32_t SiteGrid::indexOf(int direction, double value) const {
  return indexIn(values_[direction], value);
}

Chains::Chains(const SiteGrid& grid, int direction)
    : values_(grid.values(direction)),
      longest_(static_cast<std::uint32_t>(std::min<std::size_t>(values_.size(), 2))) {
  const auto n = static_cast<std::uint32_t>(values_.size());
  for (std::uint32_t first = 0; first < n; ++first)
    for (std::uint32_t second = first + 1; second < n; ++second) {
      const double pitch = values_[second] - values_[first];
      std::uint32_t next = grid.indexOf(direction, values_[first] + 2 * pitch);
      if (next == kNone) continue;
      Chain chain{{first, second}, pitch};
      while (next != kNone) {
        chain.at.push_back(next);
        next = grid.indexOf(direction, values_[first] + static_cast<double>(chain.at.size()) * pitch);
      }
      longest_ = std::max(longest_, static_cast<std::uint32_t>(chain.at.size()));
      long_.push_back(std::move(chain));
    }
}

std::vector<Chain> Chains::of(std::uint32_t count) const {
  const auto n = static_cast<std::uint32_t>(values_.size());
  std::vector<Chain> result;
  if (count == 1) {
    for (std::uint32_t only = 0; only < n; ++only) result.push_back({{only}, 0});
  } else if (count == 2) {
    for (std::uint32_t first = 0; first < n; ++first)
      for (std::uint32_t second = first + 1; second < n; ++second)
        result.push_back({{first, second}, values_[second] - values_[first]});
  } else {
    for (const Chain& chain : long_)
      if (chain.at.size() >= count)
        result.push_back({{chain.at.begin(), chain.at.begin() + count}, chain.pitch});
  }
  return result;
}

}  // namespace fiatlux
