// Paint that a layout or intentions ask for: surfaces by name, and what they reflect.
#pragma once

#include <string>
#include <vector>

#include "core/base/result.h"
#include "core/scene/scene.h"
#include "core/transport/repaint.h"
#include "precompute/files/json_fields.h"

namespace fiatlux {

struct NamedPaint {
  std::string surface;  // or an inner node: all leaves below it
  double reflectance = 0;
};

/// [{"surface", "reflectance"}].
std::vector<NamedPaint> paintOf(const JsonField& field);

/// On the leaves of a room. An error where a name is not there, or means a measuring plane.
Result<std::vector<SurfacePaint>> paintOnLeaves(const std::vector<NamedPaint>& paint,
                                                const std::vector<Surface>& surfaces);

/// Sets what the patches and surfaces reflect.
void setReflectance(const std::vector<SurfacePaint>& paint, Patches& patches, std::vector<Surface>& surfaces);

/// Light (lx, rows) of the scene as it is read becomes that of the painted one, and so does the scene itself;
/// its responses and statistics stay as they were. An error where paint is asked for and the scene has no
/// light operator.
Result<Done> paintScene(const std::vector<NamedPaint>& paint, Scene& scene, std::vector<float>& light);

}  // namespace fiatlux
