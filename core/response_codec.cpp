// A block: one byte a value (zigzag of the residual; 255 = look among the escapes), then the escapes, 4 bytes
// each.
#include "core/response_codec.h"

#include <algorithm>
#include <cmath>
#include <cstring>

namespace fiatlux {
namespace {

constexpr std::uint8_t kEscape = 255;
constexpr double kLargest = 1 << 24;  // of a quantised value: still exact as a float

std::uint32_t zigzag(std::int32_t v) {
  return (static_cast<std::uint32_t>(v) << 1) ^ static_cast<std::uint32_t>(v >> 31);
}
std::int32_t unzigzag(std::uint32_t v) { return static_cast<std::int32_t>((v >> 1) ^ (0u - (v & 1))); }

/// Where the prediction of each row comes from: left, up, and the corner between them.
struct Neighbours {
  std::vector<std::uint32_t> left, up, corner;  // row + 1, 0 = none, so that slot 0 may hold a zero

  explicit Neighbours(const Patches& patches) {
    const std::uint32_t rows = patches.rows();
    left.resize(rows), up.resize(rows), corner.resize(rows);
    for (std::uint32_t p = 0; p < rows; ++p) {
      std::uint32_t l = patches.left[p], u = patches.up[p];
      std::uint32_t c = l != kNone && u != kNone ? patches.up[l] : kNone;
      // One neighbour only: it predicts alone (left + up - corner with up = corner). None: the row before.
      if (l == kNone && u == kNone && p > 0 && patches.surface[p - 1] == patches.surface[p]) l = p - 1;
      if (u == kNone) u = c = l;
      if (l == kNone) l = c = u;
      if (c == kNone) c = u;
      left[p] = l + 1, up[p] = u + 1, corner[p] = c + 1;  // note: kNone + 1 = 0
    }
  }
};

/// The median of left, up and left + up - corner (as in JPEG-LS): follows edges and slopes alike.
std::int32_t predict(std::int32_t left, std::int32_t up, std::int32_t corner) {
  const std::int32_t low = std::min(left, up), high = std::max(left, up);
  return std::clamp(left + up - corner, low, high);
}

}  // namespace

std::uint32_t responseBlockColumns(std::uint32_t rows) {
  return std::max<std::uint32_t>(1, (12u << 20) / std::max(1u, rows));
}

EncodedResponses encodeResponses(const Responses& responses, const Patches& patches, std::uint32_t surfaces,
                                 double step) {
  const std::uint32_t rows = responses.rows, columns = responses.sites;
  const Neighbours at(patches);
  EncodedResponses encoded;
  encoded.steps.resize(std::size_t{columns} * surfaces);
  encoded.rms.resize(std::size_t{columns} * surfaces);
  encoded.errorBound.resize(surfaces);
  const std::uint32_t perBlock = responseBlockColumns(rows);
  std::vector<std::int32_t> value(rows + 1);
  std::vector<std::uint8_t> escapes;
  std::vector<double> area(surfaces), mean(surfaces), peak(surfaces), squares(surfaces), worst(surfaces);
  for (std::uint32_t p = 0; p < rows; ++p) area[patches.surface[p]] += patches.area[p];
  for (std::uint32_t j = 0; j < columns; ++j) {
    if (j % perBlock == 0) {
      if (j > 0) encoded.blocks.back().insert(encoded.blocks.back().end(), escapes.begin(), escapes.end());
      escapes.clear();
      encoded.blocks.emplace_back();
    }
    const float* column = responses.column(j);
    float* steps = &encoded.steps[std::size_t{j} * surfaces];
    std::fill(mean.begin(), mean.end(), 0), std::fill(peak.begin(), peak.end(), 0);
    std::fill(squares.begin(), squares.end(), 0), std::fill(worst.begin(), worst.end(), 0);
    for (std::uint32_t p = 0; p < rows; ++p) {
      mean[patches.surface[p]] += patches.area[p] * column[p];
      peak[patches.surface[p]] = std::max<double>(peak[patches.surface[p]], column[p]);
    }
    for (std::uint32_t s = 0; s < surfaces; ++s) {
      if (area[s] > 0) mean[s] /= area[s];
      steps[s] = static_cast<float>(std::max(step * mean[s], peak[s] / kLargest));
    }
    for (std::uint32_t p = 0; p < rows; ++p) {
      const std::uint32_t s = patches.surface[p];
      value[p + 1] = steps[s] > 0 ? static_cast<std::int32_t>(std::lround(double{column[p]} / steps[s])) : 0;
      const std::uint32_t symbol =
          zigzag(value[p + 1] - predict(value[at.left[p]], value[at.up[p]], value[at.corner[p]]));
      encoded.blocks.back().push_back(static_cast<std::uint8_t>(std::min<std::uint32_t>(symbol, kEscape)));
      for (int shift = 0; symbol >= kEscape && shift < 32; shift += 8)
        escapes.push_back(static_cast<std::uint8_t>(symbol >> shift));
      const double error = std::abs(double{static_cast<float>(value[p + 1]) * steps[s]} - column[p]);
      squares[s] += patches.area[p] * error * error;
      worst[s] = std::max(worst[s], error);
    }
    for (std::uint32_t s = 0; s < surfaces; ++s) {
      if (!(mean[s] > 0)) continue;
      encoded.rms[std::size_t{j} * surfaces + s] =
          static_cast<float>(std::sqrt(squares[s] / area[s]) / mean[s]);
      encoded.errorBound[s] =
          std::max(encoded.errorBound[s], static_cast<float>(worst[s] / mean[s] * 1.000001));
    }
  }
  if (columns > 0) encoded.blocks.back().insert(encoded.blocks.back().end(), escapes.begin(), escapes.end());
  return encoded;
}

std::string decodeResponses(std::span<const std::uint8_t> block, const Patches& patches,
                            std::span<const float> steps, std::uint32_t columns, float* out) {
  const std::uint32_t rows = patches.rows();
  const std::size_t values = std::size_t{rows} * columns;
  const std::size_t surfaces = steps.size() / std::max(1u, columns);
  if (block.size() < values) return "it is too short for the patches and sites";
  const auto escapes = static_cast<std::size_t>(std::count(block.begin(), block.begin() + values, kEscape));
  if (block.size() != values + 4 * escapes) return "it has more or fewer escapes than it announces";
  const Neighbours at(patches);
  const std::uint8_t* symbol = block.data();
  const std::uint8_t* escape = block.data() + values;
  std::vector<std::int32_t> value(rows + 1);
  for (std::uint32_t j = 0; j < columns; ++j, steps = steps.subspan(surfaces)) {
    for (std::uint32_t p = 0; p < rows; ++p) {
      std::uint32_t coded = *symbol++;
      if (coded == kEscape) std::memcpy(&coded, escape, 4), escape += 4;
      const std::int64_t v =
          std::int64_t{predict(value[at.left[p]], value[at.up[p]], value[at.corner[p]])} + unzigzag(coded);
      if (v < 0 || v > static_cast<std::int64_t>(kLargest)) return "a value is out of range";
      value[p + 1] = static_cast<std::int32_t>(v);
      *out++ = static_cast<float>(v) * steps[patches.surface[p]];
    }
  }
  return "";
}

}  // namespace fiatlux
