#include "precompute/files/observers_json.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <nlohmann/json.hpp>

#include "precompute/files/json_fields.h"
#include "precompute/files/terminal.h"

namespace fiatlux {
namespace {

constexpr std::size_t kMostObservers = 200;

Observer observerOf(const JsonField& json, std::size_t number) {
  json.requireKeys({"name", "position", "direction"});
  Observer observer{"observer " + std::to_string(number), {}, {}};
  if (const auto name = json.find("name")) observer.name = name->text();
  observer.position = vectorOf(json.at("position", "say where the eye is: [x, y, z]"));
  observer.direction = directionOf(json.at("direction", "say where it looks: [x, y, z]"));
  return observer;
}

}  // namespace

AskedObservers observersOf(const JsonField& json) {
  AskedObservers asked;
  if (json.isText()) {
    asked.inRoom = json.oneOf<bool>({{"room", true}});
    return asked;
  }
  for (const JsonField& entry : json.list(kMostObservers)) {
    asked.observers.push_back(observerOf(entry, asked.observers.size() + 1));
    const std::string& name = asked.observers.back().name;
    const auto isNamed = [&](const Observer& other) { return other.name == name; };
    if (std::count_if(asked.observers.begin(), asked.observers.end(), isNamed) > 1)
      entry.fail("another observer is called so, too");
  }
  return asked;
}

std::vector<Observer> observersFor(const AskedObservers& asked, const Patches& patches) {
  return asked.inRoom ? observersInRoom(patches) : asked.observers;
}

nlohmann::ordered_json observersJson(const std::vector<Observer>& observers,
                                     const std::vector<ObserverReading>& readings) {
  nlohmann::ordered_json json = nlohmann::ordered_json::array();
  for (std::size_t o = 0; o < observers.size(); ++o) {
    const auto& [name, p, d] = observers[o];
    const double ugr = ugrOf(glareRatio(readings[o]));
    json.push_back({{"name", name},
                    {"position", {p.x, p.y, p.z}},
                    {"direction", {d.x, d.y, d.z}},
                    {"ugr", std::isfinite(ugr) ? nlohmann::ordered_json(ugr) : nullptr},
                    {"background", readings[o].background},
                    {"vertical", readings[o].vertical},
                    {"cylindrical", readings[o].cylindrical}});
  }
  return json;
}

std::string observersText(const std::vector<Observer>& observers,
                          const std::vector<ObserverReading>& readings) {
  std::string text;
  for (std::size_t o = 0; o < observers.size(); ++o) {
    const double ugr = ugrOf(glareRatio(readings[o]));
    char glare[60] = "nothing glares", line[160];
    if (std::isfinite(ugr)) std::snprintf(glare, sizeof glare, "UGR %.1f", ugr);
    std::snprintf(line, sizeof line, "%s before %.3g cd/m2; vertical %.4g lx, cylindrical %.4g lx", glare,
                  readings[o].background, readings[o].vertical, readings[o].cylindrical);
    text += printable(observers[o].name) + ": " + line + "\n";
  }
  return text;
}

}  // namespace fiatlux
