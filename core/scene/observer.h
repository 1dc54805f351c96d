// Somebody who looks: where from and which way, and what glares there. Unified glare rating (CIE 117):
//   UGR = 8 log10(0.25 / L_b x sum of L^2 w / p^2)
// The sum is additive over the luminaires, each with the square of its flux; so is the background L_b, with
// the flux itself: two rows tell both for every layout. And what light falls there, on a plane before the eye
// and on a small upright cylinder (EN 12464-1: how well a face is seen).
#pragma once

#include <string>
#include <vector>

#include "core/base/vec3.h"
#include "core/scene/layout.h"
#include "core/scene/patches.h"

namespace fiatlux {

struct Observer {
  std::string name;
  Vec3 position;   // m, of the eye
  Vec3 direction;  // unit, where it looks
};

inline bool operator==(const Observer& a, const Observer& b) {
  const auto same = [](const Vec3& v, const Vec3& w) { return v.x == w.x && v.y == w.y && v.z == w.z; };
  return a.name == b.name && same(a.position, b.position) && same(a.direction, b.direction);
}

/// What an observer sees of each site, m entries each.
struct ObserverRows {
  Observer observer;
  std::vector<double> glare;       // 0.25 sum of L^2 w / p^2 at 1 lm, of what nothing hides, cd2/m4
  std::vector<double> background;  // L_b at 1 lm: all reflected light on the plane before the eye / pi, cd/m2
  std::vector<double> vertical, cylindrical;  // lx at 1 lm, direct light included
};

/// The same in one light: background in cd/m2, the last two in lx.
struct ObserverReading {
  double glare = 0, background = 0, vertical = 0, cylindrical = 0;
};

/// 10^(UGR / 8): grows with the dimming as the light does. Glare before darkness is infinite.
double glareRatio(const ObserverReading& reading);
/// UGR of such a ratio and back; -infinity where nothing glares.
double ugrOf(double ratio);
double ratioOf(double ugr);

/// Of every observer under a layout, dimming included.
std::vector<ObserverReading> readObservers(const std::vector<ObserverRows>& observers, const Layout& layout);

inline constexpr double kEyeHeight = 1.2;  // m above the floor, of somebody who sits

/// Observers over the working planes, over the floor where there are none: on a grid, at kEyeHeight, looking
/// along +x, -x, +z and -z ("P1 +x", ...); at most kMostPlaces places. None in a room without a floor.
inline constexpr std::size_t kMostPlaces = 16;
std::vector<Observer> observersInRoom(const Patches& patches);

}  // namespace fiatlux
