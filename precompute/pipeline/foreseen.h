// How long a run will take, before it is begun: a person who hears of ten minutes may choose coarser patches.
#pragma once

#include <string>

#include "precompute/geometry/room_options.h"
#include "precompute/room/room.h"

namespace fiatlux {

/// s of one core of a computer of today, about: from sample rooms of 12 to 60 000 triangles. A longer search
/// of rays in a larger model is the square of a logarithm, by the rooms measured. `rows`: patches and
/// receivers.
double coreSeconds(double rows, double sites, double triangles, double rays = kUsualRays);

/// One line on a run of more than three minutes, with patches that take less; "" for a shorter one.
std::string noteOfTime(const Room& room, std::uint32_t rays, unsigned threads);

}  // namespace fiatlux
