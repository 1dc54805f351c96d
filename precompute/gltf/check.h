// A glTF's JSON, checked before a library trusts it.
#pragma once

#include <nlohmann/json_fwd.hpp>

namespace fiatlux {

/// Checks every count, index, extent and reference. Throws GltfError (refusal.h).
void checkGltf(const nlohmann::json& file);

/// The part of it that is about bytes: buffers, their views and accessors (check_data.cpp).
void checkGltfData(const nlohmann::json& file);

}  // namespace fiatlux
