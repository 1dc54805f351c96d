// Scenes from formulas, as the glTF front would hand them over: the analytic cases go through the whole
// pipeline.
#pragma once

#include <string>
#include <vector>

#include "core/base/result.h"
#include "precompute/gltf/source_scene.h"
#include "precompute/rays/ray_tracer.h"
#include "precompute/validation/rectangle_room.h"

namespace fiatlux {

/// One node a rectangle; columns and rows are ignored (the room's patch size decides).
SourceScene sceneOfRectangles(const std::vector<RectangleSurface>& rectangles);
/// A disc of `sides` corners around `center`, its front along `normal`.
SourceMesh discMesh(const std::string& name, const Vec3& center, const Vec3& normal, double radius,
                    std::uint32_t sides);
/// A sphere seen from inside, of 2 x rings by rings quadrangles.
SourceMesh sphereMesh(const std::string& name, const Vec3& center, double radius, std::uint32_t rings);

/// Surfaces, patches of about `patch` metres; no sites needed.
Result<TracedRoom> roomOf(const SourceScene& scene, double patch);

}  // namespace fiatlux
