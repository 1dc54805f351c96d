// Whether the light of a room is of any use, and what to ask of a room that nobody has described.
#pragma once

#include <cstdint>
#include <string>

#include "precompute/light/transport.h"
#include "precompute/room/room.h"

namespace fiatlux {

/// Where the light of one luminaire goes, all sites alike.
struct LightBalance {
  double absorbed = 0;  // share of its flux that surfaces take up; the rest is lost
  double mostLit =
      0;  // share of its flux that falls on the surface that gets most, of half the sites at least
  double reflected = 0;  // what surfaces send on, a lumen each time that it is reflected, in its flux
};
LightBalance balanceOf(const Room& room, const Responses& responses);

/// Numbers by which a result is judged.
struct Quality {
  LightBalance balance;
  double residual = 0;  // after the last refinement
  double error = 0;     // of statistics, stated
};
/// Why a result is of no use, and the likely cause, in one line; "" where it is.
std::string uselessness(const Quality& quality);

/// What is said of light whose residual stays above kSettled.
std::string unsettled(double residual);

/// "Illuminate this surface", with luminaires of 3000 lm.
struct OpeningAsk {
  std::string surface;      // "": there is none below the sites
  double mean = 0;          // lx, at least: 300, or nearly what so many luminaires reach
  std::uint32_t count = 0;  // of luminaires
  double apart = 0;         // m between them at least, so that the most light is not one heap of them
};
/// The largest measuring plane, else the floor below most sites; `transport`: of the room.
OpeningAsk openingOf(const Room& room, const Transport& transport);

}  // namespace fiatlux
