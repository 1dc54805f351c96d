// A small made-up scene for tests of files and searches: a corridor's floor and wall under a row of sites,
// with light that falls off as from small Lambertian lamps and a little noise as from rays. No radiosity in
// it.
#pragma once

#include <algorithm>
#include <cmath>

#include "core/base/random.h"
#include "core/scene/scene.h"

namespace fiatlux {

/// Area-weighted mean row and covariance of rho x responses on one surface, from the patches, in double.
inline SurfaceStatistics statisticsOf(const Scene& scene, std::uint32_t surface, bool exitance) {
  const std::size_t m = scene.sites.size();
  SurfaceStatistics result{std::vector<double>(m), std::vector<double>(m * m)};
  double area = 0;
  const auto value = [&](std::uint32_t p, std::size_t j) {
    return (exitance ? double{scene.patches.reflectance[p]} : 1.0) *
           scene.responses.column(static_cast<std::uint32_t>(j))[p];
  };
  for (std::uint32_t p = 0; p < scene.patches.rows(); ++p) {
    if (scene.patches.surface[p] != surface || !scene.patches.counts(p)) continue;
    area += scene.patches.area[p];
    for (std::size_t j = 0; j < m; ++j) result.mean[j] += scene.patches.area[p] * value(p, j);
  }
  for (double& v : result.mean) v /= area;
  for (std::uint32_t p = 0; p < scene.patches.rows(); ++p) {
    if (scene.patches.surface[p] != surface || !scene.patches.counts(p)) continue;
    for (std::size_t i = 0; i < m; ++i)
      for (std::size_t j = 0; j < m; ++j)
        result.covariance[i * m + j] +=
            scene.patches.area[p] / area * (value(p, i) - result.mean[i]) * (value(p, j) - result.mean[j]);
  }
  return result;
}

/// A grid of columns x rows square patches of `edge` metres, appended as one surface.
inline void addGrid(Scene& scene, const char* name, const Vec3& origin, const Vec3& u, const Vec3& v,
                    std::uint32_t columns, std::uint32_t rows, double edge, float reflectance,
                    bool measuring) {
  Patches& patches = scene.patches;
  const std::uint32_t first = patches.rows();
  const auto surface = static_cast<std::uint32_t>(scene.surfaces.size());
  for (std::uint32_t row = 0; row < rows; ++row)
    for (std::uint32_t column = 0; column < columns; ++column) {
      patches.center.push_back(origin + ((column + 0.5) * edge) * u + ((row + 0.5) * edge) * v);
      patches.normal.push_back(cross(u, v));
      patches.area.push_back(edge * edge);
      patches.reflectance.push_back(measuring ? 0 : reflectance);
      patches.surface.push_back(surface);
      if (!measuring)
        patches.cluster.push_back(patches.clusterCount + (row / 4) * ((columns + 3) / 4) + column / 4);
      const std::uint32_t p = first + row * columns + column;
      patches.left.push_back(column > 0 ? p - 1 : kNone);
      patches.up.push_back(row > 0 ? p - columns : kNone);
    }
  if (!measuring) {
    patches.count = patches.rows();
    patches.clusterCount += ((rows + 3) / 4) * ((columns + 3) / 4);
  }
  Surface description;
  description.name = name;
  description.area = columns * rows * edge * edge;
  description.reflectance = measuring ? 0 : reflectance;
  description.patches = columns * rows;
  description.measuring = measuring;
  scene.surfaces.push_back(description);
}

/// Means and covariances of every surface, from the patches that count.
inline void setStatistics(Scene& scene) {
  scene.illuminance.clear(), scene.exitance.clear();
  for (std::uint32_t s = 0; s < scene.surfaces.size(); ++s) {
    scene.illuminance.push_back(statisticsOf(scene, s, false));
    scene.exitance.push_back(scene.surfaces[s].measuring ? SurfaceStatistics{}
                                                         : statisticsOf(scene, s, true));
  }
}

/// Floor and wall of `cells` x 8 patches of 0.25 m under `sites` sites 3 m up, and a measuring plane.
inline Scene syntheticScene(std::uint32_t cells, std::uint32_t sites, double noise = 0.005) {
  Scene scene;
  scene.identity = "0123456789abcdef";
  const double edge = 0.25, length = cells * edge;
  addGrid(scene, "floor", {0, 0, 0}, {0, 0, 1}, {1, 0, 0}, 8, cells, edge, 0.3f, false);
  addGrid(scene, "wall \xc3\xa9", {0, 0, 0}, {1, 0, 0}, {0, 1, 0}, cells, 12, edge, 0.5f, false);
  addGrid(scene, "desk plane", {0, 0.75, 0}, {0, 0, 1}, {1, 0, 0}, 4, cells / 2, edge, 0, true);
  for (std::uint32_t j = 0; j < sites; ++j)
    scene.sites.push_back({{length * (j + 0.5) / sites, 3, 1}, {0, -1, 0}, {1, 0, 0}, 0.5});
  Random random(7);
  scene.responses.rows = scene.patches.rows();
  scene.responses.sites = sites;
  for (const Site& site : scene.sites)
    for (std::uint32_t p = 0; p < scene.patches.rows(); ++p) {
      const Vec3 way = scene.patches.center[p] - site.position;
      const double d2 = dot(way, way) + 0.05;
      const double cosines =
          std::max(0.0, dot(way, site.normal)) * std::max(0.0, -dot(way, scene.patches.normal[p]));
      const double light = cosines / (3.14159265 * d2 * d2) + 0.01 / (1 + d2);
      scene.responses.illuminance.push_back(
          static_cast<float>(light * (1 + noise * (2 * random.unit() - 1))));
    }
  // A poster of another reflectance on the wall, so that exitance needs statistics of its own there.
  double sum = 0;
  for (std::uint32_t p = 0; p < scene.patches.count; ++p) {
    if (scene.patches.surface[p] != 1) continue;
    if (p % 5 == 0) scene.patches.reflectance[p] = 0.1f;
    sum += scene.patches.reflectance[p] * scene.patches.area[p];
  }
  scene.surfaces[1].reflectance = sum / scene.surfaces[1].area;
  scene.errorBound.assign(scene.surfaces.size(), 0);
  setStatistics(scene);
  return scene;
}

}  // namespace fiatlux
