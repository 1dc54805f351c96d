// SourceScene -> Room: the stages in order. The only door by which geometry enters the light.
#pragma once

#include <string>

#include "core/base/result.h"
#include "precompute/geometry/room_options.h"
#include "precompute/gltf/source_scene.h"
#include "precompute/rays/ray_tracer.h"

namespace fiatlux {

/// Builds surfaces, patches and sites of a source scene, and the ray tracer that everything later asks.
/// Errors name what is missing or too much, and the cure.
Result<TracedRoom> buildTracedRoom(const SourceScene& source, const RoomOptions& options);

/// The room alone, for who casts no rays.
Result<Room> buildRoom(const SourceScene& source, const RoomOptions& options);

}  // namespace fiatlux
