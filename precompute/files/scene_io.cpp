// zlib (RFC 1950) for the sections of a scene file.
#include "precompute/files/scene_io.h"

#include <zlib.h>

#include <cassert>
#include <limits>

#include "core/scene/crc32.h"
#include "core/scene/scene_reader.h"
#include "precompute/files/files_on_disk.h"

namespace fiatlux {

std::vector<std::uint8_t> zlibDeflate(std::span<const std::uint8_t> bytes, DeflateKind kind) {
  assert(bytes.size() <= std::numeric_limits<uInt>::max());
  const int strategy = kind == DeflateKind::kHuffman ? Z_HUFFMAN_ONLY : Z_DEFAULT_STRATEGY;
  z_stream stream{};
  if (deflateInit2(&stream, 9, Z_DEFLATED, 15, 9, strategy) != Z_OK) return {};
  std::vector<std::uint8_t> out(deflateBound(&stream, bytes.size()));
  stream.next_in = const_cast<Bytef*>(bytes.data());
  stream.avail_in = static_cast<uInt>(bytes.size());
  stream.next_out = out.data();
  stream.avail_out = static_cast<uInt>(out.size());
  const int status = deflate(&stream, Z_FINISH);
  out.resize(stream.total_out);
  deflateEnd(&stream);
  if (status != Z_STREAM_END) out.clear();
  return out;
}

Result<std::vector<std::uint8_t>> inflateSection(std::span<const std::uint8_t> file,
                                                 const SceneSection& section) {
  const auto stored = storedBytes(file, section);
  const auto fault = [&](const char* what) {
    return Error{"section " + section.name + ": " + what +
                 "; the file is damaged: make it again with fiatlux precompute"};
  };
  std::vector<std::uint8_t> bytes;
  if (section.codec == Codec::kStored) {
    bytes.assign(stored.begin(), stored.end());
  } else {
    bytes.resize(section.inflatedBytes);  // at most 64 MB: readSceneTable has checked
    std::uint8_t none = 0;
    z_stream stream{};
    if (inflateInit(&stream) != Z_OK) return fault("no memory to inflate it");
    stream.next_in = const_cast<Bytef*>(stored.data());
    stream.avail_in = static_cast<uInt>(stored.size());
    stream.next_out = bytes.empty() ? &none : bytes.data();
    stream.avail_out = static_cast<uInt>(bytes.size());
    const int status = inflate(&stream, Z_FINISH);
    const bool exact = status == Z_STREAM_END && stream.total_out == bytes.size() && stream.avail_in == 0;
    inflateEnd(&stream);
    if (!exact) return fault("it does not inflate to the size it declares");
  }
  if (crc32Of(bytes) != section.inflatedCrc) return fault("checksum differs");
  return bytes;
}

Result<Scene> readScene(std::span<const std::uint8_t> file) {
  Result<SceneReader> reader = SceneReader::open(file);
  if (!reader) return reader.error();
  for (std::uint32_t i = 0; i < reader->table().sections.size(); ++i) {
    if (!reader->needed(i) && !reader->ofOperator(i)) continue;
    Result<std::vector<std::uint8_t>> bytes = inflateSection(file, reader->table().sections[i]);
    if (!bytes) return bytes.error();
    const Result<Done> provided = reader->provide(i, std::move(bytes.value()));
    if (!provided) return provided.error();
  }
  return reader->finish();
}

Result<Scene> readSceneFile(const std::string& path) {
  const Result<std::vector<std::uint8_t>> bytes = readFileBytes(path);
  if (!bytes) return bytes.error();
  Result<Scene> scene = readScene(*bytes);
  if (!scene) return Error{path + ": " + scene.error().message};
  return scene;
}

}  // namespace fiatlux
