// Areas across y and across z are summed first, which is cheap: few models that stand upright go on to rays.
#include "precompute/geometry/up_guess.h"

#include <cmath>

#include "core/base/short_number.h"
#include "precompute/geometry/ceilings.h"
#include "precompute/geometry/scale_guess.h"
#include "precompute/geometry/source_bounds.h"
#include "precompute/geometry/source_changes.h"

namespace fiatlux {
namespace {

constexpr double kAcross = 0.9;                    // cos 26 degrees
constexpr double kMoreAcross = 1.2;                // times as much area across z as across y
constexpr double kHigher = 1.5;                    // times as high rooms would be along y
constexpr double kLowRoom = 1.9, kHighRoom = 4.5;  // m, of rooms that are upright surely
constexpr double kThing = 0.5;                     // of the model along every axis: what is smaller
constexpr double kOnGround = 0.02;                 // of the model's height
constexpr std::size_t kFewThings = 3;              // say nothing

/// Of faces across an axis, in the file's units squared.
struct Across {
  double y = 0, z = 0;
  bool saysZ() const { return z > kMoreAcross * y; }
};

void addAcross(const SourceMesh& mesh, Across& across) {
  for (const auto& t : mesh.triangles) {
    const Vec3 &a = mesh.positions[t[0]], &b = mesh.positions[t[1]], &c = mesh.positions[t[2]];
    const Vec3 vector = 0.5 * cross(b - a, c - a);
    const double area = length(vector);
    if (std::abs(vector.y) > kAcross * area) across.y += area;
    if (std::abs(vector.z) > kAcross * area) across.z += area;
  }
}

/// Things that stand on the lowest level along an axis, and on no other side.
struct Standing {
  std::size_t onY = 0, onZ = 0;
};

Standing standing(const SourceScene& source) {
  const Bounds all = boundsOf(source);
  const Vec3 size = all.size();
  Standing standing;
  for (const SourceMesh& mesh : source.meshes) {
    Bounds box;
    for (const Vec3& p : mesh.positions) box.include(p);
    const Vec3 own = box.empty() ? size : box.size();
    if (own.x > kThing * size.x || own.y > kThing * size.y || own.z > kThing * size.z) continue;
    const bool onY = box.low.y - all.low.y < kOnGround * size.y;
    const bool onZ = box.low.z - all.low.z < kOnGround * size.z;
    standing.onY += onY && !onZ;
    standing.onZ += onZ && !onY;
  }
  return standing;
}

}  // namespace

bool looksZUp(const SourceScene& source, double scale) {
  Across all, named;
  for (const SourceMesh& mesh : source.meshes) {
    if (mesh.extras.mount) return false;
    if (mesh.extras.measure) continue;
    addAcross(mesh, all);
    const bool isNamed =
        saysCeiling(mesh.node) ||
        (mesh.material >= 0 && saysCeiling(source.materials[static_cast<std::size_t>(mesh.material)].name));
    if (isNamed) addAcross(mesh, named);
  }
  if (named.y + named.z > 0) return named.z > kHigher * named.y;
  if (!all.saysZ()) return false;
  const Standing things = standing(source);
  if (things.onY + things.onZ >= kFewThings && things.onY >= things.onZ) return false;

  const auto heightOf = [scale](const SourceScene& scene) {
    const double rooms = heightOfRooms(scene);
    return (scale > 0 ? 1 : guessedScale(scene)) * (rooms > 0 ? rooms : boundsOf(scene).size().y);
  };
  SourceScene turned;  // note: of what has a place alone, for pictures and names weigh much
  turned.meshes.resize(source.meshes.size());
  for (std::size_t m = 0; m < source.meshes.size(); ++m) {
    turned.meshes[m].positions = source.meshes[m].positions;
    turned.meshes[m].triangles = source.meshes[m].triangles;
  }
  standUpright(turned);
  const double asZ = heightOf(turned);
  return asZ >= kLowRoom && asZ <= kHighRoom && heightOf(source) > kHigher * asZ;
}

std::string noteOfUp(const SourceScene& source) {
  const Vec3 size = boundsOf(source).size();
  return "with y up the model would be " + shortNumber(size.z) + " m high: it is taken to have z up, " +
         sizesOf(size, 1) + "; --up y refuses that";
}

}  // namespace fiatlux
