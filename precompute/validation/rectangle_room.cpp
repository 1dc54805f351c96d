#include "precompute/validation/rectangle_room.h"

#include <algorithm>
#include <cassert>
#include <cmath>

namespace fiatlux {

namespace {

Chart chartOf(const RectangleSurface& s, std::uint32_t surface) {
  Chart chart;
  chart.surface = surface;
  chart.origin = s.corner;
  chart.uAxis = normalized(s.u);
  chart.vAxis = normalized(s.v);
  chart.normal = normalized(cross(s.u, s.v));
  chart.columns = s.columns;
  chart.rows = s.rows;
  chart.cellU = length(s.u) / s.columns;
  chart.cellV = length(s.v) / s.rows;
  return chart;
}

/// One cell of the chart that comes next in the room: a patch of two triangles. Cells come row by row.
void addCell(Room& room, const RectangleSurface& s, Chart& chart, std::uint32_t row, std::uint32_t column) {
  Patches& patches = room.patches;
  const std::uint32_t p = patches.rows();
  const Vec3 du = (1.0 / s.columns) * s.u, dv = (1.0 / s.rows) * s.v;
  const Vec3 a = s.corner + column * du + row * dv;
  chart.patchOfCell.push_back(p);
  patches.center.push_back(a + 0.5 * (du + dv));
  patches.normal.push_back(chart.normal);
  patches.area.push_back(chart.cellU * chart.cellV);
  patches.reflectance.push_back(s.measuring ? 0.0f : static_cast<float>(s.reflectance));
  patches.surface.push_back(chart.surface);
  patches.left.push_back(column > 0 ? p - 1 : kNone);
  patches.up.push_back(row > 0 ? p - s.columns : kNone);
  room.chartOfPatch.push_back(static_cast<std::uint32_t>(room.charts.size()));
  room.fragments.push_back({{a, a + du, a + du + dv}});
  room.fragments.push_back({{a, a + du + dv, a + dv}});
  room.fragmentOffset.push_back(static_cast<std::uint32_t>(room.fragments.size()));
}

/// What rays meet: the rectangle as two triangles.
void addTriangles(Room& room, const RectangleSurface& s) {
  const auto corner = static_cast<std::uint32_t>(room.positions.size());
  const auto chart = static_cast<std::uint32_t>(room.charts.size());
  room.positions.insert(room.positions.end(),
                        {s.corner, s.corner + s.u, s.corner + s.u + s.v, s.corner + s.v});
  room.triangles.push_back({{corner, corner + 1, corner + 2}, chart, kNone});
  room.triangles.push_back({{corner, corner + 2, corner + 3}, chart, kNone});
}

void addChart(Room& room, const RectangleSurface& s, std::uint32_t surface, std::uint32_t cluster) {
  assert(s.columns > 0 && s.rows > 0 && cluster > 0);
  assert(std::abs(dot(s.u, s.v)) <= 1e-9 * length(s.u) * length(s.v));
  Chart chart = chartOf(s, surface);
  Patches& patches = room.patches;
  const std::uint32_t clusterColumns = (s.columns + cluster - 1) / cluster;
  for (std::uint32_t row = 0; row < s.rows; ++row) {
    for (std::uint32_t column = 0; column < s.columns; ++column) {
      addCell(room, s, chart, row, column);
      if (!s.measuring)
        patches.cluster.push_back(patches.clusterCount + row / cluster * clusterColumns + column / cluster);
    }
  }
  if (!s.measuring) {
    patches.count = patches.rows();
    patches.clusterCount += clusterColumns * ((s.rows + cluster - 1) / cluster);
    addTriangles(room, s);
  }
  room.surfaces.push_back({s.name, length(s.u) * length(s.v), s.measuring ? 0 : s.reflectance,
                           s.columns * s.rows, s.measuring, 0});
  room.charts.push_back(std::move(chart));
}

std::uint32_t cells(double edge, double patch) {
  return std::max(1u, static_cast<std::uint32_t>(std::lround(edge / patch)));
}

RectangleSurface face(const std::string& name, const Vec3& corner, const Vec3& u, const Vec3& v,
                      double reflectance, double patch) {
  return {name, corner, u, v, reflectance, cells(length(u), patch), cells(length(v), patch), false};
}

}  // namespace

Room rectangleRoom(const std::vector<RectangleSurface>& surfaces, std::uint32_t cluster) {
  Room room;
  room.fragmentOffset.push_back(0);
  for (const bool measuring : {false, true}) {
    for (const RectangleSurface& s : surfaces) {
      if (s.measuring == measuring)
        addChart(room, s, static_cast<std::uint32_t>(room.surfaces.size()), cluster);
    }
  }
  double edge = 0;
  for (const Chart& chart : room.charts) edge += std::sqrt(chart.cellU * chart.cellV);
  room.patchSize = edge / static_cast<double>(room.charts.size());
  return room;
}

std::vector<RectangleSurface> boxSurfaces(const Vec3& c, const Vec3& s, double reflectance, double patch) {
  const Vec3 x{s.x, 0, 0}, y{0, s.y, 0}, z{0, 0, s.z};
  return {face("floor", c, z, x, reflectance, patch),   face("ceiling", c + y, x, z, reflectance, patch),
          face("wall -x", c, y, z, reflectance, patch), face("wall +x", c + x, z, y, reflectance, patch),
          face("wall -z", c, x, y, reflectance, patch), face("wall +z", c + z, y, x, reflectance, patch)};
}

std::vector<RectangleSurface> blockSurfaces(const std::string& name, const Vec3& corner, const Vec3& size,
                                            double reflectance, double patch) {
  std::vector<RectangleSurface> faces = boxSurfaces(corner, size, reflectance, patch);
  for (RectangleSurface& f : faces) {
    f.name = name + "/" + f.name;
    std::swap(f.u, f.v);
    std::swap(f.columns, f.rows);
  }
  return faces;
}

std::vector<Site> siteGrid(const RectangleSurface& mount, std::uint32_t columns, std::uint32_t rows,
                           double size) {
  assert(columns > 0 && rows > 0 && size > 0);
  std::vector<Site> sites;
  for (std::uint32_t row = 0; row < rows; ++row) {
    for (std::uint32_t column = 0; column < columns; ++column) {
      Site site;
      site.position = mount.corner + ((column + 0.5) / columns) * mount.u + ((row + 0.5) / rows) * mount.v;
      site.normal = normalized(cross(mount.u, mount.v));
      site.axis = normalized(mount.u);
      site.size = size;
      sites.push_back(site);
    }
  }
  return sites;
}

}  // namespace fiatlux
