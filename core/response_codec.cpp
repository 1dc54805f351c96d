// Four columns go side by side (lanes), so that a processor has something to do while it waits for one of
// them. A block: for each stream and lane its two lengths in bytes; then for each its packed symbols and its
// escapes. A symbol is the zigzag of a residual: 0..2 in two bits, four to a byte, lowest first; 3 = 3 + the
// next escape byte; an escape of 255 is followed by four bytes that hold the symbol itself.
#include "core/response_codec.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>

namespace fiatlux {
namespace {

constexpr std::int32_t kLargest = 1 << 24;  // of a quantised value: still exact as a float
constexpr std::size_t kStreams = 6, kLanes = 4;
constexpr std::size_t kHeaderBytes = kStreams * kLanes * 8;

std::uint32_t zigzag(std::int32_t v) {
  return (static_cast<std::uint32_t>(v) << 1) ^ static_cast<std::uint32_t>(v >> 31);
}
std::int32_t unzigzag(std::uint32_t v) { return static_cast<std::int32_t>((v >> 1) ^ (0u - (v & 1))); }

/// Where the prediction of a row comes from: slots of left, up and the corner between them. Row p has slot p
/// + 1; slot 0 holds zeros.
struct Neighbours {
  std::uint32_t left, up, corner;
};

std::vector<Neighbours> neighboursOf(const Patches& patches) {
  std::vector<Neighbours> slots(patches.rows());
  for (std::uint32_t p = 0; p < patches.rows(); ++p) {
    std::uint32_t left = patches.left[p], up = patches.up[p];
    std::uint32_t corner = left != kNone && up != kNone ? patches.up[left] : kNone;
    // One neighbour predicts alone (left + up - corner, all three it). None: the row before.
    if (left == kNone && up == kNone && p > 0 && patches.surface[p - 1] == patches.surface[p]) left = p - 1;
    if (up == kNone) up = corner = left;
    if (left == kNone) left = corner = up;
    if (corner == kNone) corner = up;
    slots[p] = {left + 1, up + 1, corner + 1};  // note: kNone + 1 = 0
  }
  return slots;
}

/// Four columns on their way in or out: quantised values and the sizes of their residuals, by slot.
class Quad {
 public:
  using Numbers = std::array<std::int32_t, kLanes>;

  explicit Quad(std::uint32_t rows) : value_(rows + 1), residual_(rows + 1) {}

  /// What is known of a patch before its symbols are read: predictions and streams.
  void expect(const Neighbours& at, Numbers& prediction, Numbers& stream) const {
    const Numbers &left = value_[at.left], &up = value_[at.up], &corner = value_[at.corner];
    const Numbers &leftResidual = residual_[at.left], &upResidual = residual_[at.up];
    for (std::size_t i = 0; i < kLanes; ++i) {
      // The median of left, up and left + up - corner (as in JPEG-LS) follows edges and slopes alike.
      const std::int32_t low = std::min(left[i], up[i]), high = std::max(left[i], up[i]);
      prediction[i] = std::min(std::max(left[i] + up[i] - corner[i], low), high);
      // Streams: darkness, then ever more restless neighbourhoods.
      const std::int32_t residuals = leftResidual[i] + upResidual[i];
      const std::int32_t restless = std::abs(left[i] - corner[i]) + std::abs(up[i] - corner[i]) + residuals;
      stream[i] = ((left[i] | up[i] | corner[i] | residuals) != 0) + (restless > 1) + (restless > 3) +
                  (restless > 6) + (restless > 14);
    }
  }
  void set(std::uint32_t slot, const Numbers& value, const Numbers& prediction) {
    value_[slot] = value;
    for (std::size_t i = 0; i < kLanes; ++i)
      residual_[slot][i] = std::min(std::abs(value[i] - prediction[i]), 255);
  }

 private:
  std::vector<Numbers> value_, residual_;
};

class StreamWriter {
 public:
  void put(std::uint32_t symbol) {
    if (count_++ % 4 == 0) packed_.push_back(0);
    packed_.back() |= static_cast<std::uint8_t>(std::min(symbol, 3u) << (2 * ((count_ - 1) % 4)));
    if (symbol < 3) return;
    const std::uint32_t rest = std::min(symbol - 3, 255u);
    escapes_.push_back(static_cast<std::uint8_t>(rest));
    for (int shift = 0; rest == 255 && shift < 32; shift += 8)
      escapes_.push_back(static_cast<std::uint8_t>(symbol >> shift));
  }
  const std::vector<std::uint8_t>& packed() const { return packed_; }
  const std::vector<std::uint8_t>& escapes() const { return escapes_; }

 private:
  std::vector<std::uint8_t> packed_, escapes_;
  std::size_t count_ = 0;
};

std::vector<std::uint8_t> joined(const std::array<StreamWriter, kStreams * kLanes>& streams) {
  std::vector<std::uint8_t> block;
  const auto append = [&](const std::vector<std::uint8_t>& bytes) {
    block.insert(block.end(), bytes.begin(), bytes.end());
  };
  for (const StreamWriter& stream : streams)
    for (std::size_t size : {stream.packed().size(), stream.escapes().size()})
      for (int shift = 0; shift < 32; shift += 8) block.push_back(static_cast<std::uint8_t>(size >> shift));
  for (const StreamWriter& stream : streams) append(stream.packed()), append(stream.escapes());
  return block;
}

/// A stream's place in the block. Reading takes no branch that the data decides, except for rare long
/// escapes.
struct StreamReader {
  const std::uint8_t* packed = nullptr;
  const std::uint8_t* escapes = nullptr;
  std::uint32_t packedBytes = 0, escapeBytes = 0;
  std::uint32_t symbols = 0, escaped = 0;  // read so far: symbols, bytes of escapes

  /// The next symbol; sets `bad` where the stream has ended.
  std::uint32_t next(bool& bad) {
    const std::uint32_t byte = symbols >> 2;
    if (byte >= packedBytes) return bad = true, 0;
    const std::uint32_t symbol = (packed[byte] >> (2 * (symbols & 3))) & 3;
    ++symbols;
    const std::uint32_t escape = symbol == 3;
    if (escaped + escape > escapeBytes) return bad = true, 0;
    const std::uint32_t rest = escapes[escaped & (0u - escape)] & (0u - escape);
    escaped += escape;
    return rest < 255 ? symbol + rest : longSymbol(bad);
  }
  /// All bytes are used.
  bool finished() const { return (symbols + 3) >> 2 == packedBytes && escaped == escapeBytes; }

 private:
  std::uint32_t longSymbol(bool& bad) {
    if (escapeBytes - escaped < 4) return bad = true, 0;
    std::uint32_t symbol;
    std::memcpy(&symbol, escapes + escaped, 4);
    escaped += 4;
    return symbol;
  }
};

/// Cuts a block into its streams; false where the lengths are not those of the block.
bool split(std::span<const std::uint8_t> block, std::array<StreamReader, kStreams * kLanes>& streams) {
  if (block.size() < kHeaderBytes) return false;
  std::uint64_t at = kHeaderBytes;
  for (std::size_t i = 0; i < streams.size(); ++i) {
    StreamReader& stream = streams[i];
    std::memcpy(&stream.packedBytes, &block[8 * i], 4);
    std::memcpy(&stream.escapeBytes, &block[8 * i + 4], 4);
    const std::uint64_t end = at + stream.packedBytes + stream.escapeBytes;
    if (end > block.size()) return false;
    stream.packed = block.data() + at;
    // note: a stream without escapes still reads escapes[0], and throws it away.
    stream.escapes = stream.escapeBytes > 0 ? stream.packed + stream.packedBytes : block.data();
    at = end;
  }
  return at == block.size();
}

/// Steps and floors of one column, and what the rounding does to each surface.
class Quantiser {
 public:
  Quantiser(const Patches& patches, std::uint32_t surfaces, double step)
      : patches_(patches), surfaces_(surfaces), step_(step), area_(surfaces) {
    for (std::uint32_t p = 0; p < patches.rows(); ++p) area_[patches.surface[p]] += patches.area[p];
  }

  /// Sets the scales of a column and the numbers of its rows.
  void quantise(const float* column, ResponseScale* scales, std::vector<std::int32_t>& numbers) {
    std::vector<double> peak(surfaces_), dimArea(surfaces_), dim(surfaces_), darkest(surfaces_, 1e300);
    mean_.assign(surfaces_, 0);
    for (std::uint32_t p = 0; p < patches_.rows(); ++p) {
      mean_[patches_.surface[p]] += patches_.area[p] * column[p] / area_[patches_.surface[p]];
      peak[patches_.surface[p]] = std::max<double>(peak[patches_.surface[p]], column[p]);
    }
    for (std::uint32_t s = 0; s < surfaces_; ++s)
      scales[s] = {static_cast<float>(std::max(step_ * mean_[s], peak[s] / (kLargest / 2))), 0};
    for (std::uint32_t p = 0; p < patches_.rows(); ++p) {
      const std::uint32_t s = patches_.surface[p];
      numbers[p] =
          scales[s].step > 0 ? static_cast<std::int32_t>(std::lround(double{column[p]} / scales[s].step)) : 0;
      if (numbers[p] > 0) continue;
      dimArea[s] += patches_.area[p];
      dim[s] += patches_.area[p] * column[p];
      darkest[s] = std::min<double>(darkest[s], column[p]);
    }
    // note: where no light at all arrives (a sealed corner), dim patches must not be given any.
    for (std::uint32_t s = 0; s < surfaces_; ++s)
      if (dimArea[s] > 0 && darkest[s] > 1e-4 * scales[s].step)
        scales[s].floor = static_cast<float>(std::min(dim[s] / dimArea[s], 0.5 * scales[s].step));
  }

  /// RMS error over the mean of each surface; raises the bounds.
  void judge(const float* column, const ResponseScale* scales, const std::vector<std::int32_t>& numbers,
             float* rms, std::vector<float>& bound) const {
    std::vector<double> squares(surfaces_), worst(surfaces_);
    for (std::uint32_t p = 0; p < patches_.rows(); ++p) {
      const ResponseScale& scale = scales[patches_.surface[p]];
      const float stored = numbers[p] > 0 ? static_cast<float>(numbers[p]) * scale.step : scale.floor;
      const double error = std::abs(double{stored} - column[p]);
      squares[patches_.surface[p]] += patches_.area[p] * error * error;
      worst[patches_.surface[p]] = std::max(worst[patches_.surface[p]], error);
    }
    for (std::uint32_t s = 0; s < surfaces_; ++s) {
      if (!(mean_[s] > 0)) continue;
      rms[s] = static_cast<float>(std::sqrt(squares[s] / area_[s]) / mean_[s]);
      bound[s] = std::max(bound[s], static_cast<float>(worst[s] / mean_[s] * 1.000001));
    }
  }

 private:
  const Patches& patches_;
  std::uint32_t surfaces_;
  double step_;
  std::vector<double> area_, mean_;
};

/// Decodes `width` columns side by side into out (column-major); false where a stream ends or a value is out
/// of range. `scale`: of the first column's surfaces, then the next column's.
template <std::uint32_t width>
bool decodeLanes(const std::vector<Neighbours>& neighbours, const std::vector<std::uint32_t>& surface,
                 const ResponseScale* scale, std::size_t surfaces,
                 std::array<StreamReader, kStreams * kLanes>& streams, Quad& quad, float* out) {
  const std::size_t rows = neighbours.size();
  for (std::size_t p = 0; p < rows; ++p) {
    Quad::Numbers prediction, stream, value{};
    quad.expect(neighbours[p], prediction, stream);
    bool bad = false;
    for (std::uint32_t i = 0; i < width; ++i) {
      const auto symbol = streams[static_cast<std::uint32_t>(stream[i]) * kLanes + i].next(bad);
      const std::int64_t number = std::int64_t{prediction[i]} + unzigzag(symbol);
      bad |= number < 0 || number > kLargest;
      value[i] = static_cast<std::int32_t>(number);
    }
    if (bad) return false;
    for (std::uint32_t i = 0; i < width; ++i) {
      const ResponseScale s = scale[i * surfaces + surface[p]];
      const float lit = static_cast<float>(value[i]) * s.step;
      out[i * rows + p] = value[i] > 0 ? lit : s.floor;
    }
    quad.set(static_cast<std::uint32_t>(p + 1), value, prediction);
  }
  return true;
}

}  // namespace

std::uint32_t responseBlockColumns(std::uint32_t rows) {
  // note: a value takes at most 5.25 bytes, so that a block stays below 64 MB for up to 2 million rows.
  return std::max<std::uint32_t>(kLanes, (11u << 20) / std::max(1u, rows) / kLanes * kLanes);
}

EncodedResponses encodeResponses(const Responses& responses, const Patches& patches, std::uint32_t surfaces,
                                 double step) {
  const std::uint32_t rows = responses.rows, columns = responses.sites, perBlock = responseBlockColumns(rows);
  const std::vector<Neighbours> neighbours = neighboursOf(patches);
  EncodedResponses encoded;
  encoded.scales.resize(std::size_t{columns} * surfaces);
  encoded.rms.resize(std::size_t{columns} * surfaces);
  encoded.errorBound.resize(surfaces);
  Quantiser quantiser(patches, surfaces, step);
  std::array<std::vector<std::int32_t>, kLanes> numbers;
  numbers.fill(std::vector<std::int32_t>(rows));
  std::array<StreamWriter, kStreams * kLanes> streams;
  for (std::uint32_t first = 0; first < columns; first += kLanes) {
    const std::uint32_t width = std::min<std::uint32_t>(kLanes, columns - first);
    for (std::uint32_t i = 0; i < width; ++i) {
      const float* column = responses.column(first + i);
      const std::size_t at = std::size_t{first + i} * surfaces;
      quantiser.quantise(column, &encoded.scales[at], numbers[i]);
      quantiser.judge(column, &encoded.scales[at], numbers[i], &encoded.rms[at], encoded.errorBound);
    }
    Quad quad(rows);
    for (std::uint32_t p = 0; p < rows; ++p) {
      Quad::Numbers prediction, stream, value{};
      quad.expect(neighbours[p], prediction, stream);
      for (std::uint32_t i = 0; i < width; ++i) {
        value[i] = numbers[i][p];
        streams[stream[i] * kLanes + i].put(zigzag(value[i] - prediction[i]));
      }
      quad.set(p + 1, value, prediction);
    }
    if ((first + width) % perBlock != 0 && first + width != columns) continue;
    encoded.blocks.push_back(joined(streams));
    streams = {};
  }
  return encoded;
}

std::string decodeResponses(std::span<const std::uint8_t> block, const Patches& patches,
                            std::span<const ResponseScale> scales, std::uint32_t columns, float* out) {
  std::array<StreamReader, kStreams * kLanes> streams;
  if (!split(block, streams)) return "its streams do not have the lengths they announce";
  const std::size_t surfaces = scales.size() / std::max(1u, columns), rows = patches.rows();
  const std::vector<Neighbours> neighbours = neighboursOf(patches);
  Quad quad(patches.rows());  // note: every slot is set before it is read again, so one serves all columns
  bool sane = true;
  for (std::uint32_t first = 0; sane && first < columns; first += kLanes) {
    const ResponseScale* scale = &scales[first * surfaces];
    float* lanes = out + first * rows;
    // note: a number of lanes that the compiler knows makes this a tenth faster.
    sane = columns - first >= kLanes
               ? decodeLanes<kLanes>(neighbours, patches.surface, scale, surfaces, streams, quad, lanes)
           : columns - first == 3
               ? decodeLanes<3>(neighbours, patches.surface, scale, surfaces, streams, quad, lanes)
           : columns - first == 2
               ? decodeLanes<2>(neighbours, patches.surface, scale, surfaces, streams, quad, lanes)
               : decodeLanes<1>(neighbours, patches.surface, scale, surfaces, streams, quad, lanes);
  }
  if (!sane) return "a stream ends early or a value is out of range";
  for (const StreamReader& stream : streams)
    if (!stream.finished()) return "a stream is longer than the patches and sites need";
  return "";
}

}  // namespace fiatlux
