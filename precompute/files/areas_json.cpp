// Areas in plan from JSON; see areas_json.h.
#include "precompute/files/areas_json.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/scene/floor_plan.h"
#include "core/scene/zones.h"
#include "precompute/files/json_fields.h"
#include "precompute/files/terminal.h"

namespace fiatlux {
namespace {

constexpr std::size_t kMostAreas = 50, kMostCorners = 40;
constexpr double kFurthestInPlan = 1e5;     // m
constexpr double kSurround = 0.5;           // m, EN 12464-1
constexpr double kFurthestFromWalls = 100;  // m
constexpr double kOnEdge = 1e-6;            // m: on the line is inside

/// Does a point lie within an outline?
bool isInside(const std::vector<PlanPoint>& outline, const PlanPoint& p) {
  bool inside = false;
  for (std::size_t i = 0; i < outline.size(); ++i) {
    const PlanPoint &a = outline[i], &b = outline[(i + 1) % outline.size()];
    if ((a[1] > p[1]) != (b[1] > p[1]) && p[0] < a[0] + (p[1] - a[1]) / (b[1] - a[1]) * (b[0] - a[0]))
      inside = !inside;
  }
  return inside;
}

/// m from a point to the nearest edge.
double distanceTo(const std::vector<PlanPoint>& outline, const PlanPoint& p) {
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < outline.size(); ++i)
    least = std::min(least, distance(p, {outline[i], outline[(i + 1) % outline.size()]}));
  return least;
}

/// What the areas of one leaf make of its rows.
void addZones(const Scene& room, std::uint32_t leaf, const std::vector<const AskedArea*>& areas,
              std::vector<Zone>& zones) {
  std::vector<Zone> tasks, bands;
  for (const AskedArea* area : areas) {
    tasks.push_back({area->name, leaf, {}});
    bands.push_back({area->name + " surround", leaf, {}});
  }
  Zone rest{room.surfaces[leaf].name + " background", leaf, {}};
  for (std::uint32_t p = 0; p < room.patches.rows(); ++p) {
    if (room.patches.surface[p] != leaf || !room.patches.counts(p)) continue;
    const PlanPoint at = {room.patches.center[p].x, room.patches.center[p].z};
    bool isTask = false;
    std::size_t near = areas.size();
    for (std::size_t a = areas.size(); a-- > 0;) {
      if (isInside(areas[a]->outline, at)) {
        tasks[a].rows.push_back(p);
        isTask = true;
      }
      if (distanceTo(areas[a]->outline, at) <= kSurround) near = a;
    }
    if (!isTask) (near < areas.size() ? bands[near] : rest).rows.push_back(p);
  }
  zones.insert(zones.end(), tasks.begin(), tasks.end());
  bands.push_back(rest);
  std::copy_if(bands.begin(), bands.end(), std::back_inserter(zones),
               [](const Zone& zone) { return !zone.rows.empty(); });
}

using Outline = std::vector<PlanPoint>;

/// [[x, z], [x, z], [x, z]], the corners in their order.
Outline outlineOf(const JsonField& json) {
  Outline outline;
  for (const JsonField& corner : json.list(kMostCorners)) {
    const std::vector<double> at = corner.numbers(2, "[x, z]", -kFurthestInPlan, kFurthestInPlan);
    outline.push_back({at[0], at[1]});
  }
  if (outline.size() < 3) json.fail("an outline has three corners at least");
  return outline;
}

/// [x, z, farX, farZ].
Outline rectangleOf(const JsonField& json) {
  const std::vector<double> at = json.numbers(4, "[x, z, farX, farZ]", -kFurthestInPlan, kFurthestInPlan);
  if (at[0] >= at[2] || at[1] >= at[3]) json.fail("it has no extent; the smaller x and z come first");
  return {{at[0], at[1]}, {at[2], at[1]}, {at[2], at[3]}, {at[0], at[3]}};
}

std::vector<Outline> outlinesOf(const JsonField& json, const char* key) {
  std::vector<Outline> outlines;
  const auto list = json.find(key);
  if (!list) return outlines;
  for (const JsonField& entry : list->list(kMostAreas)) {
    const std::vector<JsonField> parts = entry.list(kMostCorners);
    outlines.push_back(!parts.empty() && parts[0].isList() ? outlineOf(entry) : rectangleOf(entry));
  }
  return outlines;
}

}  // namespace

std::vector<AskedArea> taskAreasOf(const JsonField& json) {
  std::vector<AskedArea> areas;
  for (const JsonField& entry : json.list(kMostAreas)) {
    entry.requireKeys({"name", "surface", "outline"});
    AskedArea area{entry.at("name", "call it something").text(),
                   entry.at("surface", "name the plane or floor that it is part of").text(),
                   {}};
    area.outline = outlineOf(entry.at("outline", "give its corners: [[x, z], [x, z], [x, z]]"));
    areas.push_back(std::move(area));
  }
  return areas;
}

Result<std::vector<Zone>> zonesOf(const Scene& room, const std::vector<AskedArea>& areas) {
  std::vector<Zone> zones;
  std::vector<std::vector<const AskedArea*>> ofLeaf(firstZone(room));
  for (const AskedArea& area : areas) {
    const auto leaf = std::find_if(room.surfaces.begin(), room.surfaces.begin() + firstZone(room),
                                   [&](const Surface& surface) { return surface.name == area.surface; });
    if (leaf == room.surfaces.begin() + firstZone(room))
      return Error{"area " + printable(area.name, 80) + ": there is no surface " +
                   printable(area.surface, 80)};
    ofLeaf[static_cast<std::size_t>(leaf - room.surfaces.begin())].push_back(&area);
  }
  for (std::uint32_t leaf = 0; leaf < ofLeaf.size(); ++leaf)
    if (!ofLeaf[leaf].empty()) addZones(room, leaf, ofLeaf[leaf], zones);
  return zones;
}

std::vector<std::uint32_t> sitesLeftOut(const Scene& room, const JsonField& json,
                                        const std::vector<std::uint32_t>& kept) {
  json.requireKeys({"keepOut", "keepIn", "fromWalls"});
  const std::vector<Outline> out = outlinesOf(json, "keepOut"), in = outlinesOf(json, "keepIn");
  const auto fromWalls = json.find("fromWalls");
  const double apart = fromWalls ? fromWalls->number(0, kFurthestFromWalls) : 0;
  const std::vector<PlanSegment> walls = apart > 0 ? floorEdges(room) : std::vector<PlanSegment>();
  std::vector<std::uint32_t> sites;
  for (std::uint32_t s = 0; s < room.sites.size(); ++s) {
    const PlanPoint at = {room.sites[s].position.x, room.sites[s].position.z};
    const auto holds = [&](const Outline& each) {
      return isInside(each, at) || distanceTo(each, at) < kOnEdge;
    };
    const auto isNear = [&](const PlanSegment& wall) { return distance(at, wall) < apart - kOnEdge; };
    const bool isIn = in.empty() || std::any_of(in.begin(), in.end(), holds);
    const bool isOut = !isIn || std::any_of(out.begin(), out.end(), holds) ||
                       std::any_of(walls.begin(), walls.end(), isNear);
    if (isOut && std::find(kept.begin(), kept.end(), s) == kept.end()) sites.push_back(s);
  }
  return sites;
}

}  // namespace fiatlux
