// Surfaces from nodes, materials and planes.
#include "precompute/geometry/surfaces.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <tuple>

#include "precompute/room/bounds.h"

namespace fiatlux {
namespace {

constexpr std::size_t kMostNodes = 256;  // with more surfaces than this, small nodes share one
constexpr double kSmallNode = 0.005;     // of the scene's area
constexpr double kOnePlane = 0.995;      // of a group's area: then the group is that plane
constexpr double kShattered = 0.2;       // of a group's area in planes worth a name: it may be a scan
constexpr double kMended = 0.5;          // so much as a scan: it is one

/// What makes faces one group.
struct GroupKey {
  enum class Kind { kNamed, kNode, kSmallNodes } kind = Kind::kNode;
  std::uint32_t id = 0;  // of the name or node
  int material = -1;     // only where a node has several
  bool back = false;
  auto operator<=>(const GroupKey&) const = default;
};

struct Draft {
  std::string name;
  std::vector<Face> faces;
  bool back = false;
  bool splits = true;     // may be cut into regions
  bool isShared = false;  // has its leaf together with others of its name
};

/// Sorts faces into groups: by the surface that extras name, else by node and material, but for the small
/// nodes of a crowded scene, which go by the rooms that see them, or are one group.
class Grouper {
 public:
  /// Takes the names first that the file's author gave on purpose.
  Grouper(const SourceScene& source, const WeldedMesh& mesh, const std::vector<Face>& faces,
          UniqueNames& names, SmallParts* smallParts)
      : source_(source), mesh_(mesh), names_(names), smallParts_(smallParts) {
    for (const Face& face : faces) {
      const SourceMesh& from = source.meshes[face.mesh];
      const double area = length(areaVector(mesh.positions, face.vertex));
      area_ += area;
      if (!from.extras.surface.empty()) {
        named_.try_emplace(from.extras.surface);
        continue;
      }
      Node& node = nodes_[from.nodeIndex];
      node.area += area;
      if (std::find(node.materials.begin(), node.materials.end(), from.material) == node.materials.end())
        node.materials.push_back(from.material);
    }
    std::uint32_t count = 0;
    for (auto& [name, surface] : named_) surface = {count++, names.take(name)};
  }

  double area() const { return area_; }  // m2, of all faces
  std::size_t nodes() const { return nodes_.size(); }
  bool isCrowded() const { return nodes_.size() > kMostNodes; }

  /// In the order in which they are met, fronts before backs; `splits`: nodes may be cut into regions.
  std::vector<Draft> drafts(const std::vector<Face>& faces, bool splits) {
    std::vector<Draft> drafts;
    std::map<GroupKey, std::size_t> known;
    for (const Face& face : faces) {
      const GroupKey key = keyOf(face);
      const auto [found, fresh] = known.emplace(key, drafts.size());
      if (fresh)
        drafts.push_back({nameOf(key, source_.meshes[face.mesh]),
                          {},
                          key.back,
                          splits && key.kind == GroupKey::Kind::kNode,
                          smallParts_ && key.kind == GroupKey::Kind::kSmallNodes});
      drafts[found->second].faces.push_back(face);
    }
    std::stable_sort(drafts.begin(), drafts.end(),
                     [](const Draft& x, const Draft& y) { return x.back < y.back; });
    return drafts;
  }

 private:
  struct Named {
    std::uint32_t id = 0;
    std::string name;  // unique
  };
  struct Node {
    double area = 0;             // m2
    std::vector<int> materials;  // in order of appearance
    std::string name = {};       // unique, "" until it is asked for
  };

  GroupKey keyOf(const Face& face) {
    const SourceMesh& from = source_.meshes[face.mesh];
    GroupKey key;
    key.back = face.back && mesh_.triangles[face.triangle].backMesh == kNone;
    if (!from.extras.surface.empty()) {
      key.kind = GroupKey::Kind::kNamed;
      key.id = named_.at(from.extras.surface).id;
      return key;
    }
    const Node& node = nodes_.at(from.nodeIndex);
    if (isCrowded() && node.area < kSmallNode * area_) {
      key.kind = GroupKey::Kind::kSmallNodes;
      const std::string name = smallParts_ ? smallParts_->nameOf(mesh_, face) : kSmallThings;
      const auto [found, fresh] = smallIds_.emplace(name, static_cast<std::uint32_t>(smallNames_.size()));
      if (fresh) smallNames_.push_back(names_.take(name));
      key.id = found->second;
      return key;
    }
    key.id = from.nodeIndex;
    if (node.materials.size() > 1) key.material = from.material;
    return key;
  }

  std::string nameOf(const GroupKey& key, const SourceMesh& from) {
    if (key.kind == GroupKey::Kind::kNamed) return named_.at(from.extras.surface).name;
    if (key.kind == GroupKey::Kind::kSmallNodes) return smallNames_[key.id];
    Node& node = nodes_[from.nodeIndex];
    if (node.name.empty()) node.name = names_.take(from.node);
    if (node.materials.size() == 1) return node.name;
    return node.name + "/" + (from.material < 0 ? "default material" : source_.materials[from.material].name);
  }

  const SourceScene& source_;
  const WeldedMesh& mesh_;
  UniqueNames& names_;
  SmallParts* smallParts_;
  std::map<std::uint32_t, Node> nodes_;  // those whose extras name no surface
  std::map<std::string, Named> named_;
  std::map<std::string, std::uint32_t> smallIds_;  // by what the small parts are called
  std::vector<std::string> smallNames_;            // unique
  double area_ = 0;
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

/// Gives the regions of groups their leaves. Fronts come first: the back of 'x' is 'x (back)'.
class Leaves {
 public:
  Leaves(const WeldedMesh& mesh, SurfaceTree& tree, UniqueNames& names)
      : tree_(tree), names_(names), leafOfTriangle_(mesh.triangles.size(), kNone) {}

  /// `words` of its regions as regionWords gives them, all "" where the group stays whole.
  void addFronts(const std::string& name, const std::vector<std::string>& words, SurfaceGroup& group) {
    const bool split =
        std::any_of(words.begin(), words.end(), [](const std::string& word) { return !word.empty(); });
    std::map<std::string, std::uint32_t> leafOfWord;
    for (const std::string& word : std::set<std::string>(words.begin(), words.end()))
      leafOfWord[word] = addLeaf(!split ? name : name + "/" + (word.empty() ? "rest" : word));
    for (std::size_t r = 0; r < group.regions.size(); ++r) {
      group.leafOfRegion.push_back(leafOfWord[words[r]]);
      for (const std::uint32_t f : group.regions[r].faces)
        leafOfTriangle_[group.set.faces[f].triangle] = group.leafOfRegion[r];
    }
  }

  /// All of one name are one leaf, fronts and backs: of a thin wall each side belongs to the room before it.
  void addShared(const std::string& name, SurfaceGroup& group) {
    const auto [found, fresh] = shared_.emplace(name, static_cast<std::uint32_t>(tree_.names.size()));
    if (fresh) tree_.names.push_back(name);
    group.leafOfRegion.assign(group.regions.size(), found->second);
  }

  void addBacks(SurfaceGroup& group) {
    for (const Region& region : group.regions) {
      const std::uint32_t front = leafOfTriangle_[group.set.faces[region.faces[0]].triangle];
      const auto [found, fresh] = backOfLeaf_.emplace(front, static_cast<std::uint32_t>(tree_.names.size()));
      if (fresh) tree_.names.push_back(names_.take(tree_.names[front] + " (back)"));
      group.leafOfRegion.push_back(found->second);
    }
  }

 private:
  std::uint32_t addLeaf(const std::string& name) {
    // note: a plain name was reserved when it was handed out, a path was not
    const bool reserved = name.find('/') == std::string::npos;
    tree_.names.push_back(reserved ? name : names_.take(name));
    return static_cast<std::uint32_t>(tree_.names.size() - 1);
  }

  SurfaceTree& tree_;
  UniqueNames& names_;
  std::vector<std::uint32_t> leafOfTriangle_;  // of its front
  std::map<std::uint32_t, std::uint32_t> backOfLeaf_;
  std::map<std::string, std::uint32_t> shared_;
};

/// Whether one plane is all of a group but for crumbs.
bool isOnePlane(const SurfaceGroup& group) {
  double area = 0, largest = 0;
  for (const Region& region : group.regions) area += region.area, largest = std::max(largest, region.area);
  return largest >= kOnePlane * area;
}

/// The planes of a group; of a scan, whose triangles all look their own way, those that they are meant to be.
std::vector<Region> planesOfGroup(const WeldedMesh& mesh, const FaceSet& set, bool splits, double least) {
  std::vector<Region> planes = flatRegions(mesh, set);
  const auto worthAName = [&](const std::vector<Region>& regions) {
    double area = 0, large = 0;
    for (const Region& region : regions) area += region.area, large += region.area > least ? region.area : 0;
    return area > 0 ? large / area : 0;
  };
  if (!splits || worthAName(planes) >= kShattered) return planes;
  std::vector<Region> scanned = flatRegions(mesh, set, Flatness::kScanned);
  return worthAName(scanned) >= kMended ? scanned : planes;
}

}  // namespace

double areaOf(const SurfaceTree& tree) {
  double area = 0;
  for (const SurfaceGroup& group : tree.groups)
    for (const Region& region : group.regions) area += region.area;
  return area;
}

SurfaceTree findSurfaces(const SourceScene& source, const WeldedMesh& mesh, const std::vector<Face>& faces,
                         double regionShare, UniqueNames& names, SmallParts* smallParts) {
  Grouper grouper(source, mesh, faces, names, smallParts);
  SurfaceTree tree;
  if (grouper.isCrowded())
    tree.warnings.push_back(std::to_string(grouper.nodes()) + " nodes: those below 0.5 % of the area are " +
                            (smallParts ? "the floor, walls, ceiling or things of the room that they are in"
                                        : std::string("one surface, '") + kSmallThings + "'"));
  Leaves leaves(mesh, tree, names);
  for (Draft& draft : grouper.drafts(faces, regionShare > 0)) {
    SurfaceGroup group;
    group.set = makeFaceSet(mesh, std::move(draft.faces));
    group.regions = planesOfGroup(mesh, group.set, draft.splits && !draft.back, regionShare * grouper.area());
    std::vector<std::string> words(group.regions.size());
    if (draft.splits && !draft.back && !isOnePlane(group))
      words = regionWords(mesh, group, regionShare * grouper.area());
    if (draft.isShared)
      leaves.addShared(draft.name, group);
    else if (draft.back)
      leaves.addBacks(group);
    else
      leaves.addFronts(draft.name, words, group);
    tree.groups.push_back(std::move(group));
  }
  return tree;
}

}  // namespace fiatlux
