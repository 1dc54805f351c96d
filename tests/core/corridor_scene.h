// Scenes for tests without geometry files: the cells of a floor plan become floor, ceiling and wall patches,
// luminaires hang under ceiling cells, and light bounces by point-to-point form factors with visibility in
// plan. Rough light, but real structure: responses, exact statistics and areas belong together as in a scene
// that was read from a file.
#pragma once

#include <cmath>
#include <cstdint>
#include <numbers>
#include <string>
#include <vector>

#include "core/scene/scene.h"

namespace fiatlux::testing {

/// A floor plan on a grid of cells; `inside` is row-major, depth rows (z) of width (x) cells.
struct Plan {
  int width = 0, depth = 0, height = 4;                // cells
  double cell = 0.75;                                  // m
  std::vector<char> inside;                            // width x depth
  int siteX0 = 0, siteX1 = 0, siteZ0 = 0, siteZ1 = 0;  // sites hang in [x0, x1) x [z0, z1)
  // The wall that is the surface "yellow wall": where it stands (facing z) and the cells that it spans.
  int yellowZ = -1, yellowX0 = 0, yellowX1 = 0;
  bool at(int x, int z) const { return x >= 0 && z >= 0 && x < width && z < depth && inside[z * width + x]; }
};

inline Plan boxPlan(int width, int depth, int height = 4) {
  Plan plan{width, depth, height, 0.75, std::vector<char>(static_cast<std::size_t>(width * depth), 1)};
  plan.siteX1 = width;
  plan.siteZ1 = depth;
  plan.yellowZ = depth;
  plan.yellowX1 = width;
  return plan;
}

/// Spine and three arms, with the proportions of the paper's E corridor; 258 sites under the spine.
inline Plan corridorPlan() {
  Plan plan{17, 43, 4, 0.75, std::vector<char>(17 * 43, 0)};
  const auto fill = [&](int x0, int x1, int z0, int z1) {
    for (int z = z0; z < z1; ++z)
      for (int x = x0; x < x1; ++x) plan.inside[static_cast<std::size_t>(z * plan.width + x)] = 1;
  };
  fill(0, 6, 0, 43);
  fill(6, 17, 0, 6);
  fill(6, 17, 19, 24);
  fill(6, 17, 37, 43);
  plan.siteX1 = 6;
  plan.siteZ1 = 43;
  plan.yellowZ = 24;
  plan.yellowX0 = 6;
  plan.yellowX1 = 17;
  return plan;
}

namespace detail {

inline bool sees(const Plan& plan, const Vec3& a, const Vec3& b) {
  const Vec3 d = b - a;
  const int steps = 1 + static_cast<int>(2 * std::sqrt(d.x * d.x + d.z * d.z) / plan.cell);
  for (int i = 1; i < steps; ++i) {
    const double f = static_cast<double>(i) / steps;
    const int x = static_cast<int>(std::floor((a.x + f * d.x) / plan.cell));
    const int z = static_cast<int>(std::floor((a.z + f * d.z) / plan.cell));
    if (!plan.at(x, z)) return false;
  }
  return true;
}

/// cos cos / (pi d^2 + area): of the light that leaves `a`, what arrives at `b` per m2.
inline double transfer(const Vec3& a, const Vec3& na, const Vec3& b, const Vec3& nb, double area) {
  const Vec3 d = b - a;
  const double square = dot(d, d);
  const double ca = dot(na, d), cb = -dot(nb, d);
  if (ca <= 0 || cb <= 0) return 0;
  return ca * cb / (square * (std::numbers::pi * square + area));
}

inline void addPatch(Scene& scene, const Vec3& center, const Vec3& normal, double area, float rho,
                     std::uint32_t surface) {
  scene.patches.center.push_back(center);
  scene.patches.normal.push_back(normal);
  scene.patches.area.push_back(area);
  scene.patches.reflectance.push_back(rho);
  scene.patches.surface.push_back(surface);
}

inline void addPatches(Scene& scene, const Plan& plan) {
  const double c = plan.cell, top = plan.height * c, area = c * c;
  scene.surfaces = {{"floor", 0, 0.3, 0, false, 0},
                    {"ceiling", 0, 0.7, 0, false, 0},
                    {"yellow wall", 0, 0.5, 0, false, 0},
                    {"walls", 0, 0.5, 0, false, 0}};
  for (int z = 0; z < plan.depth; ++z)
    for (int x = 0; x < plan.width; ++x) {
      if (!plan.at(x, z)) continue;
      const double px = (x + 0.5) * c, pz = (z + 0.5) * c;
      addPatch(scene, {px, 0, pz}, {0, 1, 0}, area, 0.3f, 0);
      addPatch(scene, {px, top, pz}, {0, -1, 0}, area, 0.7f, 1);
      for (int y = 0; y < plan.height; ++y) {
        const double py = (y + 0.5) * c;
        const bool yellow = plan.yellowZ == z + 1 && x >= plan.yellowX0 && x < plan.yellowX1;
        if (!plan.at(x - 1, z)) addPatch(scene, {x * c, py, pz}, {1, 0, 0}, area, 0.5f, 3);
        if (!plan.at(x + 1, z)) addPatch(scene, {(x + 1) * c, py, pz}, {-1, 0, 0}, area, 0.5f, 3);
        if (!plan.at(x, z - 1)) addPatch(scene, {px, py, z * c}, {0, 0, 1}, area, 0.5f, 3);
        if (!plan.at(x, z + 1))
          addPatch(scene, {px, py, (z + 1) * c}, {0, 0, -1}, area, 0.5f, yellow ? 2 : 3);
      }
    }
  scene.patches.count = scene.patches.rows();
  scene.patches.clusterCount = scene.patches.count;
  scene.patches.left.assign(scene.patches.count, kNone);
  scene.patches.up.assign(scene.patches.count, kNone);
  for (std::uint32_t p = 0; p < scene.patches.count; ++p) scene.patches.cluster.push_back(p);
  for (std::uint32_t p = 0; p < scene.patches.count; ++p) {
    Surface& surface = scene.surfaces[scene.patches.surface[p]];
    surface.area += scene.patches.area[p];
    ++surface.patches;
  }
}

inline void addSites(Scene& scene, const Plan& plan) {
  for (int z = plan.siteZ0; z < plan.siteZ1; ++z)
    for (int x = plan.siteX0; x < plan.siteX1; ++x)
      scene.sites.push_back({{(x + 0.5) * plan.cell, plan.height * plan.cell, (z + 0.5) * plan.cell},
                             {0, -1, 0},
                             {1, 0, 0},
                             plan.cell});
}

/// Direct light of every site, then `bounces` bounces of it.
inline void addResponses(Scene& scene, const Plan& plan, int bounces) {
  const std::size_t n = scene.patches.rows(), m = scene.sites.size();
  const auto inwards = [&](std::size_t p) {
    return scene.patches.center[p] + 0.01 * scene.patches.normal[p];
  };
  std::vector<float> form(n * n, 0.0f);
  for (std::size_t p = 0; p < n; ++p)
    for (std::size_t q = p + 1; q < n; ++q) {
      const double f = transfer(inwards(p), scene.patches.normal[p], inwards(q), scene.patches.normal[q],
                                scene.patches.area[q]);
      if (f == 0 || !sees(plan, inwards(p), inwards(q))) continue;
      form[p * n + q] = static_cast<float>(f * scene.patches.area[q]);
      form[q * n + p] = static_cast<float>(f * scene.patches.area[p]);
    }
  for (std::size_t p = 0; p < n; ++p) {
    float sum = 0;
    for (std::size_t q = 0; q < n; ++q) sum += form[p * n + q];
    if (sum > 1)
      for (std::size_t q = 0; q < n; ++q) form[p * n + q] /= sum;
  }
  std::vector<float> total(n * m), wave(n * m), next(n * m);  // row-major n x m
  for (std::size_t p = 0; p < n; ++p)
    for (std::size_t j = 0; j < m; ++j) {
      const Site& site = scene.sites[j];
      const Vec3 lamp = site.position + 0.02 * site.normal;
      if (!sees(plan, lamp, inwards(p))) continue;
      wave[p * m + j] = static_cast<float>(
          transfer(lamp, site.normal, inwards(p), scene.patches.normal[p], site.size * site.size));
    }
  total = wave;
  for (int bounce = 0; bounce < bounces; ++bounce) {
    std::fill(next.begin(), next.end(), 0.0f);
    for (std::size_t p = 0; p < n; ++p)
      for (std::size_t q = 0; q < n; ++q) {
        const float f = form[p * n + q] * scene.patches.reflectance[q];
        if (f == 0) continue;
        for (std::size_t j = 0; j < m; ++j) next[p * m + j] += f * wave[q * m + j];
      }
    wave.swap(next);
    for (std::size_t k = 0; k < n * m; ++k) total[k] += wave[k];
  }
  scene.responses = {static_cast<std::uint32_t>(n), static_cast<std::uint32_t>(m), std::vector<float>(n * m)};
  for (std::size_t p = 0; p < n; ++p)
    for (std::size_t j = 0; j < m; ++j) scene.responses.illuminance[j * n + p] = total[p * m + j];
}

}  // namespace detail

/// Area-weighted mean rows and covariances of every leaf, from the responses; exitance with each patch's
/// reflectance.
inline void addStatistics(Scene& scene) {
  const std::size_t m = scene.sites.size();
  const auto leaf = [&](std::uint32_t s, bool reflected) {
    SurfaceStatistics result{std::vector<double>(m), std::vector<double>(m * m)};
    std::vector<double> value(m);
    for (const bool centred : {false, true})
      for (std::uint32_t p = 0; p < scene.responses.rows; ++p) {
        if (scene.patches.surface[p] != s) continue;
        const double weight = scene.patches.area[p] / scene.surfaces[s].area;
        const double rho = reflected ? scene.patches.reflectance[p] : 1;
        for (std::size_t j = 0; j < m; ++j)
          value[j] =
              rho * scene.responses.column(static_cast<std::uint32_t>(j))[p] - (centred ? result.mean[j] : 0);
        for (std::size_t i = 0; i < m; ++i) {
          if (!centred) result.mean[i] += weight * value[i];
          for (std::size_t j = 0; centred && j < m; ++j)
            result.covariance[i * m + j] += weight * value[i] * value[j];
        }
      }
    return result;
  };
  scene.illuminance.clear();
  scene.exitance.clear();
  for (std::uint32_t s = 0; s < scene.surfaces.size(); ++s) {
    scene.illuminance.push_back(leaf(s, false));
    scene.exitance.push_back(leaf(s, true));
  }
  scene.errorBound.assign(scene.surfaces.size(), 0.0f);
}

/// Surfaces: 0 floor, 1 ceiling, 2 yellow wall, 3 walls.
inline Scene syntheticScene(const Plan& plan, int bounces = 3) {
  Scene scene;
  scene.identity = "0123456789abcdef";
  detail::addPatches(scene, plan);
  detail::addSites(scene, plan);
  detail::addResponses(scene, plan, bounces);
  addStatistics(scene);
  return scene;
}

/// 258 sites over a straight corridor of 6 x 43 cells; made once.
inline const Scene& longCorridor() {
  static const Scene scene = syntheticScene(boxPlan(6, 43), 2);
  return scene;
}

/// 20 sites over a room of 5 x 4 cells; made once.
inline const Scene& smallRoom() {
  static const Scene scene = syntheticScene(boxPlan(5, 4), 3);
  return scene;
}

}  // namespace fiatlux::testing
