#include "precompute/geometry/box_cut.h"

#include <algorithm>

namespace fiatlux {
namespace {

constexpr double Vec3::*kAxes[] = {&Vec3::x, &Vec3::y, &Vec3::z};

template <std::size_t N>
std::array<float, N> mixed(const std::array<float, N>& a, const std::array<float, N>& b, double share) {
  std::array<float, N> result{};
  for (std::size_t i = 0; i < N; ++i) result[i] = static_cast<float>((1 - share) * a[i] + share * b[i]);
  return result;
}

bool holds(const Bounds& box, const Vec3& p) {
  return std::all_of(std::begin(kAxes), std::end(kAxes), [&](double Vec3::*axis) {
    return p.*axis >= box.low.*axis && p.*axis <= box.high.*axis;
  });
}

}  // namespace

BoxCut::BoxCut(const SourceMesh& from) : from_(from) {
  mesh_.node = from.node, mesh_.nodeIndex = from.nodeIndex;
  mesh_.material = from.material, mesh_.extras = from.extras;
}

void BoxCut::add(const std::array<std::uint32_t, 3>& triangle, const Bounds& box) {
  if (std::all_of(triangle.begin(), triangle.end(),
                  [&](std::uint32_t v) { return holds(box, from_.positions[v]); })) {
    mesh_.triangles.push_back({kept(triangle[0]), kept(triangle[1]), kept(triangle[2])});
    return;
  }
  Polygon polygon{cornerOf(triangle[0]), cornerOf(triangle[1]), cornerOf(triangle[2])};
  for (double Vec3::*axis : kAxes) {
    polygon = cutAt(polygon, axis, -1, box.low.*axis);
    polygon = cutAt(polygon, axis, 1, box.high.*axis);
  }
  if (polygon.size() < 3) return;
  const auto first = static_cast<std::uint32_t>(mesh_.positions.size());
  for (const Corner& corner : polygon) append(corner);
  for (std::uint32_t i = 2; i < polygon.size(); ++i)
    mesh_.triangles.push_back({first, first + i - 1, first + i});
}

/// What of a convex polygon lies where sign * (value - limit) <= 0 (Sutherland and Hodgman 1974).
BoxCut::Polygon BoxCut::cutAt(const Polygon& polygon, double Vec3::*axis, double sign, double limit) {
  Polygon left;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Corner& a = polygon[(i + polygon.size() - 1) % polygon.size()];
    const Corner& b = polygon[i];
    const double from = sign * (a.position.*axis - limit), to = sign * (b.position.*axis - limit);
    if ((from > 0) != (to > 0)) {
      const double share = from / (from - to);
      left.push_back({(1 - share) * a.position + share * b.position, mixed(a.normal, b.normal, share),
                      mixed(a.uv, b.uv, share), mixed(a.color, b.color, share)});
    }
    if (to <= 0) left.push_back(b);
  }
  return left;
}

BoxCut::Corner BoxCut::cornerOf(std::uint32_t v) const {
  Corner corner{from_.positions[v]};
  if (!from_.normals.empty()) corner.normal = from_.normals[v];
  if (!from_.uv.empty()) corner.uv = from_.uv[v];
  if (!from_.colors.empty()) corner.color = from_.colors[v];
  return corner;
}

std::uint32_t BoxCut::kept(std::uint32_t v) {
  const auto [found, isFresh] = taken_.emplace(v, static_cast<std::uint32_t>(mesh_.positions.size()));
  if (isFresh) append(cornerOf(v));
  return found->second;
}

void BoxCut::append(const Corner& corner) {
  mesh_.positions.push_back(corner.position);
  if (!from_.normals.empty()) mesh_.normals.push_back(corner.normal);
  if (!from_.uv.empty()) mesh_.uv.push_back(corner.uv);
  if (!from_.colors.empty()) mesh_.colors.push_back(corner.color);
}

}  // namespace fiatlux
