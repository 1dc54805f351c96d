// What surfaces a model has and what they would be good for, before anything is computed.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "precompute/geometry/room_options.h"
#include "precompute/gltf/source_scene.h"

namespace fiatlux {

struct SurveyedSurface {
  std::string name;
  double area = 0;           // m2
  double low = 0, high = 0;  // m, over the lowest point of the model
  double tilt = 0;           // degrees from level, 0 to 90, of its mean normal
  enum class Facing { kUp, kDown, kSideways, kAllWays } facing = Facing::kAllWays;
  enum class Use { kNone, kMount, kFloor, kMeasuringPlane } use = Use::kNone;  // suggested, or marked so
};

struct Survey {
  std::vector<SurveyedSurface> surfaces;  // of the room and its measuring planes, largest first
  std::vector<std::string> warnings;      // where luminaires would hang comes first
  Vec3 size;                              // m, of all that reflects
  double scale = 1;                       // metres per unit of the file
  bool isZUp = false;                     // z of the file is up, not y
  double patch = 0;                       // m, edge of a patch, as it would be cut
  double rows = 0;                        // patches and receivers foreseen
  std::uint32_t triangles = 0;            // that light may meet
  std::uint32_t sites = 0;                // that would hang there
  double lost = 0;  // share of the mounts' light that leaves the model or meets backs before it is reflected
};

/// Errors as of buildRoom.
Result<Survey> surveyRoom(const SourceScene& source, const RoomOptions& options);

}  // namespace fiatlux
