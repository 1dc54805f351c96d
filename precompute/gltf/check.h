// A glTF's JSON, checked before a library trusts it.
#pragma once

#include <nlohmann/json_fwd.hpp>

namespace fiatlux {

/// Extensions by which a texture names a picture that is neither PNG nor JPEG.
inline constexpr const char* kPictureExtensions[] = {"KHR_texture_basisu", "EXT_texture_webp",
                                                     "EXT_texture_avif"};

/// Checks every count, index, extent and reference. Throws GltfError (refusal.h).
void checkGltf(const nlohmann::json& file);

/// The part of it that is about bytes: buffers, their views and accessors (check_data.cpp).
void checkGltfData(const nlohmann::json& file);

}  // namespace fiatlux
