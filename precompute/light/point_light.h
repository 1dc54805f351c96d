// Illuminance at free points, as a lux meter would read it: direct light exactly, everything reflected by
// cosine rays that collect the exitance of the patches they meet.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "core/base/result.h"
#include "core/scene/luminaire.h"
#include "precompute/rays/ray_tracer.h"

namespace fiatlux {

struct MeasuringPoint {
  Vec3 position, normal;  // m; unit
};

struct PointReading {
  double total = 0, direct = 0;  // lx on the plane of the normal
  double cylindrical = 0;        // lx, mean of the vertical illuminances of all directions, EN 12464-1
  double vertical[4] = {};       // lx on vertical planes that face +x, -x, +z, -z
};

struct PointOptions {
  std::uint32_t rays = 4096;  // from each point
  std::uint32_t split = 16;   // parts of a source's edge probed by shadow rays
  bool spatial = true;        // vertical and cylindrical readings too
  std::uint64_t seed = 1;
  unsigned threads = 0;
};

/// Readings of every point; `radiosity` (n, lm/m2) of the patches, empty for direct light alone.
std::vector<PointReading> readPoints(const Room& room, const RayTracer& tracer,
                                     const std::vector<MeasuringPoint>& points,
                                     const std::vector<Luminaire>& luminaires,
                                     const std::vector<float>& radiosity, const PointOptions& options);

/// Lines of x,y,z,nx,ny,nz (m; the normal of any length but 0); a heading and blank lines are skipped. An
/// error names the line.
Result<std::vector<MeasuringPoint>> parsePoints(const std::string& csv);

/// x,y,z,nx,ny,nz,direct,total,cylindrical,vertical_+x,vertical_-x,vertical_+z,vertical_-z; a row per point.
std::string pointsCsv(const std::vector<MeasuringPoint>& points, const std::vector<PointReading>& readings);

}  // namespace fiatlux
