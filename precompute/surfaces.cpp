// Surfaces from nodes, materials and planes.
#include "precompute/surfaces.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <tuple>

#include "precompute/bounds.h"

namespace fiatlux {
namespace {

constexpr std::size_t kMostNodes = 256;  // with more surfaces than this, small nodes share one
constexpr double kOnePlane = 0.995;      // of a group's area: then the group is that plane

/// What makes faces one group.
struct GroupKey {
  int kind = 0;          // 0 named surface, 1 node, 2 the small nodes of a crowded scene
  std::uint32_t id = 0;  // of the name or node
  int material = -1;     // only where a node has several
  bool back = false;
  auto operator<=>(const GroupKey&) const = default;
};

struct Draft {
  std::string name;
  std::vector<Face> faces;
  bool splits = true;  // may be cut into regions
};

/// The word for a plane of a group, before numbering; `middle` and `lowestFloor` are heights, m.
std::string wordFor(const Region& region, double middle, bool roomLike, double lowestFloor) {
  if (region.normal.y > 0.7)
    return roomLike && region.centroid.y < lowestFloor + 0.5 && region.centroid.y <= middle + 1e-9 ? "floor"
                                                                                                   : "top";
  if (region.normal.y < -0.7) return roomLike && region.centroid.y >= middle ? "ceiling" : "underside";
  if (std::abs(region.normal.y) > 0.3) return "slope";
  return roomLike ? "wall" : "side";
}

/// Names of the large planes of a group, "floor", "wall 1"...; "" for the others.
std::vector<std::string> regionWords(const WeldedMesh& mesh, const SurfaceGroup& group, double least) {
  Bounds bounds;
  for (const Face& face : group.set.faces)
    for (const std::uint32_t v : face.vertex) bounds.include(mesh.positions[v]);
  const bool roomLike = bounds.diagonal() > 0.5 * mesh.diagonal;
  const double middle = 0.5 * (bounds.low.y + bounds.high.y);
  double lowestFloor = 1e300;
  for (const Region& region : group.regions)
    if (region.area > least && region.normal.y > 0.7) lowestFloor = std::min(lowestFloor, region.centroid.y);

  // Number equal words in an order that depends on the geometry only: by direction, then by place.
  std::map<std::string, std::vector<std::uint32_t>> byWord;
  for (std::uint32_t r = 0; r < group.regions.size(); ++r)
    if (group.regions[r].area > least)
      byWord[wordFor(group.regions[r], middle, roomLike, lowestFloor)].push_back(r);
  std::vector<std::string> words(group.regions.size());
  for (auto& [word, members] : byWord) {
    const auto key = [&](std::uint32_t r) {
      const Region& region = group.regions[r];
      const auto rounded = [](double x) { return std::round(x * 100); };
      return std::tuple(std::round(std::atan2(region.normal.x, region.normal.z) * 50),
                        rounded(region.centroid.y), rounded(region.centroid.z), rounded(region.centroid.x));
    };
    std::sort(members.begin(), members.end(),
              [&](auto a, auto b) { return std::pair(key(a), a) < std::pair(key(b), b); });
    for (std::size_t i = 0; i < members.size(); ++i)
      words[members[i]] = members.size() == 1 ? word : word + " " + std::to_string(i + 1);
  }
  return words;
}

struct NodeFacts {
  double area = 0;
  std::vector<int> materials;  // in order of appearance
};

}  // namespace

double areaOf(const SurfaceTree& tree) {
  double area = 0;
  for (const SurfaceGroup& group : tree.groups)
    for (const Region& region : group.regions) area += region.area;
  return area;
}

SurfaceTree findSurfaces(const SourceScene& source, const WeldedMesh& mesh, const std::vector<Face>& faces,
                         double regionShare, UniqueNames& names) {
  // Gather facts of nodes, and the named surfaces.
  std::map<std::uint32_t, NodeFacts> nodes;
  std::map<std::string, std::uint32_t> namedIds;
  double total = 0;
  for (const Face& face : faces) {
    const SourceMesh& from = source.meshes[face.mesh];
    const double area = length(areaVector(mesh.positions, face.vertex));
    total += area;
    if (!from.extras.surface.empty()) {
      namedIds.emplace(from.extras.surface, 0);
      continue;
    }
    NodeFacts& facts = nodes[from.nodeIndex];
    facts.area += area;
    if (std::find(facts.materials.begin(), facts.materials.end(), from.material) == facts.materials.end())
      facts.materials.push_back(from.material);
  }
  const bool crowded = nodes.size() > kMostNodes;
  SurfaceTree tree;
  if (crowded)
    tree.warnings.push_back(std::to_string(nodes.size()) +
                            " nodes: those below 0.5 % of the area are one surface, 'small things'");

  // Names first for what the file's author named on purpose, then for nodes as they come.
  std::map<GroupKey, Draft> drafts;
  std::map<std::uint32_t, std::string> nodeNames;
  std::string smallName;
  std::uint32_t count = 0;
  std::map<std::string, std::string> namedNames;
  for (auto& [name, id] : namedIds) {
    id = count++;
    namedNames[name] = names.take(name);
  }
  std::vector<std::pair<std::size_t, GroupKey>> order;
  std::size_t position = 0;
  for (const Face& face : faces) {
    const SourceMesh& from = source.meshes[face.mesh];
    GroupKey key;
    key.back = face.back && mesh.triangles[face.triangle].backMesh == kNone;
    const NodeFacts* facts = nullptr;
    if (!from.extras.surface.empty()) {
      key.id = namedIds[from.extras.surface];
    } else {
      facts = &nodes[from.nodeIndex];
      key.kind = crowded && facts->area < 0.005 * total ? 2 : 1;
      key.id = key.kind == 1 ? from.nodeIndex : 0;
      if (key.kind == 1 && facts->materials.size() > 1) key.material = from.material;
    }
    Draft& draft = drafts[key];
    if (draft.name.empty()) {
      order.emplace_back(position++, key);
      draft.splits = key.kind == 1 && regionShare > 0;
      if (key.kind == 0) {
        draft.name = namedNames[from.extras.surface];
      } else if (key.kind == 2) {
        if (smallName.empty()) smallName = names.take("small things");
        draft.name = smallName;
      } else {
        std::string& nodeName = nodeNames[from.nodeIndex];
        if (nodeName.empty()) nodeName = names.take(from.node);
        draft.name = nodeName;
        if (facts->materials.size() > 1)
          draft.name += "/" + (from.material < 0 ? "default material" : source.materials[from.material].name);
      }
    }
    draft.faces.push_back(face);
  }

  // Cut groups into leaves. Backs follow the leaf of their front, so that 'x (back)' is the back of 'x'.
  std::stable_sort(order.begin(), order.end(),
                   [](const auto& a, const auto& b) { return a.second.back < b.second.back; });
  std::vector<std::uint32_t> leafOfTriangle(mesh.triangles.size(), kNone);
  std::map<std::uint32_t, std::uint32_t> backOfLeaf;
  for (const auto& entry : order) {
    Draft& draft = drafts[entry.second];
    SurfaceGroup group;
    group.set = makeFaceSet(mesh, std::move(draft.faces));
    group.regions = flatRegions(mesh, group.set);
    group.leafOfRegion.assign(group.regions.size(), kNone);
    if (entry.second.back) {
      for (std::size_t r = 0; r < group.regions.size(); ++r) {
        const std::uint32_t front = leafOfTriangle[group.set.faces[group.regions[r].faces[0]].triangle];
        const auto [found, fresh] = backOfLeaf.emplace(front, static_cast<std::uint32_t>(tree.names.size()));
        if (fresh) tree.names.push_back(names.take(tree.names[front] + " (back)"));
        group.leafOfRegion[r] = found->second;
      }
    } else {
      double area = 0, largest = 0;
      for (const Region& region : group.regions)
        area += region.area, largest = std::max(largest, region.area);
      std::vector<std::string> words(group.regions.size());
      if (draft.splits && largest < kOnePlane * area) words = regionWords(mesh, group, regionShare * total);
      const bool split =
          std::any_of(words.begin(), words.end(), [](const std::string& w) { return !w.empty(); });
      std::map<std::string, std::uint32_t> leafOfWord;
      std::vector<std::string> sorted(words);
      std::sort(sorted.begin(), sorted.end());
      for (const std::string& word : sorted) {
        if (leafOfWord.count(word)) continue;
        const std::string name = !split ? draft.name : draft.name + "/" + (word.empty() ? "rest" : word);
        leafOfWord[word] = static_cast<std::uint32_t>(tree.names.size());
        // note: a plain name was reserved when it was handed out, a path was not
        const bool reserved = name.find('/') == std::string::npos;
        tree.names.push_back(reserved ? name : names.take(name));
      }
      for (std::size_t r = 0; r < group.regions.size(); ++r) {
        group.leafOfRegion[r] = leafOfWord[words[r]];
        for (const std::uint32_t f : group.regions[r].faces)
          leafOfTriangle[group.set.faces[f].triangle] = group.leafOfRegion[r];
      }
    }
    tree.groups.push_back(std::move(group));
  }
  return tree;
}

}  // namespace fiatlux
