// A block: for each stream and lane its two lengths in bytes; then for each its packed symbols and its
// escapes. A symbol 0..2 takes two bits, four to a byte, lowest first; 3 = 3 + the next escape byte; an
// escape of 255 is followed by four bytes that hold the symbol itself. Four columns go side by side (lanes).
// Each number is predicted from its neighbours; the zigzag of what is left is a symbol of a stream.
#include "core/scene/response_streams.h"

#include <algorithm>
#include <array>
#include <cstdlib>
#include <cstring>
#include <vector>

#include "core/scene/response_quantiser.h"

namespace fiatlux {
namespace {

constexpr std::size_t kStreams = 6, kLanes = 4;
constexpr std::size_t kLengthsBytes = kStreams * kLanes * 8;

std::int32_t unfolded(std::uint32_t v) { return static_cast<std::int32_t>((v >> 1) ^ (0u - (v & 1))); }

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
  if (block.size() < kLengthsBytes) return false;
  std::uint64_t at = kLengthsBytes;
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

/// Four columns on their way in: quantised values and the sizes of their residuals, by slot.
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
      const std::int64_t number = std::int64_t{prediction[i]} + unfolded(symbol);
      bad |= number < 0 || number > kLargestNumber;
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

std::uint32_t responseStreamColumns(std::uint32_t rows) {
  return static_cast<std::uint32_t>(std::max(kLanes, (11u << 20) / std::max(1u, rows) / kLanes * kLanes));
}

std::string decodeResponseStreams(std::span<const std::uint8_t> block, const Patches& patches,
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
