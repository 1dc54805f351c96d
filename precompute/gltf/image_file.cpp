// The only file that includes stb_image.
#include "precompute/gltf/image_file.h"

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

bool decodeImage(SourceImage& image, std::string& why) {
  const auto* bytes = image.encoded.data();
  const int size = static_cast<int>(image.encoded.size());
  int width = 0, height = 0, channels = 0;
  if (size == 0 || !stbi_info_from_memory(bytes, size, &width, &height, &channels)) {
    why = "is neither PNG nor JPEG";
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
