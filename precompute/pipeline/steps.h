// The steps that makeScene and SceneParts share. They throw, as everything below a door does.
#pragma once

#include <string>

#include "precompute/pipeline/pipeline.h"

namespace fiatlux {

inline constexpr const char* kNoMemory = "not enough memory; pass a larger --patch or fewer --rays";

/// The options as the room and the light are to see them: what is said once holds for both.
SceneOptions consistent(SceneOptions options, const Host& host);

OpenedRoom opened(const ModelFile& model, const RoomOptions& options, const Host& host);

/// The scene file of a room whose light is known. `name`: of the model's file. Of the transport its form
/// factors are left.
MadeScene fileOf(const std::string& name, const SourceScene& source, const Room& room, Transport&& transport,
                 const SceneOptions& options, const Host& host);

}  // namespace fiatlux
