// Room and transport -> the bytes of a scene file, measured against what they were made from.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "core/base/result.h"
#include "core/scene/opening_light.h"
#include "core/scene/scene.h"
#include "core/scene/scene_file.h"
#include "precompute/light/transport.h"
#include "precompute/room/room.h"

namespace fiatlux {

/// Makes bytes smaller: a zlib stream (RFC 1950). The kind is a hint; `kHuffman` must shrink at most
/// eightfold, or return nothing.
enum class DeflateKind { kUsual, kHuffman };
using Deflate = std::function<std::vector<std::uint8_t>(std::span<const std::uint8_t>, DeflateKind)>;

/// Sections deflated where that makes them smaller (and, beyond 1 MB, within the ratio that the reader
/// allows), on that many threads.
std::vector<StoredSection> storeSections(const std::vector<PlainSection>& sections, const Deflate& deflate,
                                         unsigned threads = 1);

/// What a scene says, before any rounding; the large arrays are moved out of `transport`.
Scene sceneOf(const Room& room, Transport&& transport, const std::string& identity);

/// How far a file's statistics are from the unrounded ones, relative to the larger of the surface's mean and
/// a thousandth of the room's (of sigma: of the surface's sigma and that), the worst over 1000 random layouts
/// of six luminaires and all surfaces; and the RMS error of patch light as a share of the surface's mean.
struct FileErrors {
  double mean = 0, sigma = 0;
  double patchRmsMedian = 0, patchRmsWorst = 0;  // over surfaces and sites
};

/// A scene file that wants nothing but its provenance.
struct EncodedScene {
  std::string identity;
  SceneCounts counts;
  std::vector<StoredSection> sections;
  std::vector<std::uint32_t> ranks;  // per surface: rows of the factored covariance, 0 = packed
  FileErrors errors;
};

/// Encodes, deflates, reads the result back and measures it. `picture`: a .glb to display, empty: none;
/// `paper`: the paper's matrices, to be written too; `opening`: the light that is to be seen first, if any.
/// What is seen first comes first. `deflate` is called on that many threads. An error where the scene is too
/// large for a file, or where what was read back is not what was written.
Result<EncodedScene> encodeSceneFile(const Scene& scene, std::vector<std::uint8_t> picture,
                                     const std::optional<PaperTransport>& paper,
                                     const std::optional<OpeningLight>& opening, const Deflate& deflate,
                                     unsigned threads);

/// The file's bytes, with `provenance` (JSON text).
Result<std::vector<std::uint8_t>> closeSceneFile(EncodedScene scene, const std::string& provenance,
                                                 const Deflate& deflate);

}  // namespace fiatlux
