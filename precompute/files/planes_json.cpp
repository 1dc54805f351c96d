#include "precompute/files/planes_json.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <nlohmann/json.hpp>

#include "core/base/short_number.h"
#include "precompute/files/json_fields.h"
#include "precompute/files/terminal.h"

namespace fiatlux {
namespace {

using Json = nlohmann::ordered_json;

constexpr std::size_t kMostPlanes = 50, kMostDirections = 16;
constexpr double kLevel = 1e-6;
constexpr int kReadingDigits = 4;

AskedPlane planeOf(const JsonField& json) {
  if (json.isText()) return {json.text(), {}};
  json.requireKeys({"surface", "directions"});
  AskedPlane plane{json.at("surface", "name a measuring plane").text(), {}};
  if (const auto directions = json.find("directions"))
    for (const JsonField& direction : directions->list(kMostDirections))
      plane.directions.push_back(levelDirectionOf(direction));
  return plane;
}

Json numberJson(double value) { return std::isfinite(value) ? Json(value) : Json(nullptr); }

Json readingJson(const MeanAndLeast& reading) {
  return {{"mean", numberJson(reading.mean)}, {"min", numberJson(reading.least)}};
}

std::string textOf(const char* what, const MeanAndLeast& reading, const char* unit) {
  if (!std::isfinite(reading.mean)) return std::string(what) + " unknown, for parts are dark";
  return std::string(what) + " " + shortNumber(reading.mean, kReadingDigits) + unit + " (least " +
         shortNumber(reading.least, kReadingDigits) + ")";
}

}  // namespace

Vec3 levelDirectionOf(const JsonField& json) {
  const Vec3 direction = directionOf(json);
  if (std::fabs(direction.y) > kLevel) json.fail("a vertical plane faces sideways: [x, 0, z]");
  return normalized({direction.x, 0, direction.z});
}

std::vector<AskedPlane> planesOf(const JsonField& json) {
  std::vector<AskedPlane> planes;
  for (const JsonField& entry : json.list(kMostPlanes)) {
    planes.push_back(planeOf(entry));
    const auto isNamed = [&](const AskedPlane& other) { return other.surface == planes.back().surface; };
    if (std::count_if(planes.begin(), planes.end(), isNamed) > 1) entry.fail("it is there twice");
  }
  return planes;
}

Result<std::vector<PlaneWish>> planeWishes(const std::vector<AskedPlane>& asked,
                                           const std::vector<Surface>& surfaces) {
  std::vector<PlaneWish> wishes;
  for (const AskedPlane& plane : asked) {
    const auto found = std::find_if(surfaces.begin(), surfaces.end(),
                                    [&](const Surface& each) { return each.name == plane.surface; });
    if (found == surfaces.end() || !found->measuring)
      return Error{"planes: \"" + printable(plane.surface, 80) + "\" is no measuring plane of this room"};
    wishes.push_back({static_cast<std::uint32_t>(found - surfaces.begin()), plane.directions});
  }
  return wishes;
}

Json planesJson(const std::vector<Surface>& surfaces, const std::vector<PlaneReading>& readings) {
  Json list = Json::array();
  for (const PlaneReading& reading : readings) {
    Json json = {
        {"surface", surfaces[reading.surface].name},     {"points", reading.points},
        {"horizontal", readingJson(reading.horizontal)}, {"cylindrical", readingJson(reading.cylindrical)},
        {"modelling", readingJson(reading.modelling)},   {"vertical", Json::array()}};
    for (const auto& [d, light] : reading.verticals)
      json["vertical"].push_back(
          {{"direction", {d.x, d.y, d.z}}, {"mean", light.mean}, {"min", light.least}});
    list.push_back(std::move(json));
  }
  return list;
}

std::string planesText(const std::vector<Surface>& surfaces, const std::vector<PlaneReading>& readings) {
  std::string text;
  for (const PlaneReading& reading : readings) {
    text += printable(surfaces[reading.surface].name) + ": " +
            textOf("cylindrical", reading.cylindrical, " lx") + ", " +
            textOf("modelling", reading.modelling, "");
    for (const auto& [direction, light] : reading.verticals)
      text += ", " + textOf(("towards " + directionText(direction)).c_str(), light, " lx");
    text += "; " + std::to_string(reading.points) + " points\n";
  }
  return text;
}

std::string directionText(const Vec3& direction) {
  return "(" + shortNumber(direction.x, kReadingDigits) + ", " + shortNumber(direction.y, kReadingDigits) +
         ", " + shortNumber(direction.z, kReadingDigits) + ")";
}

}  // namespace fiatlux
