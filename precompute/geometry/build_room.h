// SourceScene -> Room: the stages in order. The only door by which geometry enters the light.
#pragma once

#include <string>

#include "core/base/result.h"
#include "precompute/geometry/room_options.h"
#include "precompute/gltf/source_scene.h"
#include "precompute/room/room.h"

namespace fiatlux {

/// Builds surfaces, patches and sites of a source scene. Errors name what is missing or too much, and the
/// cure.
Result<Room> buildRoom(const SourceScene& source, const RoomOptions& options);

}  // namespace fiatlux
