// Models come in centimetres, millimetres, inches: the unit is guessed where the sizes are absurd for a room.
#pragma once

#include <string>

#include "precompute/gltf/source_scene.h"

namespace fiatlux {

/// By how much a scene read as metres is to be multiplied so that its ceilings are about as high as ceilings
/// are; 1 where its sizes are possible as they are, or its author gives metres in extras. Deterministic.
double guessedScale(const SourceScene& source);

/// From floors to the ceilings above, that of most, in units of the positions; 0 where nothing is above
/// anything.
double heightOfRooms(const SourceScene& source);

/// "6 x 5 m and 2.8 m high", of a size in units of so many metres.
std::string sizesOf(const Vec3& size, double scale);

/// Multiplies all positions.
void scaleBy(double scale, SourceScene& source);

/// One line on a guess that is no 1: the unit, the sizes before and after, how to refuse.
std::string noteOfScale(double scale, const SourceScene& scaled);

}  // namespace fiatlux
