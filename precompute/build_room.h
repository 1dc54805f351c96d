// SourceScene -> Room: the stages in order. The only door by which geometry enters the light.
#pragma once

#include <string>

#include "core/result.h"
#include "precompute/room.h"
#include "precompute/room_options.h"
#include "precompute/source_scene.h"

namespace fiatlux {

/// Builds surfaces, patches and sites of a source scene. Errors name what is missing or too much, and the
/// cure.
Result<Room> buildRoom(const SourceScene& source, const RoomOptions& options);

}  // namespace fiatlux
