#include "precompute/light/point_light.h"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <limits>
#include <numbers>
#include <sstream>

#include "precompute/base/parallel.h"
#include "precompute/light/direct_light.h"
#include "precompute/rays/hemisphere.h"
#include "precompute/rays/ray_sequence.h"

namespace fiatlux {

namespace {

constexpr std::uint32_t kAzimuths = 36;  // directions whose vertical illuminances make the cylindrical one

class PointReader {
 public:
  PointReader(const Room& room, const RayTracer& tracer, const std::vector<Luminaire>& luminaires,
              const std::vector<float>& radiosity, const PointOptions& options)
      : room_(room),
        tracer_(tracer),
        luminaires_(luminaires),
        radiosity_(radiosity),
        options_(options),
        sequence_(options.rays) {}

  PointReading read(const MeasuringPoint& point, std::uint64_t seed) const {
    // note: rays start a hair off the point, so that a point on a surface sees what is before it.
    const Vec3 position = point.position + tracer_.offset() * point.normal;
    PointReading reading;
    reading.direct = direct(position, point.normal, options_.split, seed);
    reading.total = reading.direct + reflected(position, point.normal, seed);
    if (!options_.spatial) return reading;
    const Vec3 sides[4] = {{1, 0, 0}, {-1, 0, 0}, {0, 0, 1}, {0, 0, -1}};
    for (int i = 0; i < 4; ++i) {
      reading.vertical[i] =
          direct(position, sides[i], options_.split, seed + i) + reflected(position, sides[i], seed + i);
    }
    for (std::uint32_t i = 0; i < kAzimuths; ++i) {
      const double angle = 2 * std::numbers::pi * (i + 0.5) / kAzimuths;
      const Vec3 side{std::cos(angle), 0, std::sin(angle)};
      reading.cylindrical += direct(position, side, std::max(1u, options_.split / 4), seed + i) / kAzimuths;
    }
    reading.cylindrical += reflectedAround(position, seed);
    return reading;
  }

 private:
  double direct(const Vec3& position, const Vec3& normal, std::uint32_t split, std::uint64_t seed) const {
    double sum = 0;
    for (const Luminaire& luminaire : luminaires_) {
      sum += directLightAt(tracer_, {position, normal, 1}, luminaire, split, seed);
    }
    return sum;
  }

  /// Mean over the rays of weight x exitance of what a ray meets.
  template <class DirectionOf, class WeightOf>
  double collect(const Vec3& position, std::uint64_t seed, const DirectionOf& directionOf,
                 const WeightOf& weightOf) const {
    if (radiosity_.empty()) return 0;
    const auto scramble = RaySequence::scramble(seed);
    double sum = 0;
    for (std::uint32_t first = 0; first < sequence_.count(); first += RayPacket::kSize) {
      RayPacket packet;
      Vec3 direction[RayPacket::kSize];
      for (std::uint32_t i = first; i < std::min(first + RayPacket::kSize, sequence_.count()); ++i) {
        direction[packet.count] = directionOf(sequence_.point(i, scramble));
        tracer_.aim(packet, position, direction[packet.count], std::numeric_limits<float>::infinity());
      }
      HitPacket hits;
      tracer_.intersect(packet, hits);
      for (std::uint32_t i = 0; i < packet.count; ++i) {
        const std::uint32_t q = room_.patchMet(position, direction[i], hits.triangle[i], hits.distance[i]);
        if (q != kNone) sum += weightOf(direction[i]) * radiosity_[q];
      }
    }
    return sum / sequence_.count();
  }

  double reflected(const Vec3& position, const Vec3& normal, std::uint64_t seed) const {
    const Frame frame(normal);
    return collect(
        position, seed, [&](const std::array<double, 4>& s) { return cosineDirection(frame, s[0], s[1]); },
        [](const Vec3&) { return 1.0; });
  }

  /// Cylindrical illuminance = integral of L sin(theta) / pi over the sphere, L = exitance / pi.
  double reflectedAround(const Vec3& position, std::uint64_t seed) const {
    const auto onSphere = [](const std::array<double, 4>& s) {
      const double y = 1 - 2 * s[0], r = std::sqrt(std::max(0.0, 1 - y * y)),
                   angle = 2 * std::numbers::pi * s[1];
      return Vec3{r * std::cos(angle), y, r * std::sin(angle)};
    };
    return collect(position, seed, onSphere, [](const Vec3& d) {
      return 4 / std::numbers::pi * std::sqrt(std::max(0.0, 1 - d.y * d.y));
    });
  }

  const Room& room_;
  const RayTracer& tracer_;
  const std::vector<Luminaire>& luminaires_;
  const std::vector<float>& radiosity_;
  const PointOptions& options_;
  RaySequence sequence_;
};

}  // namespace

std::vector<PointReading> readPoints(const Room& room, const RayTracer& tracer,
                                     const std::vector<MeasuringPoint>& points,
                                     const std::vector<Luminaire>& luminaires,
                                     const std::vector<float>& radiosity, const PointOptions& options) {
  const PointReader reader(room, tracer, luminaires, radiosity, options);
  std::vector<PointReading> readings(points.size());
  parallelFor(points.size(), options.threads, [&](std::size_t i) {
    readings[i] = reader.read(points[i], mixBits(mixBits(options.seed) + i));
  });
  return readings;
}

Result<std::vector<MeasuringPoint>> parsePoints(const std::string& csv) {
  std::vector<MeasuringPoint> points;
  const bool marked = csv.rfind("\xef\xbb\xbf", 0) == 0;  // as spreadsheets mark UTF-8
  std::istringstream lines(marked ? csv.substr(3) : csv);
  std::string line;
  for (std::size_t number = 1; std::getline(lines, line); ++number) {
    if (line.find_first_not_of(" \t\r") == std::string::npos) continue;
    double values[6];
    const char* at = line.c_str();
    int count = 0;
    for (; count < 6; ++count) {
      char* end = nullptr;
      values[count] = std::strtod(at, &end);
      if (end == at || !std::isfinite(values[count])) break;
      at = end;
      while (*at == ' ' || *at == '\t' || *at == '\r') ++at;
      if (count < 5 && *at++ != ',') break;
    }
    const Vec3 normal{values[3], values[4], values[5]};
    if (count < 6 || *at != '\0' || !(length(normal) > 0)) {
      if (number == 1 && std::isalpha(static_cast<unsigned char>(line[0])) && count == 0)
        continue;  // heading
      return Error{"line " + std::to_string(number) + " is not x,y,z,nx,ny,nz with a normal that is not 0"};
    }
    points.push_back({{values[0], values[1], values[2]}, normalized(normal)});
  }
  if (points.empty()) return Error{"there is no point in it; each line is x,y,z,nx,ny,nz"};
  return points;
}

std::string pointsCsv(const std::vector<MeasuringPoint>& points, const std::vector<PointReading>& readings) {
  std::string csv =
      "x,y,z,nx,ny,nz,direct,total,cylindrical,vertical_+x,vertical_-x,vertical_+z,vertical_-z\n";
  for (std::size_t i = 0; i < points.size(); ++i) {
    const auto& [p, n] = points[i];
    const PointReading& r = readings[i];
    char row[400];
    std::snprintf(row, sizeof row, "%.6g,%.6g,%.6g,%.6g,%.6g,%.6g,%.6g,%.6g,%.6g,%.6g,%.6g,%.6g,%.6g\n", p.x,
                  p.y, p.z, n.x, n.y, n.z, r.direct, r.total, r.cylindrical, r.vertical[0], r.vertical[1],
                  r.vertical[2], r.vertical[3]);
    csv += row;
  }
  return csv;
}

}  // namespace fiatlux
