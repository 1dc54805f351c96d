#include "core/transport/group_interpolation.h"

#include <algorithm>
#include <cmath>

#include "core/transport/column_block.h"

namespace fiatlux {
namespace {

/// Of the trace of the normal equations, added to their diagonal: where all neighbours lie on one line, the
/// gradient across it is zero, and rounding cannot make it anything else.
constexpr double kRegular = 1e-3;

/// row += value + alongU u + alongV v, of columns that do not overlap.
template <class Width>
void interpolate(const float* __restrict value, float alongU, const float* __restrict u, float alongV,
                 const float* __restrict v, float* __restrict row, Width width) {
  for (std::uint32_t j = 0; j < width; ++j) row[j] += value[j] + alongU * u[j] + alongV * v[j];
}

}  // namespace

GroupInterpolation::GroupInterpolation(const Patches& patches, const ExchangeGroups& groups)
    : total_(groups.total), group_(groups.ofRow) {
  measure(patches);
  place(patches);
  link(patches, groups);
}

void GroupInterpolation::measure(const Patches& patches) {
  area_.assign(total_, 0);
  tangents_.assign(total_, {});
  std::vector<Vec3> normal(total_);
  for (std::uint32_t p = 0; p < patches.rows(); ++p) {
    const std::uint32_t c = group_[p];
    area_[c] += patches.area[p];
    tangents_[c].center += patches.area[p] * patches.center[p];
    normal[c] += patches.area[p] * patches.normal[p];
  }
  for (std::uint32_t c = 0; c < total_; ++c) {
    Tangents& t = tangents_[c];
    t.center = (1 / area_[c]) * t.center;
    const Vec3 n = normalized(normal[c]);
    // The world axis that lies nearest to the plane.
    const Vec3 axis = std::abs(n.x) <= std::abs(n.y) && std::abs(n.x) <= std::abs(n.z) ? Vec3{1, 0, 0}
                      : std::abs(n.y) <= std::abs(n.z)                                 ? Vec3{0, 1, 0}
                                                                                       : Vec3{0, 0, 1};
    t.u = normalized(axis - dot(axis, n) * n);
    t.v = cross(n, t.u);
  }
}

void GroupInterpolation::place(const Patches& patches) {
  for (std::uint32_t p = 0; p < patches.rows(); ++p) {
    const Tangents& t = tangents_[group_[p]];
    const Vec3 d = patches.center[p] - t.center;
    share_.push_back(static_cast<float>(patches.area[p] / area_[group_[p]]));
    alongU_.push_back(static_cast<float>(dot(d, t.u)));
    alongV_.push_back(static_cast<float>(dot(d, t.v)));
  }
}

void GroupInterpolation::link(const Patches& patches, const ExchangeGroups& groups) {
  // One link, both ways, for each pair of cells side by side with nothing between.
  std::vector<Link> links;
  for (std::uint32_t p = 0; p < patches.rows(); ++p) {
    const auto add = [&](std::uint32_t q, std::uint8_t barrier) {
      if (q == kNone || groups.barriers[p] & barrier || group_[p] == group_[q]) return;
      links.push_back({group_[p], group_[q]});
      links.push_back({group_[q], group_[p]});
    };
    add(patches.left[p], ExchangeGroups::kLeftBarrier);
    add(patches.up[p], ExchangeGroups::kUpBarrier);
  }
  std::sort(links.begin(), links.end(),
            [](const Link& a, const Link& b) { return a.from != b.from ? a.from < b.from : a.to < b.to; });
  offset_.assign(1, 0);
  const Link* next = links.data();
  const Link* end = next + links.size();
  for (std::uint32_t c = 0; c < total_; ++c) {
    const Link* first = next;
    while (next != end && next->from == c) ++next;
    fit(c, first, next);
    offset_.push_back(static_cast<std::uint32_t>(neighbours_.size()));
  }
}

void GroupInterpolation::fit(std::uint32_t group, const Link* first, const Link* last) {
  // Least squares through the group's own value: sum of w (h_n - h - g . d)^2, w = how many cells touch.
  const Tangents& t = tangents_[group];
  const std::size_t begin = neighbours_.size();
  double uu = 0, uv = 0, vv = 0;
  while (first != last) {
    const Link* same = first;
    while (first != last && *first == *same) ++first;
    const auto weight = static_cast<double>(first - same);
    const Vec3 d = tangents_[same->to].center - t.center;
    const double u = dot(d, t.u), v = dot(d, t.v);
    uu += weight * u * u, uv += weight * u * v, vv += weight * v * v;
    neighbours_.push_back({same->to, static_cast<float>(weight * u), static_cast<float>(weight * v)});
  }
  const double extra = kRegular * (uu + vv);
  uu += extra, vv += extra;
  const double determinant = uu * vv - uv * uv;
  for (std::size_t i = begin; i < neighbours_.size(); ++i) {
    Neighbour& n = neighbours_[i];
    const double u = n.u, v = n.v;
    n.u = determinant > 0 ? static_cast<float>((vv * u - uv * v) / determinant) : 0;
    n.v = determinant > 0 ? static_cast<float>((uu * v - uv * u) / determinant) : 0;
  }
}

void GroupInterpolation::gradients(const float* values, std::uint32_t width, std::vector<float>& u,
                                   std::vector<float>& v) const {
  u.assign(std::size_t{total_} * width, 0.0f);
  v.assign(std::size_t{total_} * width, 0.0f);
  for (std::uint32_t c = 0; c < total_; ++c) {
    const float* own = values + std::size_t{c} * width;
    float *gu = &u[std::size_t{c} * width], *gv = &v[std::size_t{c} * width];
    for (std::uint32_t i = offset_[c]; i < offset_[c + 1]; ++i) {
      const Neighbour& n = neighbours_[i];
      const float* other = values + std::size_t{n.group} * width;
      for (std::uint32_t j = 0; j < width; ++j) {
        gu[j] += n.u * (other[j] - own[j]);
        gv[j] += n.v * (other[j] - own[j]);
      }
    }
  }
}

void GroupInterpolation::apply(const float* values, std::uint32_t width, float* rows) const {
  std::fill(rows, rows + group_.size() * width, 0.0f);
  add(values, width, rows);
}

void GroupInterpolation::add(const float* values, std::uint32_t width, float* rows) const {
  std::vector<float> u, v;
  gradients(values, width, u, v);
  withWidth(width, [&](auto fixed) {
    for (std::size_t p = 0; p < group_.size(); ++p) {
      const std::size_t at = std::size_t{group_[p]} * fixed;
      interpolate(values + at, alongU_[p], &u[at], alongV_[p], &v[at], rows + p * fixed, fixed);
    }
  });
}

void GroupInterpolation::reduce(const float* rows, std::uint32_t width, float* sums, float* values) const {
  const std::size_t size = std::size_t{total_} * width;
  std::vector<float> u(size, 0.0f), v(size, 0.0f);
  std::fill(sums, sums + size, 0.0f);
  withWidth(width, [&](auto fixed) {
    for (std::size_t p = 0; p < group_.size(); ++p) {
      const std::size_t at = std::size_t{group_[p]} * fixed;
      const float* row = rows + p * fixed;
      addScaled(sums + at, 1.0f, row, fixed);
      addScaled(&u[at], alongU_[p], row, fixed);
      addScaled(&v[at], alongV_[p], row, fixed);
    }
  });
  std::copy(sums, sums + size, values);
  for (std::uint32_t c = 0; c < total_; ++c) {
    for (std::uint32_t i = offset_[c]; i < offset_[c + 1]; ++i) {
      const Neighbour& n = neighbours_[i];
      float *own = values + std::size_t{c} * width, *other = values + std::size_t{n.group} * width;
      for (std::uint32_t j = 0; j < width; ++j) {
        const float moved = n.u * u[std::size_t{c} * width + j] + n.v * v[std::size_t{c} * width + j];
        other[j] += moved;
        own[j] -= moved;
      }
    }
  }
}

void GroupInterpolation::takeEven(const float* sums, std::uint32_t width, std::vector<float>& lumens) const {
  withWidth(width, [&](auto fixed) {
    for (std::size_t p = 0; p < lumens.size() / fixed; ++p)
      addScaled(&lumens[p * fixed], -share_[p], sums + std::size_t{group_[p]} * fixed, fixed);
  });
}

void GroupInterpolation::means(const float* rows, std::uint32_t width, float* means) const {
  std::vector<double> sums(std::size_t{total_} * width, 0.0);
  for (std::size_t p = 0; p < group_.size(); ++p)
    for (std::uint32_t j = 0; j < width; ++j)
      sums[std::size_t{group_[p]} * width + j] += double{share_[p]} * rows[p * width + j];
  std::copy(sums.begin(), sums.end(), means);
}

}  // namespace fiatlux
