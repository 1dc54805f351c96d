// In float the sums are made for a few dozen points at a time, in plain arrays: the compiler makes vectors of
// the loops, natively and as Wasm, and only the look-ups are one by one.
#include "core/transport/direct_quadrature.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace fiatlux {
namespace {

constexpr double kNearField = 4;   // a part of a luminaire is that many times smaller than its distance
constexpr double kNearest = 0.15;  // of the distance of the centres: what touches is not infinitely near
constexpr double kInPlane = 1e-5;  // m: what is so little before a patch lies in its plane, but for rounding
constexpr double kBeamParts = 6;   // steps of a patch's quadrature within a beam
constexpr double kWidestStep = 0.25;       // rad, of a patch's quadrature whatever the beam
constexpr std::uint32_t kMostPairs = 512;  // of parts of a patch and of a luminaire, in float
constexpr std::uint32_t kMostParts = 12;   // on a luminaire's edge, on a patch's edge

std::uint32_t partsFor(double size, double step) {
  if (size <= step) return 1;
  return static_cast<std::uint32_t>(
      std::min(std::ceil(size / std::max(step, 1e-9)), static_cast<double>(kMostParts)));
}

/// m from centre to centre at which a patch and a luminaire may touch.
double reachOf(const PatchTile& tile, const Luminaire& luminaire) {
  return 0.5 * (tile.lengthU + tile.lengthV + std::max(luminaire.width, luminaire.height));
}

/// Of a patch's quadrature, rad.
double stepOf(const Luminaire& luminaire) { return std::min(luminaire.beam / kBeamParts, kWidestStep); }

/// How large a part of a luminaire may be, for 1 m of distance: seen from there it must not blur the beam.
double largestPart(const Luminaire& luminaire) { return std::min(luminaire.beam / 4, 1 / kNearField); }

/// The middle of part i of `count` of an edge that runs from -1/2 to 1/2.
double middle(std::uint32_t i, std::uint32_t count) { return (i + 0.5) / count - 0.5; }

constexpr int kPoints = 64;  // of patches at a time
using Lane = std::array<float, kPoints>;

/// Points of patches whose light comes from equal parts of a luminaire.
struct Points {
  int count = 0;
  Lane x, y, z, nx, ny, nz, weight;  // m from the luminaire's centre, the patch's normal, share of the patch
  std::array<std::uint32_t, kPoints> row;

  void add(std::uint32_t p, const Vec3& from, const Vec3& normal, float share) {
    const int at = count++;
    x[at] = static_cast<float>(from.x), y[at] = static_cast<float>(from.y),
    z[at] = static_cast<float>(from.z);
    nx[at] = static_cast<float>(normal.x), ny[at] = static_cast<float>(normal.y);
    nz[at] = static_cast<float>(normal.z);
    weight[at] = share, row[at] = p;
  }
};

/// cos of the incidence / d^2 of each point from one part of the luminaire, and the direction in its axes.
struct Beams {
  Lane along, across, down, strength;
};

struct Frame {
  float position[3], axis[3], across[3], normal[3];  // of the part from the luminaire's centre; unit
};

void aim(const Points& points, const Frame& from, Beams& beams) {
  for (int i = 0; i < kPoints; ++i) {
    const float x = points.x[i] - from.position[0], y = points.y[i] - from.position[1],
                z = points.z[i] - from.position[2];
    const float before = -(x * points.nx[i] + y * points.ny[i] + z * points.nz[i]);
    const float incidence = before > static_cast<float>(kInPlane) ? before : 0.0f;
    const float inverse = 1 / std::sqrt(std::max(x * x + y * y + z * z, 1e-12f));
    beams.along[i] = inverse * (x * from.axis[0] + y * from.axis[1] + z * from.axis[2]);
    beams.across[i] = inverse * (x * from.across[0] + y * from.across[1] + z * from.across[2]);
    beams.down[i] = inverse * (x * from.normal[0] + y * from.normal[1] + z * from.normal[2]);
    beams.strength[i] = incidence * inverse * inverse * inverse;
  }
}

void toFloat(const Vec3& v, float* to) {
  to[0] = static_cast<float>(v.x), to[1] = static_cast<float>(v.y), to[2] = static_cast<float>(v.z);
}

/// Adds what the parts of a luminaire give to the points of a full or a last set, which is then empty.
template <class Look>
void flush(Points& points, const Luminaire& luminaire, std::uint32_t width, std::uint32_t height,
           const Look& look, float* column) {
  for (int i = points.count; i < kPoints; ++i) {  // note: what is left over must not divide by zero
    points.x[i] = points.y[i] = points.z[i] = 1;
    points.nx[i] = points.ny[i] = points.nz[i] = 0;
  }
  const Vec3 across = cross(luminaire.normal, luminaire.axis);
  Frame frame;
  toFloat(luminaire.axis, frame.axis), toFloat(across, frame.across), toFloat(luminaire.normal, frame.normal);
  Lane sum{};
  Beams beams;
  for (std::uint32_t k = 0; k < width * height; ++k) {
    toFloat((middle(k % width, width) * luminaire.width) * luminaire.axis +
                (middle(k / width, height) * luminaire.height) * across,
            frame.position);
    aim(points, frame, beams);
    look(beams, sum);
  }
  const float share = 1.0f / static_cast<float>(width * height);
  for (int i = 0; i < points.count; ++i) column[points.row[i]] += share * points.weight[i] * sum[i];
  points.count = 0;
}

}  // namespace

DirectQuadrature::DirectQuadrature(const Scene& scene)
    : scene_(scene), tiles_(patchTiles(scene.patches, scene.lightOperator->charts)) {
  for (const PatchTile& tile : tiles_)
    sizes_.push_back({std::max(tile.lengthU, tile.lengthV), 0.5 * (tile.lengthU + tile.lengthV)});
}

DirectQuadrature::Parts DirectQuadrature::partsOf(std::uint32_t row, const Vec3& apart,
                                                  const Luminaire& luminaire) const {
  const PatchTile& tile = tiles_[row];
  const double distance = length(apart);
  const double nearest = std::max(distance - reachOf(tile, luminaire), kNearest * distance);
  const double step = stepOf(luminaire) * nearest, part = largestPart(luminaire) * nearest;
  return {partsFor(tile.lengthU, step), partsFor(tile.lengthV, step), partsFor(luminaire.width, part),
          partsFor(luminaire.height, part)};
}

double DirectQuadrature::exactOn(std::uint32_t row, const Luminaire& luminaire) const {
  const PatchTile& tile = tiles_[row];
  const Vec3& normal = scene_.patches.normal[row];
  const Vec3 apart = scene_.patches.center[row] - luminaire.position;
  const Parts parts = partsOf(row, apart, luminaire);
  const Vec3 across = cross(luminaire.normal, luminaire.axis);
  const std::uint32_t points = parts.u * parts.v, sources = parts.width * parts.height;
  double sum = 0;
  for (std::uint32_t i = 0; i < points; ++i) {
    const Vec3 on =
        apart + middle(i % parts.u, parts.u) * tile.edgeU + middle(i / parts.u, parts.v) * tile.edgeV;
    for (std::uint32_t k = 0; k < sources; ++k) {
      const Vec3 d = on - (middle(k % parts.width, parts.width) * luminaire.width) * luminaire.axis -
                     (middle(k / parts.width, parts.height) * luminaire.height) * across;
      const double incidence = -dot(d, normal), squared = dot(d, d);
      if (incidence <= kInPlane) continue;
      const double inverse = 1 / std::sqrt(squared);
      const Vec3 local = inverse * Vec3{dot(d, luminaire.axis), dot(d, across), dot(d, luminaire.normal)};
      sum += luminaire.intensity(local) * incidence * inverse / squared;
    }
  }
  return sum / (points * sources);
}

void DirectQuadrature::exact(const Luminaire& luminaire, const std::uint8_t* visible, float* column) const {
  for (std::uint32_t p = 0; p < scene_.patches.rows(); ++p) {
    const double share = SiteVisibility::shareOf(visible[p]);
    column[p] = share > 0 ? static_cast<float>(share * exactOn(p, luminaire)) : 0;
  }
}

/// Every part of the patch with every part of the luminaire would be too many: pairs of points of the two,
/// spread evenly in all four directions (Roberts' sequence).
template <class Add>
void DirectQuadrature::pairUp(const PatchTile& tile, const Luminaire& luminaire, const Add& add) const {
  const auto part = [](std::uint32_t i, double step) {
    const double at = 0.5 + (i + 1) * step;
    return at - std::floor(at) - 0.5;
  };
  const Vec3 across = cross(luminaire.normal, luminaire.axis);
  for (std::uint32_t i = 0; i < kMostPairs; ++i)
    add(part(i, 0.8566748838545029) * tile.edgeU + part(i, 0.733891856627126) * tile.edgeV -
        (part(i, 0.6287067210378087) * luminaire.width) * luminaire.axis -
        (part(i, 0.5385972572236101) * luminaire.height) * across);
}

template <class Look>
void DirectQuadrature::inFloat(const Luminaire& luminaire, const Look& look, const std::uint8_t* visible,
                               float* column) const {
  const Patches& patches = scene_.patches;
  // Beyond `far` partsOf() a row is one of everything, which most of them are.
  constexpr double kSlack = 1 + 1e-9;  // note: of rounding, so that both say the same
  const double size = std::max(luminaire.width, luminaire.height), steps = 1 / stepOf(luminaire),
               part = largestPart(luminaire);
  std::vector<Points> sets((kMostParts + 1) * (kMostParts + 1));
  Points& whole = sets[kMostParts + 2];
  for (std::uint32_t p = 0; p < patches.rows(); ++p) {
    if (visible[p] == 0) continue;
    const Vec3 apart = patches.center[p] - luminaire.position;
    const double far =
        kSlack * (std::max(sizes_[p].longer * steps, size / part) + sizes_[p].reach + 0.5 * size);
    if (dot(apart, apart) > far * far) {
      whole.add(p, apart, patches.normal[p], static_cast<float>(SiteVisibility::shareOf(visible[p])));
      if (whole.count == kPoints) flush(whole, luminaire, 1, 1, look, column);
      continue;
    }
    const PatchTile& tile = tiles_[p];
    Parts parts = partsOf(p, apart, luminaire);
    std::uint32_t count = parts.u * parts.v;
    const bool areMany = count * parts.width * parts.height > kMostPairs;
    if (areMany) count = kMostPairs, parts.width = parts.height = 1;
    Points& points = sets[parts.width * (kMostParts + 1) + parts.height];
    const auto share = static_cast<float>(SiteVisibility::shareOf(visible[p]) / count);
    const auto add = [&](const Vec3& off) {
      points.add(p, apart + off, patches.normal[p], share);
      if (points.count == kPoints) flush(points, luminaire, parts.width, parts.height, look, column);
    };
    if (areMany)
      pairUp(tile, luminaire, add);
    else
      for (std::uint32_t i = 0; i < count; ++i)
        add(middle(i % parts.u, parts.u) * tile.edgeU + middle(i / parts.u, parts.v) * tile.edgeV);
  }
  for (std::uint32_t key = 0; key < sets.size(); ++key)
    if (sets[key].count > 0)
      flush(sets[key], luminaire, key / (kMostParts + 1), key % (kMostParts + 1), look, column);
}

void DirectQuadrature::looked(const Luminaire& luminaire, const IntensityMap& map, float scale,
                              const std::uint8_t* visible, float* column) const {
  const auto look = [&](const Beams& beams, Lane& sum) {
    Lane candela;
    map.look(beams.along.data(), beams.across.data(), beams.down.data(), kPoints, candela.data());
    for (int i = 0; i < kPoints; ++i) sum[i] += scale * candela[i] * beams.strength[i];
  };
  inFloat(luminaire, look, visible, column);
}

void DirectQuadrature::lambertian(const Luminaire& luminaire, const std::uint8_t* visible,
                                  float* column) const {
  const auto look = [](const Beams& beams, Lane& sum) {
    constexpr float kPerLumen = 1 / std::numbers::pi_v<float>;
    for (int i = 0; i < kPoints; ++i) sum[i] += kPerLumen * std::max(0.0f, beams.down[i]) * beams.strength[i];
  };
  inFloat(luminaire, look, visible, column);
}

}  // namespace fiatlux
