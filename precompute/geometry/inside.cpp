// From meshes to the inside of a room.
#include "precompute/geometry/inside.h"

#include <algorithm>
#include <memory>
#include <set>

#include "core/base/short_number.h"
#include "core/scene/luminaire.h"
#include "precompute/base/error.h"
#include "precompute/geometry/charts.h"
#include "precompute/geometry/glass.h"
#include "precompute/room/bounds.h"

namespace fiatlux {
namespace {

constexpr std::size_t kMostTransparent = 8;              // of transparent materials, in warnings
constexpr double kTooWide = 250, kInMillimetres = 2000;  // m: what hardly a building is, and none
constexpr double kTooNarrow = 0.5;                       // m
constexpr double kRegionShare = 0.01;                    // of the area: such a plane is a surface of its own
constexpr double kPieces = 40;                           // on the diagonal: how fine a first look round is
constexpr double kNearCorner = 0.4;  // of a side, from the centre: where its light is tried

void warnOfScale(const WeldedMesh& mesh, std::vector<std::string>& warnings) {
  const double width = boundsOf(mesh.positions).longestEdge();
  if (width > kTooWide)
    warnings.push_back("the room is " + shortNumber(width) + " m wide: the file is probably in " +
                       (width > kInMillimetres ? "millimetres: pass --scale 0.001"
                                               : "centimetres or millimetres: pass --scale 0.01 or 0.001"));
  if (width < kTooNarrow)
    warnings.push_back("the room is only " + shortNumber(width) +
                       " m wide: pass --scale with the metres of one unit of the file");
}

/// Where light starts that a person has placed already.
std::vector<LightPlace> placesOf(const std::vector<Luminaire>& luminaires) {
  std::vector<LightPlace> places;
  for (const Luminaire& l : luminaires) {
    const bool isotropic = l.distribution == Luminaire::Distribution::kIsotropic;
    const bool toAllSides = isotropic || l.distribution == Luminaire::Distribution::kPhotometric;
    const Vec3 clear = isotropic ? Vec3{} : kLuminaireClearance * l.normal;
    const Vec3 u = kNearCorner * l.width * l.axis, v = kNearCorner * l.height * cross(l.normal, l.axis);
    for (const Vec3& from : {Vec3{}, u + v, u - v, v - u, -u - v})
      places.push_back({l.position + from + clear, toAllSides ? Vec3{} : l.normal});
  }
  return places;
}

/// What a look round has found.
struct Look {
  std::vector<Face> faces;  // fronts, then backs
  SurfaceTree tree;
  UniqueNames names;
  std::unique_ptr<Outlook> outlook;
  bool turned = false;  // some sheets were
  std::string note;     // on one-sided faces that were turned; "": none
};

/// `all`: as if every material were double-sided. Turns sheets of the mesh that look outward.
Look lookOnce(const SourceScene& source, const RayTracer& tracer, WeldedMesh& mesh, SmallParts& smallParts,
              bool all) {
  Look look;
  look.faces = frontFaces(mesh);
  const std::vector<Face> backs = backFaces(source, mesh, all);
  look.faces.insert(look.faces.end(), backs.begin(), backs.end());
  UniqueNames firstNames;
  look.tree = findSurfaces(source, mesh, look.faces, kRegionShare, firstNames, &smallParts);
  look.outlook =
      std::make_unique<Outlook>(mesh, tracer, makeCharts(mesh, look.tree, mesh.diagonal / kPieces, 0));
  look.turned = turnOutwardSheets(mesh, look.faces, *look.outlook);
  if (look.turned) {
    // What is turned over has other planes and other names: found anew, which is rare.
    look.tree = findSurfaces(source, mesh, look.faces, kRegionShare, look.names, &smallParts);
  } else {
    look.names = std::move(firstNames);
  }
  return look;
}

/// And one-sided faces that enclose what looks at their backs.
Look lookRound(const SourceScene& source, const RayTracer& tracer, WeldedMesh& mesh, SmallParts& smallParts,
               bool all) {
  Look look = lookOnce(source, tracer, mesh, smallParts, all);
  if (all) return look;
  const std::string note =
      turnWhatEncloses(source, mesh, look.tree, *look.outlook, FreeSpace(mesh, tracer, look.faces));
  if (note.empty()) return look;
  look = lookOnce(source, tracer, mesh, smallParts, all);
  look.note = note;
  return look;
}

/// Where luminaires hang: on what is marked, named or looks like a ceiling; where nothing does, on what does
/// once every face has two sides; else in a plane. `look` and `mesh` become those that are meant.
std::vector<Mount> hang(const SourceScene& source, const RoomOptions& options, const RayTracer& tracer,
                        WeldedMesh& mesh, SmallParts& smallParts, Look& look,
                        std::vector<std::string>& warnings) {
  const auto mountsIn = [&](const WeldedMesh& in, const Look& seen) {
    const FreeSpace space(in, tracer, seen.faces);
    return findMounts(source, in, seen.tree, seen.faces, space, options, warnings);
  };
  std::vector<Mount> mounts = mountsIn(mesh, look);
  if (mounts.empty() && options.requireSites && options.ceiling == 0 && !options.doubleSided) {
    WeldedMesh drawn = mesh;
    Look twoSided = lookRound(source, tracer, mesh, smallParts, true);
    mounts = mountsIn(mesh, twoSided);
    if (!mounts.empty()) {
      look = std::move(twoSided);
      warnings.push_back(
          "no ceiling looks into the room: all faces are taken as double-sided, and those that "
          "look outward are turned");
    } else {
      mesh.triangles = std::move(drawn.triangles);  // note: the look refers to the mesh itself
    }
  }
  if (options.ceiling > 0 || (mounts.empty() && options.requireSites))
    mounts.push_back(planeMount(mesh, look.tree, FreeSpace(mesh, tracer, look.faces), options, warnings));
  return mounts;
}

}  // namespace

Roles assignRoles(const SourceScene& source, const RoomOptions& options, std::vector<std::string>& warnings) {
  for (const std::string& name : options.measures) {
    const std::vector<std::string> names = askedNames(source);
    if (std::find(names.begin(), names.end(), name) == names.end()) unknownName("--measure", name, names);
  }
  Roles roles;
  std::set<std::string> transparent, opaque;  // materials, of these what is called glass
  for (std::uint32_t m = 0; m < source.meshes.size(); ++m) {
    const SourceMesh& mesh = source.meshes[m];
    const auto named = [&](const std::string& name) {
      return name == mesh.node || name == mesh.extras.surface;
    };
    if (mesh.extras.measure || std::any_of(options.measures.begin(), options.measures.end(), named)) {
      roles.measures.push_back(m);
    } else if (mesh.material >= 0 && source.materials[mesh.material].alpha == SourceMaterial::Alpha::kBlend) {
      transparent.insert(source.materials[mesh.material].name);
    } else {
      roles.reflectors.push_back(m);
      if (isOpaqueGlass(source, mesh)) opaque.insert(source.materials[mesh.material].name);
    }
  }
  if (!opaque.empty())
    warnings.push_back("material '" + *opaque.begin() + "'" +
                       (opaque.size() > 1 ? " and " + std::to_string(opaque.size() - 1) + " more" : "") +
                       ": called glass but opaque, so it counts as a wall; where light is to pass, make it "
                       "transparent (alpha BLEND)");
  for (const std::string& name : transparent)
    if (transparent.size() <= kMostTransparent || name == *transparent.begin())
      warnings.push_back(
          "material '" + name +
          "' is transparent (alpha BLEND or transmission): it is no wall, light passes it unchanged" +
          (transparent.size() <= kMostTransparent
               ? ""
               : "; so are " + std::to_string(transparent.size() - 1) + " more"));
  return roles;
}

WeldedMesh weldReflectors(const SourceScene& source, const Roles& roles, std::vector<std::string>& warnings) {
  WeldedMesh mesh = weld(source, roles.reflectors);
  if (mesh.triangles.empty())
    throw CommandError(
        roles.reflectors.empty()
            ? "no surfaces: everything is transparent or a measuring plane; give the walls an opaque material"
            : "no surfaces: every triangle has zero area; check the scale of the nodes");
  if (mesh.withoutArea > 0)
    warnings.push_back("triangles without area are left out: " + std::to_string(mesh.withoutArea));
  if (mesh.duplicates > 0)
    warnings.push_back("triangles that repeat others are left out: " + std::to_string(mesh.duplicates));
  warnOfScale(mesh, warnings);
  return mesh;
}

RayTracer tracerOf(const WeldedMesh& mesh) {
  std::vector<RayTracer::Triangle> triangles;
  for (const WeldedTriangle& t : mesh.triangles) triangles.push_back(t.vertex);
  return orThrow(RayTracer::build(mesh.positions, triangles));
}

std::vector<Face> frontFaces(const WeldedMesh& mesh) {
  std::vector<Face> faces;
  for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t)
    faces.push_back({mesh.triangles[t].vertex, t, mesh.triangles[t].mesh, mesh.triangles[t].source, false});
  return faces;
}

Inside findInside(const SourceScene& source, const RoomOptions& options, const RayTracer& tracer,
                  WeldedMesh& mesh, std::vector<std::string>& warnings) {
  SmallParts smallParts(source);
  Look look = lookRound(source, tracer, mesh, smallParts, options.doubleSided);
  Inside inside;
  inside.mounts = hang(source, options, tracer, mesh, smallParts, look, warnings);
  inside.turned = !look.note.empty();
  if (inside.turned) warnings.push_back(look.note);
  inside.tree = std::move(look.tree);
  inside.names = std::move(look.names);
  inside.space.emplace(mesh, tracer, look.faces);

  std::vector<LightPlace> places = placesOf(options.luminaires);
  const std::vector<LightPlace> open = placesInTheOpen(mesh, inside.mounts, *inside.space);
  places.insert(places.end(), open.begin(), open.end());
  const Outlook::Unlit unlit = look.outlook->unlit(facesWithSites(mesh, inside.mounts), places);
  inside.outside = leaveOut(unlit.outside, inside.tree);
  for (const std::string& note : {inside.outside.note, noteOfShutOff(unlit.shutOff, inside.tree)})
    if (!note.empty()) warnings.push_back(note);
  return inside;
}

}  // namespace fiatlux
