// Scene files on this side: zlib around the core's reader and writer.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "core/result.h"
#include "core/scene.h"
#include "core/scene_file.h"

namespace fiatlux {

/// Inflates a section of a checked file to exactly the size its line declares, and checks it; stops as soon
/// as more would come out.
Result<std::vector<std::uint8_t>> inflateSection(std::span<const std::uint8_t> file,
                                                 const SceneSection& section);

/// A whole file to a Scene. Errors without a file name.
Result<Scene> readScene(std::span<const std::uint8_t> file);

/// The same from a path; errors begin with the path.
Result<Scene> readSceneFile(const std::string& path);

/// Sections deflated where that makes them smaller (and, beyond 1 MB, within the ratio that the reader
/// allows).
std::vector<StoredSection> deflateSections(std::vector<PlainSection> sections);

}  // namespace fiatlux
