#include "precompute/geometry/plain_reflectance.h"

#include <algorithm>
#include <cmath>

#include "core/base/short_number.h"

namespace fiatlux {
namespace {

constexpr float kOfCeilings = 0.7f, kOfWalls = 0.5f, kOfFloors = 0.2f, kOfThings = 0.4f;
constexpr double kSlanted = 0.7;                            // cos 45 degrees
constexpr double kLargePlane = 3, kLargePlaneShare = 0.04;  // m2, or of the room's area: part of the building

/// Pure white, which is what programs give to whatever has no colour yet; or its picture cannot be read.
bool isWhite(const SourceScene& source, const SourceMaterial& material) {
  const bool hasPicture = material.image >= 0 && source.images[material.image].width > 0;
  const auto& color = material.baseColor;
  return !hasPicture && std::min({color[0], color[1], color[2]}) == 1;
}

bool isPlain(const SourceScene& source, const SourceMesh& mesh) {
  const bool isUndyed = mesh.material < 0 || isWhite(source, source.materials[mesh.material]);
  return isUndyed && mesh.colors.empty() && !mesh.extras.reflectance;
}

/// Meshes that are part of the room: neither a measuring plane nor left out.
std::vector<char> reflectingMeshes(const SourceScene& source, const SurfaceTree& tree) {
  std::vector<char> reflects(source.meshes.size(), 0);
  for (const SurfaceGroup& group : tree.groups)
    for (const Face& face : group.set.faces) reflects[face.mesh] = 1;
  return reflects;
}

float reflectanceOf(const Region& region, double area) {
  if (region.area < std::min(kLargePlane, kLargePlaneShare * area)) return kOfThings;
  if (region.normal.y < -kSlanted) return kOfCeilings;
  return region.normal.y > kSlanted ? kOfFloors : kOfWalls;
}

}  // namespace

AssumedReflectance assumeReflectance(const SourceScene& source, const SurfaceTree& tree) {
  AssumedReflectance assumed;
  assumed.ofTriangle.resize(source.meshes.size());
  const std::vector<char> reflects = reflectingMeshes(source, tree);
  std::size_t count = 0;
  std::string white;  // the first of such materials
  for (std::size_t m = 0; m < source.meshes.size(); ++m) {
    if (!reflects[m] || !isPlain(source, source.meshes[m])) continue;
    assumed.ofTriangle[m].assign(source.meshes[m].triangles.size(), kOfThings);
    ++count;
    if (const int material = source.meshes[m].material; material >= 0 && white.empty())
      white = " but white ('" + source.materials[material].name + "')";
  }
  if (count == 0) return assumed;

  // note: the two sides of a sheet are one triangle; its front, which comes last, decides
  const double area = areaOf(tree);
  for (const bool back : {true, false})
    for (const SurfaceGroup& group : tree.groups)
      for (const Region& region : group.regions)
        for (const std::uint32_t f : region.faces) {
          const Face& face = group.set.faces[f];
          std::vector<float>& values = assumed.ofTriangle[face.mesh];
          if (face.back == back && !values.empty()) values[face.source] = reflectanceOf(region, area);
        }
  assumed.note = std::to_string(count) + (count == 1 ? " mesh has" : " meshes have") + " no material" +
                 white + ": ceilings are taken to reflect " + shortNumber(kOfCeilings) + ", walls " +
                 shortNumber(kOfWalls) + ", floors " + shortNumber(kOfFloors) + ", other things " +
                 shortNumber(kOfThings);
  return assumed;
}

}  // namespace fiatlux
