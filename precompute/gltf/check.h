// A glTF's JSON, checked before a library trusts it.
#pragma once

#include <nlohmann/json_fwd.hpp>

namespace fiatlux {

/// Checks every count, index, extent and reference. Throws GltfError (gltf_refusal.h).
void checkGltf(const nlohmann::json& json);

/// The part of it that is about bytes: buffers, their views and accessors (gltf_check_data.cpp).
void checkGltfData(const nlohmann::json& json);

}  // namespace fiatlux
