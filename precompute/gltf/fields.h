// Members of a stranger's JSON, one at a time: there or absent, of the right kind, within bounds. Each
// function throws GltfError with `place` ("accessor 3"), what is wrong and the cure.
#pragma once

#include <cstddef>
#include <nlohmann/json.hpp>
#include <string>

#include "precompute/gltf/codes.h"
#include "precompute/gltf/refusal.h"

namespace fiatlux {

/// Whether indices and joints may be of this component type.
constexpr bool isUnsigned(std::size_t componentType) {
  return componentType == gltf::kUnsignedByte || componentType == gltf::kUnsignedShort ||
         componentType == gltf::kUnsignedInt;
}

inline constexpr const char* kAgain = "; export the file again";  // the cure of what an exporter got wrong

/// "accessor 3"
std::string placeOf(const char* kind, std::size_t index);

/// A whole number of `object`, at most `most`; `fallback` when absent, or an error when `required`.
std::size_t whole(const nlohmann::json& object, const char* key, const std::string& place, std::size_t most,
                  bool required = false, std::size_t fallback = 0);

/// The array under `key` (empty when absent), all of whose entries are objects.
const nlohmann::json& arrayOf(const nlohmann::json& object, const char* key);

/// Checks that `key`, where present, is the index of one of `count` things.
void checkIndex(const nlohmann::json& object, const char* key, const std::string& place, std::size_t count,
                bool required = false);

/// Checks that `key`, where present, is a list of `count` numbers.
void checkNumbers(const nlohmann::json& object, const char* key, const std::string& place, std::size_t count);
/// The same of any length.
void checkNumbers(const nlohmann::json& object, const char* key, const std::string& place);

/// Checks that `key`, where present, is text.
void checkString(const nlohmann::json& object, const char* key, const std::string& place);

/// Checks that `key`, where present, is an object.
void checkObject(const nlohmann::json& object, const char* key, const std::string& place);

}  // namespace fiatlux
