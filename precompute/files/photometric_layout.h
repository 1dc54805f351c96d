// Layouts with luminaires of photometric files, on the sites of a scene.
#pragma once

#include <string>
#include <vector>

#include "core/base/result.h"
#include "core/scene/observer.h"
#include "core/scene/scene.h"
#include "precompute/files/layout_json.h"

namespace fiatlux {

/// Whether any luminaire has a photometric file.
bool hasPhotometry(const LayoutFile& file);

/// Illuminance (lx) of every row: luminaires of photometric files by the scene's light operator, the others
/// by its responses. `layout` is that of the same file (layoutOnSites). Notes say which luminaire does not
/// fit where it hangs. Where the file asks for direct light, that alone. An error where the scene has no
/// operator.
Result<std::vector<float>> photometricIlluminance(const LayoutFile& file, const Layout& layout,
                                                  const Scene& scene, std::vector<std::string>& notes);

/// What observers see of a layout of that file whose light (lx, rows) is known. An error where the scene has
/// no operator.
Result<std::vector<ObserverReading>> observerReadings(const LayoutFile& file, const Layout& layout,
                                                      const Scene& scene,
                                                      const std::vector<Observer>& observers,
                                                      const std::vector<float>& light);

/// Likewise what is told of the measuring planes that the file asks for; an error also where one is none.
Result<std::vector<PlaneReading>> planeReadings(const LayoutFile& file, const Layout& layout,
                                                const Scene& scene, const std::vector<float>& light);

}  // namespace fiatlux
