// zlib (RFC 1950) for the sections of a scene file.
#include "precompute/scene_io.h"

#include <zlib.h>

#include <algorithm>

#include "core/crc32.h"
#include "core/scene_reader.h"
#include "precompute/atomic_file.h"
#include "precompute/command_error.h"

namespace fiatlux {
namespace {

std::vector<std::uint8_t> deflated(std::span<const std::uint8_t> bytes, int level, int strategy) {
  z_stream stream{};
  if (deflateInit2(&stream, level, Z_DEFLATED, 15, 9, strategy) != Z_OK) return {};
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

}  // namespace

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
    if (!reader->needed(i)) continue;
    Result<std::vector<std::uint8_t>> bytes = inflateSection(file, reader->table().sections[i]);
    if (!bytes) return bytes.error();
    const Result<Done> provided = reader->provide(i, std::move(bytes.value()));
    if (!provided) return provided.error();
  }
  return reader->finish();
}

Result<Scene> readSceneFile(const std::string& path) {
  try {
    Result<Scene> scene = readScene(readFileBytes(path));
    if (!scene) return Error{path + ": " + scene.error().message};
    return scene;
  } catch (const CommandError& error) {
    return Error{error.what()};
  }
}

std::vector<StoredSection> deflateSections(std::vector<PlainSection> sections) {
  std::vector<StoredSection> result;
  for (PlainSection& plain : sections) {
    const int strategy = plain.section.encoding == Encoding::kResponses ? Z_FILTERED : Z_DEFAULT_STRATEGY;
    StoredSection stored{plain.section, deflated(plain.bytes, 9, strategy)};
    // note: a very even section would look like a bomb to the reader; Huffman codes alone shrink at most 8
    // times.
    if (plain.bytes.size() > kFreeInflatedBytes &&
        plain.bytes.size() / kMaxInflationRatio > stored.bytes.size())
      stored.bytes = deflated(plain.bytes, 9, Z_HUFFMAN_ONLY);
    stored.section.codec = Codec::kDeflate;
    if (stored.bytes.empty() || stored.bytes.size() >= plain.bytes.size()) {
      stored.section.codec = Codec::kStored;
      stored.bytes = std::move(plain.bytes);
    }
    result.push_back(std::move(stored));
  }
  return result;
}

}  // namespace fiatlux
