// Statistics of the points of measuring planes (core/scene/plane_points.h) for a layout and for its changes,
// in a few loads a point: the least light upright there, and modelling, which is no sum of what each
// luminaire does.
#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "core/scene/plane_points.h"
#include "core/search/intentions.h"
#include "core/search/kernels.h"
#include "core/search/prepared_scene.h"

namespace fiatlux {

/// Does a constraint speak of points: of measuring planes, or of a grid?
inline bool isOfPoints(const Constraint& c) { return c.onGrid || traitsOf(c.statistic).ofPlanes; }

/// What must be known of which measuring planes, each once.
std::vector<PlaneWish> planesAskedOf(const Intentions& intentions);

/// What each site (also where ties are prepared) does at the points that a constraint speaks of, one surface
/// after the other. May refer to the scene. Precondition: isOfPoints; planes are there (Scene::planes), and
/// of a grid its quantity is said.
std::vector<std::shared_ptr<const Responses>> lightAtPoints(PreparedScene& prepared,
                                                            const Constraint& constraint);
/// Their mean over all points, an entry a site.
std::vector<double> meanOfPoints(PreparedScene& prepared, const Constraint& constraint);
/// What a constraint asks of its points.
double valueOf(const Constraint& constraint, const MeanAndLeast& points);

class PlaneValues {
 public:
  /// As for lightAtPoints.
  PlaneValues(PreparedScene& prepared, const Constraint& constraint);

  /// Sets the layout that `changed` starts from.
  void load(const std::uint32_t* sites, const double* flux, std::uint32_t count);
  /// Of the loaded layout at full flux (t = 1).
  MeanAndLeast current() { return changed(nullptr, 0); }
  /// After a change of it.
  MeanAndLeast changed(const FluxChange* changes, std::uint32_t count);

 private:
  /// lx at the points of a plane.
  struct Plane {
    std::shared_ptr<const Responses> asked;
    const Responses* horizontal;    // on the plane, for a ratio; else nullptr
    std::vector<double> light, on;  // under the loaded layout
  };
  std::vector<Plane> planes_;
  std::size_t points_ = 0;
  std::vector<double> light_, on_;  // scratch
};

/// Of a constraint under a layout, dimmed.
MeanAndLeast planeValueUnder(PreparedScene& prepared, const Constraint& constraint, const Layout& layout);

}  // namespace fiatlux
