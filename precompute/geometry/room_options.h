// What a person may say about how a glTF becomes a room: the room's share of the options of `fiatlux
// precompute` and `fiatlux light`, and what those foresee of the light.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "core/scene/luminaire.h"
#include "precompute/rays/effort.h"
#include "precompute/room/memory.h"
#include "precompute/room/room.h"

namespace fiatlux {

/// What every material of a name reflects, whatever its file says.
struct NamedReflectance {
  std::string material;
  double value = 0;  // 0..kMostReflectance
};

/// Which axis of the file is up.
enum class UpAxis { kGuess, kY, kZ };

/// Which part of a building is the room.
struct PlaceOptions {
  std::optional<Vec3> inside;  // m, a point in its air, as the model stands after `scale` and `up`; none: all
  std::uint32_t doors = 0;     // open ones that one may pass from there
  enum class Lid { kNone, kDark, kWhite } lid = Lid::kNone;  // on what then stays open
};

struct RoomOptions {
  double patch = 0;  // m, edge of a patch; 0: so that n is about 25 000
  /// How many times as long they are to be, of rooms that would so consist of so many rows, sites and
  /// triangles; empty: once.
  std::function<double(double rows, double sites, double triangles)> coarser;
  std::uint32_t cluster = 4;  // patches on a cluster's edge
  std::vector<std::string>
      mounts;              // nodes, surfaces, patterns where luminaires may hang (besides extras.mount)
  double siteSpacing = 0;  // m; 0: what the extras say, else a sensible default
  double siteSize = 0;     // m, side of a site's square; 0: the spacing
  double drop = 0;         // m, that sites hang below their mounts; 0: what the extras say
  double ceiling = 0;      // m, of a plane of sites over the largest floor; 0: where there is no ceiling
  std::vector<std::string> measures;  // names of measuring planes (besides extras.measure)
  double scale = 0;                   // metres per unit of the file; 0: 1, or a guess where that is absurd
  double plane = 0;                   // m, of a measuring plane over the floor below the mounts; 0: none
  double planeRim = 0.5;              // m, that it stays away from the floor's edges
  UpAxis up = UpAxis::kGuess;         // y, but where the model would then lie on its back
  std::vector<NamedReflectance> reflectances;
  PlaceOptions place;
  bool doubleSided = false;           // every material is: fronts may look either way
  double memory = 4;                  // GB, refused above
  std::uint32_t rays = kUsualRays;    // per patch that will be cast later: only to foresee the memory
  unsigned threads = 1;               // that share the work, now and later
  bool exchange = false;              // that will be computed later: only to foresee the memory
  bool paper = false;                 // clusters stay exactly cluster x cluster, however many there are
  std::vector<Luminaire> luminaires;  // known beforehand: what they light stays, even if it faces the void
  bool requireSites = true;           // false: a room without a place to hang luminaires is fine
};

/// What the options alone say of a run.
inline RunCounts countsOf(const RoomOptions& options) {
  RunCounts counts;
  counts.rays = options.rays;
  counts.exchange = options.exchange;
  counts.paper = options.paper;
  counts.threads = options.threads;
  return counts;
}

/// And a room that is made, or being made.
inline RunCounts countsOf(const RoomOptions& options, const Room& room) {
  RunCounts counts = countsOf(options);
  counts.patches = room.patches.count;
  counts.clusters = room.patches.clusterCount;
  counts.rows = room.patches.rows();
  counts.sites = static_cast<double>(room.sites.size());
  counts.surfaces = static_cast<double>(room.surfaces.size());
  return counts;
}

}  // namespace fiatlux
