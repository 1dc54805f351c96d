// "observers" of a layout or of intentions, and what they see, as JSON and for a person.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "core/scene/observer.h"

namespace fiatlux {

class JsonField;

/// As they are written; `inRoom`: those that a room has by itself, wherever it is known (observersInRoom).
struct AskedObservers {
  std::vector<Observer> observers;
  bool inRoom = false;
};

/// [{"position": [x, y, z], "direction": [x, y, z], "name": "desk 3"}], or "room". Without a name an observer
/// is called "observer 1", ...
AskedObservers observersOf(const JsonField& json);

/// Those of the list, or of the room.
std::vector<Observer> observersFor(const AskedObservers& asked, const Patches& patches);

/// [{"name", "position", "direction", "ugr", "background", "vertical", "cylindrical"}]; a ugr of null:
/// nothing glares, or no light is reflected.
nlohmann::ordered_json observersJson(const std::vector<Observer>& observers,
                                     const std::vector<ObserverReading>& readings);
/// A line for each.
std::string observersText(const std::vector<Observer>& observers,
                          const std::vector<ObserverReading>& readings);

}  // namespace fiatlux
