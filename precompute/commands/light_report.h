// What `fiatlux light` says of a lit room, as JSON and for a person.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <vector>

#include "core/scene/calculation_grid.h"
#include "precompute/files/light_results.h"
#include "precompute/light/forward_light.h"
#include "precompute/light/observer_light.h"
#include "precompute/light/plane_points_light.h"
#include "precompute/light/point_light.h"
#include "precompute/room/room.h"

namespace fiatlux {

/// Everything read in a room; refers to the room and its light.
struct LightReport {
  const Room& room;
  const ForwardLight& light;
  bool directOnly = false;
  std::vector<MeasuringPoint> points;             // none: not asked for
  std::vector<PointReading> readings;             // of the points
  std::optional<std::vector<GridReading>> grids;  // where asked for
  std::vector<Observer> observers;                // none: not asked for
  std::vector<ObserverReading> seen;              // by the observers
  std::vector<PlaneReading> planes;               // none: not asked for
  double seconds = 0;                             // that the light took
};

/// One document: surfaces and energy; "points" and "grids" where they were asked for.
nlohmann::ordered_json lightReportJson(const LightReport& report);

/// The same on standard output, for a person.
void printLightReport(const LightReport& report);

}  // namespace fiatlux
