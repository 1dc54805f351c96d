// Scene files on this side: zlib around the core's reader and writer.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "core/base/result.h"
#include "core/scene/scene.h"
#include "core/scene/scene_file.h"
#include "precompute/pipeline/scene_build.h"

namespace fiatlux {

/// Inflates a section of a checked file to exactly the size its line declares, and checks it; stops as soon
/// as more would come out.
Result<std::vector<std::uint8_t>> inflateSection(std::span<const std::uint8_t> file,
                                                 const SceneSection& section);

/// A whole file to a Scene. Errors without a file name.
Result<Scene> readScene(std::span<const std::uint8_t> file);

/// The same from a path; errors begin with the path.
Result<Scene> readSceneFile(const std::string& path);

/// A zlib stream of at most 4 GB at the highest level; empty where zlib fails.
std::vector<std::uint8_t> zlibDeflate(std::span<const std::uint8_t> bytes, DeflateKind kind);

}  // namespace fiatlux
