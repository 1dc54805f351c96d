// Column after column through one model; a block is what the range coder makes of some of them.
#include "core/scene/response_codec.h"

#include <algorithm>

#include "core/scene/range_coder.h"
#include "core/scene/response_quantiser.h"

namespace fiatlux {

std::vector<ResponseReferences> nearestBefore(const std::vector<Site>& sites) {
  std::vector<ResponseReferences> nearest(sites.size(), ResponseReferences{kNone, kNone});
  for (std::uint32_t j = 0; j < sites.size(); ++j) {
    const auto distance = [&](std::uint32_t i) { return length(sites[i].position - sites[j].position); };
    for (std::uint32_t i = 0; i < j; ++i) {
      auto& [first, second] = nearest[j];
      if (first == kNone || distance(i) < distance(first))
        second = first, first = i;
      else if (second == kNone || distance(i) < distance(second))
        second = i;
    }
  }
  return nearest;
}

std::uint32_t responseBlockColumns(std::uint32_t rows) {
  return std::max(1u, (1u << 20) / std::max(1u, rows));
}

EncodedResponses encodeResponses(const Responses& responses, const Patches& patches,
                                 std::span<const double> steps,
                                 const std::vector<ResponseReferences>& references) {
  const std::uint32_t rows = responses.rows, columns = responses.sites, perBlock = responseBlockColumns(rows);
  const auto surfaces = static_cast<std::uint32_t>(steps.size());
  EncodedResponses encoded;
  encoded.scales.resize(std::size_t{columns} * surfaces);
  encoded.rms.resize(std::size_t{columns} * surfaces);
  encoded.errorBound.resize(surfaces);
  Quantiser quantiser(patches, steps);
  ResponseModel model(patches, surfaces, references);
  RangeEncoder coder;
  std::vector<std::int32_t> numbers(rows);
  for (std::uint32_t j = 0; j < columns; ++j) {
    ResponseScale* scales = &encoded.scales[std::size_t{j} * surfaces];
    quantiser.quantise(responses.column(j), scales, numbers);
    quantiser.judge(responses.column(j), scales, numbers, &encoded.rms[std::size_t{j} * surfaces],
                    encoded.errorBound);
    model.codeColumn(coder, numbers.data());
    if ((j + 1) % perBlock != 0 && j + 1 != columns) continue;
    std::vector<std::uint8_t>& block = encoded.blocks.emplace_back(coder.finish());
    const std::size_t values = std::size_t{rows} * (j % perBlock + 1);
    block.resize(std::max(block.size(), (values + kValuesPerByte - 1) / kValuesPerByte));
  }
  encoded.stored = {rows, columns, model.light(encoded.scales)};
  return encoded;
}

std::string ResponseDecoder::decode(std::span<const std::uint8_t> block) {
  const std::uint32_t first = model_.next();
  const std::uint32_t last = std::min(first + responseBlockColumns(model_.rows()), model_.columns());
  RangeDecoder coder(block);
  while (model_.next() < last)
    if (!model_.codeColumn(coder, nullptr)) return "a value is out of range";
  return coder.ended() ? "" : "it does not have the length that the patches and sites need";
}

}  // namespace fiatlux
