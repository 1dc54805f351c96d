#include "precompute/gltf/fields.h"

#include <cmath>
#include <cstdio>

namespace fiatlux {

using nlohmann::json;

std::string placeOf(const char* kind, std::size_t index) {
  return std::string(kind) + " " + std::to_string(index);
}

std::size_t whole(const json& object, const char* key, const std::string& place, std::size_t most,
                  bool required, std::size_t fallback) {
  const auto found = object.find(key);
  if (found == object.end()) {
    if (required) throw GltfError(place + " lacks its '" + key + "'" + kAgain);
    return fallback;
  }
  const bool exact = found->is_number_unsigned() ||
                     (found->is_number_float() && found->get<double>() >= 0 && found->get<double>() < 9e15 &&
                      std::floor(found->get<double>()) == found->get<double>());
  if (!exact) throw GltfError(place + ": '" + key + "' is not a whole number" + kAgain);
  const double value = found->get<double>();
  if (value > static_cast<double>(most)) {
    char text[32];
    std::snprintf(text, sizeof text, "%.0f", value);
    throw GltfError(place + ": '" + key + "' is " + text + ", beyond " + std::to_string(most) + kAgain);
  }
  return static_cast<std::size_t>(value);
}

const json& arrayOf(const json& object, const char* key) {
  static const json kEmpty = json::array();
  const auto found = object.find(key);
  if (found == object.end()) return kEmpty;
  if (!found->is_array()) throw GltfError(std::string("'") + key + "' is not a list" + kAgain);
  for (const json& entry : *found)
    if (!entry.is_object())
      throw GltfError(std::string("'") + key + "' holds something that is not an object" + kAgain);
  return *found;
}

void checkIndex(const json& object, const char* key, const std::string& place, std::size_t count,
                bool required) {
  if (!object.contains(key) && !required) return;
  if (count == 0)
    throw GltfError(place + ": '" + key + "' points at something the file does not have" + kAgain);
  whole(object, key, place, count - 1, required);
}

void checkNumbers(const json& object, const char* key, const std::string& place, std::size_t count) {
  const auto found = object.find(key);
  if (found == object.end()) return;
  bool good = found->is_array() && found->size() == count;
  if (good)
    for (const json& number : *found) good = good && number.is_number();
  if (!good) throw GltfError(place + ": '" + key + "' is not " + std::to_string(count) + " numbers" + kAgain);
}

void checkNumbers(const json& object, const char* key, const std::string& place) {
  if (object.contains(key)) checkNumbers(object, key, place, object[key].size());
}

void checkString(const json& object, const char* key, const std::string& place) {
  if (object.contains(key) && !object[key].is_string())
    throw GltfError(place + ": '" + key + "' is not text" + kAgain);
}

void checkObject(const json& object, const char* key, const std::string& place) {
  if (object.contains(key) && !object[key].is_object())
    throw GltfError(place + ": '" + key + "' is not an object" + kAgain);
}

}  // namespace fiatlux
