#include "precompute/geometry/small_parts.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "precompute/room/bounds.h"

namespace fiatlux {
namespace {

constexpr double kLeastPlan = 2, kLeastHeight = 1.5;  // m2, m: what is smaller is no room
constexpr std::size_t kMostRooms = 64;
constexpr double kApart = 1;      // m, between floors: another storey
constexpr double kAbout = 0.15;   // m, and a cube: so near to the floor or the ceiling it belongs to it
constexpr double kUpright = 0.7;  // sine of 45 degrees

/// The step at which most columns begin, or end.
int mostOften(const std::vector<int>& counts) {
  return static_cast<int>(std::max_element(counts.begin(), counts.end()) - counts.begin());
}

}  // namespace

/// Plan, floor and ceiling of each space, by the columns of its cubes.
void SmallParts::measure(std::vector<OneRoom>& rooms) const {
  const CubeGrid& grid = spaces_->grid();
  const auto tall = static_cast<std::size_t>(grid.count[1]);
  std::vector<std::vector<int>> begins(rooms.size(), std::vector<int>(tall)), ends = begins;
  std::vector<std::size_t> counted(rooms.size(), std::numeric_limits<std::size_t>::max());
  const auto isNew = [&](std::uint32_t space, std::size_t column) {
    return std::exchange(counted[space], column) != column;
  };
  for (std::size_t first = 0; first < grid.size(); ++first) {
    if (first / grid.stride(1) % tall != 0) continue;
    const auto spaceAt = [&](std::size_t y) { return spaces_->of(first + y * grid.stride(1)); };
    for (std::size_t y = 0; y < tall; ++y)
      if (isNew(spaceAt(y), 2 * first))
        ++begins[spaceAt(y)][y], rooms[spaceAt(y)].area += grid.edge * grid.edge;
    for (std::size_t y = tall; y-- > 0;)
      if (isNew(spaceAt(y), 2 * first + 1)) ++ends[spaceAt(y)][y];
  }
  for (std::size_t space = 0; space < rooms.size(); ++space) {
    rooms[space].floor = grid.cornerAt({0, mostOften(begins[space]), 0}).y;
    rooms[space].ceiling = grid.cornerAt({0, mostOften(ends[space]) + 1, 0}).y;
  }
}

/// The spaces that are rooms, by storeys from the lowest; in each the largest first.
std::vector<std::vector<std::uint32_t>> SmallParts::storeys() const {
  std::vector<std::uint32_t> order;
  for (std::uint32_t space = Spaces::kOutdoors + 1; space < rooms_.size(); ++space)
    if (const OneRoom& room = rooms_[space];
        room.area >= kLeastPlan && room.ceiling - room.floor >= kLeastHeight)
      order.push_back(space);
  const auto isLarger = [&](std::uint32_t a, std::uint32_t b) { return rooms_[a].area > rooms_[b].area; };
  std::stable_sort(order.begin(), order.end(), isLarger);
  if (order.size() > kMostRooms) order.resize(kMostRooms);
  std::stable_sort(order.begin(), order.end(),
                   [&](std::uint32_t a, std::uint32_t b) { return rooms_[a].floor < rooms_[b].floor; });
  std::vector<std::vector<std::uint32_t>> result;
  for (const std::uint32_t space : order) {
    if (result.empty() || rooms_[space].floor > rooms_[result.back()[0]].floor + kApart)
      result.emplace_back();
    result.back().push_back(space);
  }
  for (auto& storey : result) std::stable_sort(storey.begin(), storey.end(), isLarger);
  return result;
}

/// "storey 2/room 1", without what there is but one of.
void SmallParts::nameRooms() {
  const auto all = storeys();
  const bool isOne = all.size() == 1 && all[0].size() == 1;
  for (std::size_t s = 0; s < all.size(); ++s)
    for (std::size_t r = 0; r < all[s].size(); ++r)
      rooms_[all[s][r]].path = (all.size() > 1 ? "storey " + std::to_string(s + 1) + "/" : "") +
                               (isOne ? "room" : "room " + std::to_string(r + 1));
}

void SmallParts::findRooms() {
  isFound_ = true;
  if (!Spaces::canTell(source_)) return;
  spaces_.emplace(source_);
  rooms_.resize(Spaces::kOutdoors + 1 + spaces_->count());
  measure(rooms_);
  nameRooms();
  for (const SourceMesh& mesh : source_.meshes) {
    const Bounds bounds = boundsOf(mesh.positions);
    const auto [found, isFresh] = heights_.try_emplace(mesh.nodeIndex, bounds.low.y, bounds.high.y);
    found->second = {std::min(found->second.first, bounds.low.y),
                     std::max(found->second.second, bounds.high.y)};
  }
}

const SmallParts::OneRoom* SmallParts::roomBefore(const WeldedMesh& mesh, const Face& face,
                                                  const Vec3& normal) const {
  const CubeGrid& grid = spaces_->grid();
  const Vec3 middle = (1.0 / 3) * (mesh.positions[face.vertex[0]] + mesh.positions[face.vertex[1]] +
                                   mesh.positions[face.vertex[2]]);
  const Vec3 clear = kClearOfPlane * grid.edge * normal;
  // Where something stands before its middle, towards its corners. No farther away: beyond is another room.
  for (const double toCorner : {0.0, 0.5, 0.9})
    for (const std::uint32_t v : face.vertex) {
      const Vec3 from = middle + toCorner * (mesh.positions[v] - middle);
      const std::uint32_t space = spaces_->of(grid.indexOf(grid.stepsTo(from + clear)));
      if (space != Spaces::kNowhere) return rooms_[space].path.empty() ? nullptr : &rooms_[space];
    }
  return nullptr;
}

std::string SmallParts::nameOf(const WeldedMesh& mesh, const Face& face) {
  if (!isFound_) findRooms();
  if (!spaces_) return kSmallThings;
  const Vec3 normal = normalized(areaVector(mesh.positions, face.vertex));
  const OneRoom* room = roomBefore(mesh, face, normal);
  if (!room) return kSmallThings;
  const double about = kAbout + spaces_->grid().edge, height = mesh.positions[face.vertex[0]].y;
  const double low = room->floor + about, high = room->ceiling - about;
  if (normal.y > kUpright && height <= low) return room->path + "/floor";
  if (normal.y < -kUpright && height >= high) return room->path + "/ceiling";
  const auto [from, to] = heights_.at(source_.meshes[face.mesh].nodeIndex);
  const bool isAsHigh = from <= low && to >= high;
  if (std::abs(normal.y) <= kUpright && isAsHigh) return room->path + "/walls";
  return room->path + "/things";
}

}  // namespace fiatlux
