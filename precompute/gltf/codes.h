// The numbers by which glTF 2.0 and GLB name things.
#pragma once

#include <cstdint>

namespace fiatlux::gltf {

// Types of an accessor's components.
inline constexpr int kByte = 5120, kUnsignedByte = 5121, kShort = 5122, kUnsignedShort = 5123,
                     kUnsignedInt = 5125, kFloat = 5126;

// Modes of a primitive.
inline constexpr int kTriangles = 4, kTriangleStrip = 5, kTriangleFan = 6;

// What a buffer view is for.
inline constexpr int kArrayBuffer = 34962, kElementArrayBuffer = 34963;

// How a sampler wraps and filters.
inline constexpr int kRepeat = 10497, kClampToEdge = 33071, kMirroredRepeat = 33648;
inline constexpr int kLinear = 9729, kLinearMipmapLinear = 9987;

// GLB: the file's first word, its version, and the types of its chunks; sizes in bytes.
inline constexpr std::uint32_t kMagic = 0x46546c67, kGlbVersion = 2, kJsonChunk = 0x4e4f534a,
                               kBinaryChunk = 0x004e4942;
inline constexpr std::uint32_t kGlbHeaderBytes = 12, kChunkHeaderBytes = 8;

}  // namespace fiatlux::gltf
