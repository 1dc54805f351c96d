// Areas in plan, as JSON: where luminaires may hang ("areas" of luminaires), and task areas, which are parts
// of a measuring plane or a floor with light of their own (core/scene/zones.h). Lengths in metres, along the
// room's x and z.
#pragma once

#include <array>
#include <string>
#include <vector>

#include "core/base/result.h"
#include "core/scene/scene.h"

namespace fiatlux {

class JsonField;

/// As it is written.
struct AskedArea {
  std::string name, surface;
  std::vector<std::array<double, 2>> outline;  // x and z of its corners, three at least
};

/// [{"name": "desk 3", "surface": "working plane", "outline": [[x, z], [x, z], [x, z]]}]
std::vector<AskedArea> taskAreasOf(const JsonField& json);

/// The zones that areas make: on each surface the areas themselves, the band of half a metre around each
/// ("desk 3 surround") and what is left ("working plane background"), as far as they hold a row. An Error
/// where a surface is not there, or an area holds nothing of it.
Result<std::vector<Zone>> zonesOf(const Scene& room, const std::vector<AskedArea>& areas);

/// {"keepOut": [[x, z, farX, farZ], [[x, z], [x, z], [x, z]]], "keepIn": [...], "fromWalls": 0.6}: the sites,
/// but for `kept` ones, that these rectangles and outlines leave out, or that are nearer to an edge of the
/// floor.
std::vector<std::uint32_t> sitesLeftOut(const Scene& room, const JsonField& json,
                                        const std::vector<std::uint32_t>& kept);

}  // namespace fiatlux
