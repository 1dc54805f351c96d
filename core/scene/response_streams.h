// The streams of a block of responses. A block: for each stream and lane its two lengths in bytes; then for
// each its packed symbols and its escapes. A symbol 0..2 takes two bits, four to a byte, lowest first; 3 = 3
// + the next escape byte; an escape of 255 is followed by four bytes that hold the symbol itself.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstring>
#include <span>
#include <vector>

namespace fiatlux {

inline constexpr std::size_t kStreams = 6, kLanes = 4;
inline constexpr std::size_t kHeaderBytes = kStreams * kLanes * 8;

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

/// The block that some streams make.
inline std::vector<std::uint8_t> joined(const std::array<StreamWriter, kStreams * kLanes>& streams) {
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
inline bool split(std::span<const std::uint8_t> block, std::array<StreamReader, kStreams * kLanes>& streams) {
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

}  // namespace fiatlux
