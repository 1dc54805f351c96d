// Random bytes at the glTF door: reading, then building a room with small limits. Nothing may crash or run
// away.
#include <cstdint>
#include <vector>

#include "precompute/build_room.h"
#include "precompute/display_mesh.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const auto scene = fiatlux::readSourceScene(std::vector<std::uint8_t>(data, data + size), "fuzz.glb", 1);
  if (!scene) return 0;
  std::size_t triangles = 0;
  for (const auto& mesh : scene->meshes) triangles += mesh.triangles.size();
  if (triangles > 2000) return 0;
  fiatlux::RoomOptions options;
  options.memory = 0.05;
  options.rays = 16;
  const auto room = fiatlux::buildRoom(*scene, options);
  if (room && room->patches.rows() < 20000) (void)fiatlux::displayMesh(*scene, *room);
  return 0;
}
