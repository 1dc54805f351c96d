// Shapes and counts first, then block by block; see response_sections.h.
#include "core/scene/response_sections.h"

#include <algorithm>
#include <span>

#include "core/scene/response_streams.h"
#include "core/scene/scene_sections.h"

namespace fiatlux {
namespace {

/// The blocks of version 1.
std::vector<float> readStreams(CheckedSections& in, const SceneCounts& counts, const Patches& patches,
                               std::span<const ResponseScale> scales) {
  const std::uint32_t rows = counts.rows(), perBlock = responseStreamColumns(rows);
  std::vector<float> columns(std::size_t{rows} * counts.columns);
  for (std::uint32_t first = 0, block = 0; first < counts.columns; first += perBlock, ++block) {
    const std::string name = numberedName("responses", block);
    const std::uint32_t width = std::min(perBlock, counts.columns - first);
    const std::vector<std::uint8_t> bytes =
        in.take(name, ElementType::kUint8, Encoding::kResponses, CheckedSections::kAnyRows, 1);
    if (!in.ok()) return {};
    const auto part =
        scales.subspan(std::size_t{first} * counts.surfaces, std::size_t{width} * counts.surfaces);
    const std::string fault =
        decodeResponseStreams(bytes, patches, part, width, &columns[std::size_t{first} * rows]);
    if (!fault.empty()) return in.fail(name, fault), std::vector<float>{};
  }
  return columns;
}

std::vector<ResponseReferences> readReferences(CheckedSections& in, const SceneCounts& counts) {
  const std::vector<std::uint32_t> before = in.integers("responseReferences", counts.columns, 2);
  if (!in.ok()) return {};
  std::vector<ResponseReferences> references(counts.columns, {kNone, kNone});
  for (std::uint32_t j = 0; j < counts.columns; ++j)
    for (std::uint32_t i = 0; i < 2; ++i) {
      const std::uint32_t back = before[2 * j + i];
      if (back > j) return in.fail("responseReferences", "a column is not there"), references;
      if (back > 0) references[j][i] = j - back;
    }
  return references;
}

std::vector<ResponseScale> readScales(CheckedSections& in, const SceneCounts& counts) {
  const std::vector<float> numbers = in.floats("responseScales", Encoding::kFloatPlanes, counts.columns,
                                               2 * counts.surfaces, 0, kBrightestMean);
  std::vector<ResponseScale> scales;
  for (std::size_t i = 0; in.ok() && i < numbers.size(); i += 2)
    scales.push_back({numbers[i], numbers[i + 1]});
  return scales;
}

}  // namespace

void ResponseSections::open(CheckedSections& in, const SceneCounts& counts, const Patches& patches) {
  std::vector<ResponseReferences> references = readReferences(in, counts);
  const std::uint32_t rows = counts.rows(), perBlock = responseBlockColumns(rows);
  // Before memory is asked for: a short file cannot hold many numbers.
  for (std::uint32_t block = 0; in.ok() && block * perBlock < counts.columns; ++block) {
    blocks_.push_back(numberedName("responses", block));
    const std::uint32_t width = std::min(perBlock, counts.columns - block * perBlock);
    if (!in.has(blocks_.back()))
      in.fail(blocks_.back(), "it is missing");
    else if (in.line(blocks_.back()).inflatedBytes < std::uint64_t{rows} * width / kValuesPerByte)
      in.fail(blocks_.back(), "it is too short for the patches and sites");
  }
  if (in.ok()) decoder_.emplace(patches, counts.surfaces, std::move(references));
}

void ResponseSections::advance(CheckedSections& in, const SceneCounts& counts, const Patches& patches) {
  if (!decoder_ && in.isThere("responseReferences")) open(in, counts, patches);
  for (; in.ok() && decoder_ && next_ < blocks_.size() && in.isThere(blocks_[next_]); ++next_) {
    const std::string& name = blocks_[next_];
    const std::vector<std::uint8_t> bytes =
        in.take(name, ElementType::kUint8, Encoding::kPredicted, CheckedSections::kAnyRows, 1);
    if (!in.ok()) return;
    const std::string fault = decoder_->decode(bytes);
    if (!fault.empty()) in.fail(name, fault);
  }
}

std::vector<float> ResponseSections::columns(CheckedSections& in, const SceneCounts& counts,
                                             const Patches& patches) {
  const std::vector<ResponseScale> scales = readScales(in, counts);
  if (!in.ok()) return {};
  if (!in.has("responseReferences")) return readStreams(in, counts, patches, scales);
  advance(in, counts, patches);
  if (!decoder_) in.fail("responseReferences", "it was not provided");
  if (in.ok() && next_ < blocks_.size()) in.fail(blocks_[next_], "it was not provided");
  return in.ok() ? decoder_->finish(scales) : std::vector<float>{};
}

}  // namespace fiatlux
