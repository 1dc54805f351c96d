// The only file that includes stb_image.
#include "precompute/gltf/image_file.h"

#include <cstring>
#include <string_view>

#include "precompute/gltf/refusal.h"

#define STB_IMAGE_IMPLEMENTATION
#define STB_IMAGE_STATIC
#define STBI_ONLY_PNG
#define STBI_ONLY_JPEG
#define STBI_NO_STDIO
#define STBI_MAX_DIMENSIONS 8192  // GltfBudget::kImageEdge
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wunused-function"
#pragma GCC diagnostic ignored "-Wsign-compare"
#include <stb/stb_image.h>
#pragma GCC diagnostic pop

namespace fiatlux {

static_assert(STBI_MAX_DIMENSIONS == GltfBudget::kImageEdge);

namespace {

/// Of bytes that are neither PNG nor JPEG.
const char* whyNot(const std::vector<std::uint8_t>& bytes) {
  const auto starts = [&](std::size_t at, std::string_view text) {
    return bytes.size() >= at + text.size() && std::memcmp(bytes.data() + at, text.data(), text.size()) == 0;
  };
  if (starts(1, "KTX 20")) return "is KTX2, which is not read (use PNG or JPEG)";
  if (starts(0, "RIFF") && starts(8, "WEBP")) return "is WebP, which is not read (use PNG or JPEG)";
  if (starts(4, "ftypavif")) return "is AVIF, which is not read (use PNG or JPEG)";
  return "is neither PNG nor JPEG";
}

}  // namespace

bool decodeImage(SourceImage& image, std::string& why) {
  const auto* bytes = image.encoded.data();
  const int size = static_cast<int>(image.encoded.size());
  int width = 0, height = 0, channels = 0;
  if (size == 0 || !stbi_info_from_memory(bytes, size, &width, &height, &channels)) {
    why = whyNot(image.encoded);
    return false;
  }
  const int most = GltfBudget::kImageEdge;
  if (width < 1 || height < 1 || width > most || height > most) {
    why = "is larger than " + std::to_string(most) + " x " + std::to_string(most) + " pixels";
    return false;
  }
  stbi_uc* pixels = stbi_load_from_memory(bytes, size, &width, &height, &channels, 4);
  if (!pixels) {
    why = "is damaged";
    return false;
  }
  image.width = static_cast<std::uint32_t>(width);
  image.height = static_cast<std::uint32_t>(height);
  image.rgba.assign(pixels, pixels + std::size_t{4} * image.width * image.height);
  stbi_image_free(pixels);
  return true;
}

}  // namespace fiatlux
