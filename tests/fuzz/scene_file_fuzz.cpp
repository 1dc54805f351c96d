// Random bytes at the scene file reader. Checksums would stop nearly all of them at once, so they are mended
// first, as a forger would: what is tested is everything behind them.
#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <vector>

#include "core/crc32.h"
#include "core/scene.h"
#include "core/scene_file.h"
#include "precompute/scene_io.h"

namespace {

/// Magic, version, length, and the checksums of every section that lies in the file, then of the table.
void mend(std::vector<std::uint8_t>& file) {
  if (file.size() < 64) return;
  const std::uint8_t magic[8] = {0x89, 'F', 'L', 'U', 'X', '\r', '\n', 0x1a};
  std::memcpy(file.data(), magic, 8);
  const std::uint32_t version = 1;
  std::memcpy(&file[8], &version, 4);
  const std::uint64_t size = file.size();
  std::memcpy(&file[16], &size, 8);
  std::uint32_t sections;
  std::memcpy(&sections, &file[12], 4);
  if (sections > (file.size() - 64) / 80) return;
  for (std::uint32_t i = 0; i < sections; ++i) {
    std::uint8_t* entry = &file[64 + 80 * i];
    std::uint64_t offset, stored;
    std::memcpy(&offset, entry + 56, 8);
    std::memcpy(&stored, entry + 64, 8);
    if (offset > size || stored > size - offset) continue;
    const std::uint32_t crc = fiatlux::crc32Of(std::span(file).subspan(offset, stored));
    std::memcpy(entry + 48, &crc, 4);
    if (entry[33] == 0) std::memcpy(entry + 52, &crc, 4);
  }
  std::memset(&file[60], 0, 4);
  const std::uint32_t crc = fiatlux::crc32Of(std::span(file).first(64 + 80 * std::size_t{sections}));
  std::memcpy(&file[60], &crc, 4);
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  std::vector<std::uint8_t> file(data, data + size);
  (void)fiatlux::readSceneTable(file);
  mend(file);
  const fiatlux::Result<fiatlux::Scene> scene = fiatlux::readScene(file);
  if (!scene) {
    if (scene.error().message.empty()) std::abort();
    return 0;
  }
  // What passes must be usable.
  for (float v : scene->responses.illuminance)
    if (!(v >= 0)) std::abort();
  (void)fiatlux::illuminanceOf(*scene, {{0}, {1000.0}, 1});
  (void)fiatlux::unionStatistics(*scene, fiatlux::Quantity::kIlluminance, {0});
  return 0;
}
