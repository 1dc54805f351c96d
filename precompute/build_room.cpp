// The stages of a room in order: weld, find surfaces, lay charts, cut patches, cluster, hang sites.
#include "precompute/build_room.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <new>
#include <set>
#include <unordered_map>

#include "precompute/charts.h"
#include "precompute/clusters.h"
#include "precompute/command_error.h"
#include "precompute/names.h"
#include "precompute/patches.h"
#include "precompute/reflectance.h"
#include "precompute/sites.h"
#include "precompute/surfaces.h"

namespace fiatlux {
namespace {

constexpr std::uint32_t kMostClusters = 3000;

std::string shortNumber(double x) {
  char text[32];
  std::snprintf(text, sizeof text, "%.3g", x);
  return text;
}

/// The source's meshes by what they are to the light.
struct Roles {
  std::vector<std::uint32_t> reflectors, measures;
};

std::vector<std::string> nodeNames(const SourceScene& source) {
  std::set<std::string> names;
  for (const SourceMesh& mesh : source.meshes) {
    names.insert(mesh.node);
    if (!mesh.extras.surface.empty()) names.insert(mesh.extras.surface);
  }
  return {names.begin(), names.end()};
}

[[noreturn]] void unknownName(const char* option, const std::string& name,
                              const std::vector<std::string>& names) {
  throw CommandError(std::string(option) + " '" + cleanText(name) +
                     "': no node or surface is called that; the closest are " + closestNames(name, names));
}

Roles assignRoles(const SourceScene& source, const RoomOptions& options, std::vector<std::string>& warnings) {
  for (const std::string& name : options.measures) {
    const std::vector<std::string> names = nodeNames(source);
    if (std::find(names.begin(), names.end(), name) == names.end()) unknownName("--measure", name, names);
  }
  Roles roles;
  std::set<std::string> transparent;
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
    }
  }
  for (const std::string& name : transparent)
    if (transparent.size() <= 8 || name == *transparent.begin())
      warnings.push_back(
          "material '" + name + "' is transparent (alpha BLEND): it is no wall, light passes it unchanged" +
          (transparent.size() <= 8 ? "" : "; so are " + std::to_string(transparent.size() - 1) + " more"));
  return roles;
}

void warnOfScale(const WeldedMesh& mesh, std::vector<std::string>& warnings) {
  Vec3 low = mesh.positions[0], high = low;
  for (const Vec3& p : mesh.positions) {
    low = {std::min(low.x, p.x), std::min(low.y, p.y), std::min(low.z, p.z)};
    high = {std::max(high.x, p.x), std::max(high.y, p.y), std::max(high.z, p.z)};
  }
  const double width = std::max({high.x - low.x, high.y - low.y, high.z - low.z});
  if (width > 100)
    warnings.push_back("the room is " + shortNumber(width) + " m wide: the file is probably in " +
                       (width > 2000 ? "millimetres: pass --scale 0.001"
                                     : "centimetres or millimetres: pass --scale 0.01 or 0.001"));
  if (width < 0.5)
    warnings.push_back("the room is only " + shortNumber(width) +
                       " m wide: pass --scale with the metres of one unit of the file");
}

std::vector<Face> frontFaces(const WeldedMesh& mesh) {
  std::vector<Face> faces;
  for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t)
    faces.push_back({mesh.triangles[t].vertex, t, mesh.triangles[t].mesh, mesh.triangles[t].source, false});
  return faces;
}

double areaOf(const WeldedMesh& mesh, const std::vector<Face>& faces) {
  double area = 0;
  for (const Face& face : faces) area += length(areaVector(mesh.positions, face.vertex));
  return area;
}

/// Refuses what would not fit, before it is allocated; the message names the largest part.
void checkMemory(const RoomOptions& options, double patches, double clusters, double rows, double sites,
                 double surfaces) {
  struct Part {
    double bytes;
    std::string what, cure;
  };
  const std::string n = shortNumber(patches);
  const Part parts[] = {
      {patches * clusters * 4, n + " patches x " + shortNumber(clusters) + " clusters",
       "a larger --patch or --cluster"},
      {patches * options.rays * 4, n + " patches x " + std::to_string(options.rays) + " rays",
       "a larger --patch or fewer --rays"},
      {rows * sites * 4, shortNumber(rows) + " patches x " + shortNumber(sites) + " sites",
       "a larger --patch or --site-spacing"},
      {surfaces * sites * sites * 8,
       shortNumber(surfaces) + " surfaces x " + shortNumber(sites) + " sites squared",
       "a larger --site-spacing"},
      {rows * 600, n + " patches", "a larger --patch"}};
  double total = 0;
  const Part* largest = parts;
  for (const Part& part : parts) {
    total += part.bytes;
    if (part.bytes > largest->bytes) largest = &part;
  }
  if (!(total <= options.memory * 1e9))
    throw CommandError("this would need " + shortNumber(total / 1e9) + " GB, and --memory allows " +
                       shortNumber(options.memory) + ": too many are " + largest->what + "; pass " +
                       largest->cure);
}

double foreseenPatches(const std::vector<ChartDraft>& charts) {
  double patches = 0;
  for (const ChartDraft& draft : charts)
    patches += std::max(1.0, draft.area / (draft.chart.cellU * draft.chart.cellV));
  return patches;
}

/// Refuses grids that are too fine, before they are cut.
void checkGrids(const std::vector<ChartDraft>& charts, const RoomOptions& options, double patch) {
  double cells = 0;
  for (const ChartDraft& draft : charts) {
    cells += static_cast<double>(draft.chart.columns) * draft.chart.rows;
  }
  if (cells * 24 > options.memory * 1e9)
    throw CommandError("patches of " + shortNumber(patch) + " m need " + shortNumber(cells) +
                       " grid cells, more than --memory allows; pass a larger --patch");
  const double patches = foreseenPatches(charts);
  const double clusters = options.paper ? patches / (options.cluster * options.cluster)
                                        : std::min<double>(patches / 4, kMostClusters);
  checkMemory(options, patches, clusters, patches, 0, 0);
}

/// The patch size that gives about 25 000 patches, between 0.05 and 0.5 m (huge rooms: up to 100 000
/// patches), and where a mount's site spacing is known a whole fraction of it, so that squares of light end
/// where patches do.
double fittingPatchSize(const SourceScene& source, const WeldedMesh& mesh, const SurfaceTree& tree,
                        double area) {
  double spacing = 0;
  for (const SourceMesh& from : source.meshes)
    if (from.extras.mount && from.extras.siteSpacing && spacing == 0) spacing = *from.extras.siteSpacing;
  const auto snapped = [&](double patch) {
    const double fraction = spacing > 0 ? spacing / std::max(1.0, std::round(spacing / patch)) : patch;
    return std::abs(std::log(fraction / patch)) < 0.25 ? fraction : patch;
  };
  double patch = std::clamp(std::sqrt(area / 25000), 0.05, std::max(0.5, std::sqrt(area / 100000)));
  // Thin and small things get more patches than their area says: coarsen until the number fits.
  for (int i = 0; i < 3; ++i) {
    const double count = foreseenPatches(makeCharts(mesh, tree, snapped(patch), 0));
    if (count < 1.15 * 25000 || snapped(patch) >= 0.5) break;
    patch = std::min(patch * std::sqrt(count / 25000), 0.5);
  }
  return snapped(patch);
}

void addSurfaces(const SurfaceTree& tree, bool measuring, Room& room) {
  for (const std::string& name : tree.names) {
    Surface surface;
    surface.name = name;
    surface.measuring = measuring;
    room.surfaces.push_back(surface);
  }
  room.warnings.insert(room.warnings.end(), tree.warnings.begin(), tree.warnings.end());
}

/// Areas, reflectances and counts of the surfaces, from their patches.
void sumSurfaces(Room& room) {
  for (std::uint32_t p = 0; p < room.patches.rows(); ++p) {
    Surface& surface = room.surfaces[room.patches.surface[p]];
    surface.area += room.patches.area[p];
    surface.reflectance += room.patches.area[p] * room.patches.reflectance[p];
    ++surface.patches;
  }
  for (Surface& surface : room.surfaces)
    if (surface.area > 0) surface.reflectance /= surface.area;
}

void addTriangles(const WeldedMesh& mesh, const std::vector<ChartDraft>& drafts, Room& room) {
  room.positions = mesh.positions;
  for (const WeldedTriangle& t : mesh.triangles)
    room.triangles.push_back(
        {t.vertex,
         kNone,
         kNone,
         {t.mesh, t.source},
         {t.backMesh == kNone ? t.mesh : t.backMesh, t.backMesh == kNone ? t.source : t.backSource}});
  for (std::uint32_t d = 0; d < drafts.size(); ++d)
    for (const Face& face : drafts[d].faces)
      (face.back ? room.triangles[face.triangle].backChart : room.triangles[face.triangle].chart) = d;
}

void addMeasuringPlanes(const SourceScene& source, const Roles& roles, double patch, UniqueNames& names,
                        Room& room) {
  if (roles.measures.empty()) return;
  const WeldedMesh mesh = weld(source, roles.measures);
  std::vector<Face> faces = frontFaces(mesh);
  for (Face& face : faces) {
    const Vec3 normal = normalized(areaVector(mesh.positions, face.vertex));
    if (normal.y < -0.7) std::swap(face.vertex[1], face.vertex[2]);
  }
  const auto first = static_cast<std::uint32_t>(room.surfaces.size());
  const SurfaceTree tree = findSurfaces(source, mesh, faces, 0, names);
  addSurfaces(tree, true, room);
  std::vector<ChartDraft> charts = makeCharts(mesh, tree, patch, first);
  appendPatches(mesh, charts, patch, nullptr, room);
}

// --- mounts
// ----------------------------------------------------------------------------------------------------------

struct Mount {
  std::string name;
  std::vector<Face> faces;
  double spacing = 0;  // m, 0 = not said
};

bool within(const std::string& path, const std::string& name) {
  return path == name ||
         (path.size() > name.size() && path.compare(0, name.size(), name) == 0 && path[name.size()] == '/');
}

std::vector<Mount> markedMounts(const SourceScene& source, const std::vector<Face>& faces) {
  std::vector<Mount> mounts;
  std::unordered_map<std::uint32_t, std::size_t> ofNode;
  for (const Face& face : faces) {
    const SourceMesh& mesh = source.meshes[face.mesh];
    if (!mesh.extras.mount) continue;
    const auto [found, fresh] = ofNode.emplace(mesh.nodeIndex, mounts.size());
    if (fresh) mounts.push_back({mesh.node, {}, mesh.extras.siteSpacing.value_or(0)});
    mounts[found->second].faces.push_back(face);
  }
  return mounts;
}

void addNamedMounts(const SourceScene& source, const SurfaceTree& tree, const std::vector<Face>& faces,
                    const std::vector<std::string>& wanted, std::vector<Mount>& mounts) {
  for (const std::string& name : wanted) {
    Mount mount{name, {}, 0};
    for (const SurfaceGroup& group : tree.groups)
      for (std::size_t r = 0; r < group.regions.size(); ++r)
        if (within(tree.names[group.leafOfRegion[r]], name) ||
            within(tree.names[group.leafOfRegion[r]], name + " (back)"))
          for (const std::uint32_t f : group.regions[r].faces) mount.faces.push_back(group.set.faces[f]);
    if (mount.faces.empty())
      for (const Face& face : faces)
        if (source.meshes[face.mesh].node == name) mount.faces.push_back(face);
    if (mount.faces.empty()) {
      std::vector<std::string> names = nodeNames(source);
      names.insert(names.end(), tree.names.begin(), tree.names.end());
      unknownName("--mount", name, names);
    }
    for (const Face& face : mount.faces)
      if (source.meshes[face.mesh].extras.siteSpacing)
        mount.spacing = *source.meshes[face.mesh].extras.siteSpacing;
    mounts.push_back(std::move(mount));
  }
}

/// The ceiling: the largest plane that faces down in the upper half, and others about as high.
std::vector<Mount> proposedMounts(const WeldedMesh& mesh, const SurfaceTree& tree,
                                  std::vector<std::string>& warnings) {
  double low = 1e300, high = -1e300;
  for (const Vec3& p : mesh.positions) low = std::min(low, p.y), high = std::max(high, p.y);
  struct Candidate {
    const SurfaceGroup* group;
    const Region* region;
    std::uint32_t leaf;
  };
  std::vector<Candidate> candidates;
  const Candidate* best = nullptr;
  for (const SurfaceGroup& group : tree.groups)
    for (std::size_t r = 0; r < group.regions.size(); ++r)
      if (group.regions[r].normal.y < -0.9 && group.regions[r].centroid.y > 0.5 * (low + high))
        candidates.push_back({&group, &group.regions[r], group.leafOfRegion[r]});
  const auto weight = [&](const Candidate& c) {  // what is called a ceiling counts more than a plain roof
    return c.region->area * (tree.names[c.leaf].find("eiling") != std::string::npos ? 4 : 1);
  };
  for (const Candidate& c : candidates)
    if (!best || weight(c) > weight(*best)) best = &c;
  std::vector<Mount> mounts;
  if (!best) return mounts;
  mounts.push_back({tree.names[best->leaf], {}, 0});
  double area = 0;
  for (const Candidate& c : candidates) {
    if (c.region->area < 0.1 * best->region->area ||
        std::abs(c.region->centroid.y - best->region->centroid.y) > 0.3)
      continue;
    area += c.region->area;
    for (const std::uint32_t f : c.region->faces) mounts[0].faces.push_back(c.group->set.faces[f]);
  }
  warnings.push_back("no mount is marked: luminaires are proposed to hang on '" + mounts[0].name + "' (" +
                     shortNumber(area) + " m2, " + shortNumber(best->region->centroid.y - low) +
                     " m up); choose with --mount");
  return mounts;
}

void addSites(const SourceScene& source, const WeldedMesh& mesh, const SurfaceTree& tree,
              const std::vector<Face>& faces, const RoomOptions& options, Room& room) {
  std::vector<Mount> mounts = markedMounts(source, faces);
  addNamedMounts(source, tree, faces, options.mounts, mounts);
  if (mounts.empty() && options.requireSites) {
    mounts = proposedMounts(mesh, tree, room.warnings);
    if (mounts.empty())
      throw CommandError(
          "nowhere to hang luminaires: no node is marked as mount and nothing large and high faces down; "
          "pass --mount with one of " +
          closestNames("ceiling", tree.names));
  }
  double area = 0;
  for (const Mount& mount : mounts) area += mountArea(mesh, mount.faces);
  const double sensible =
      std::clamp(std::round(std::sqrt(area / 256) / 0.05) * 0.05, 0.3, std::max(1.5, std::sqrt(area / 1000)));
  for (const Mount& mount : mounts) {
    const double spacing = options.siteSpacing > 0 ? options.siteSpacing
                           : mount.spacing > 0     ? mount.spacing
                                                   : sensible;
    const double size = options.siteSize > 0 ? options.siteSize : spacing;
    const double expected = mountArea(mesh, mount.faces) / (spacing * spacing);
    checkMemory(options, room.patches.count, room.patches.clusterCount, room.patches.rows(),
                static_cast<double>(room.sites.size()) + expected, 1);
    const std::vector<Site> sites = sitesOn(mesh, mount.faces, spacing, size);
    if (sites.empty())
      room.warnings.push_back("mount '" + mount.name + "' has no room for a whole square of " +
                              shortNumber(size) + " m; pass a smaller --site-spacing");
    room.sites.insert(room.sites.end(), sites.begin(), sites.end());
  }
  if (room.sites.empty() && options.requireSites)
    throw CommandError("no site fits on any mount (" +
                       (mounts.empty() ? "none" : "'" + mounts[0].name + "'") +
                       "): pass a smaller --site-spacing, or another --mount");
}

// --- the whole
// -------------------------------------------------------------------------------------------------------

void checkOptions(const RoomOptions& options) {
  const auto refuse = [](const char* what) {
    throw CommandError(std::string(what) + " must be positive and finite");
  };
  if (!(options.patch >= 0 && options.patch < 1e6)) refuse("--patch");
  if (options.cluster < 1 || options.cluster > 4096)
    throw CommandError("--cluster must be between 1 and 4096");
  if (!(options.siteSpacing >= 0 && options.siteSpacing < 1e6)) refuse("--site-spacing");
  if (!(options.siteSize >= 0 && options.siteSize < 1e6)) refuse("--site-size");
  if (!(options.memory > 0 && options.memory < 1e9)) refuse("--memory");
}

Room build(const SourceScene& source, const RoomOptions& options) {
  checkOptions(options);
  Room room;
  room.sourceHash = source.hash;
  room.warnings = source.warnings;
  const Roles roles = assignRoles(source, options, room.warnings);
  const WeldedMesh mesh = weld(source, roles.reflectors);
  if (mesh.triangles.empty())
    throw CommandError(
        roles.reflectors.empty()
            ? "no surfaces: everything is transparent or a measuring plane; give the walls an opaque material"
            : "no surfaces: every triangle has zero area; check the scale of the nodes");
  if (mesh.withoutArea > 0)
    room.warnings.push_back(std::to_string(mesh.withoutArea) + " triangles without area are left out");
  if (mesh.duplicates > 0)
    room.warnings.push_back(std::to_string(mesh.duplicates) + " triangles that repeat others are left out");
  warnOfScale(mesh, room.warnings);

  std::vector<Face> faces = frontFaces(mesh);
  const std::vector<Face> backs = backFaces(source, mesh);
  faces.insert(faces.end(), backs.begin(), backs.end());
  UniqueNames names;
  const SurfaceTree tree = findSurfaces(source, mesh, faces, 0.01, names);
  room.patchSize =
      options.patch > 0 ? options.patch : fittingPatchSize(source, mesh, tree, areaOf(mesh, faces));
  std::vector<ChartDraft> charts = makeCharts(mesh, tree, room.patchSize, 0);
  checkGrids(charts, options, room.patchSize);

  addSurfaces(tree, false, room);
  const ReflectanceMap reflectance(source);
  appendPatches(mesh, charts, room.patchSize, &reflectance, room);
  room.patches.count = room.patches.rows();
  addTriangles(mesh, charts, room);
  const std::uint32_t edge = assignClusters(room, options.cluster, kMostClusters, options.paper);
  if (edge != options.cluster)
    room.warnings.push_back("clusters are " + std::to_string(edge) + " x " + std::to_string(edge) +
                            " patches, so that there are at most 3000");
  addMeasuringPlanes(source, roles, room.patchSize, names, room);
  sumSurfaces(room);
  addSites(source, mesh, tree, faces, options, room);
  checkMemory(options, room.patches.count, room.patches.clusterCount, room.patches.rows(),
              static_cast<double>(room.sites.size()), static_cast<double>(room.surfaces.size()));
  return room;
}

}  // namespace

Result<Room> buildRoom(const SourceScene& source, const RoomOptions& options) {
  try {
    return build(source, options);
  } catch (const CommandError& error) {
    return Error{error.what()};
  } catch (const std::bad_alloc&) {
    return Error{"not enough memory for this room; pass a larger --patch"};
  }
}

}  // namespace fiatlux
