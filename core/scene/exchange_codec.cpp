#include "core/scene/exchange_codec.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "core/scene/range_coder.h"
#include "core/scene/residual_model.h"

namespace fiatlux {
namespace {

constexpr std::uint8_t kEscape = 255;             // a number of this or more follows in four bytes
constexpr std::int32_t kLargest = 1 << 26;        // of any number: a coupling of 4e9, far beyond any room
constexpr std::uint64_t kMostEntries = 1u << 24;  // of the rest
constexpr float kStrongest = 1e12f;               // 1/m2: sums of products with it stay finite
constexpr const char* kOutOfRange = "a value is out of range";

class ByteWriter {
 public:
  void put(std::uint32_t value) {
    bytes_.push_back(static_cast<std::uint8_t>(std::min<std::uint32_t>(value, kEscape)));
    if (value < kEscape) return;
    for (int shift = 0; shift < 32; shift += 8) bytes_.push_back(static_cast<std::uint8_t>(value >> shift));
  }
  void putSigned(std::int32_t value) {
    const auto bits = static_cast<std::uint32_t>(value);
    put((bits << 1) ^ (0u - (bits >> 31)));
  }
  std::vector<std::uint8_t> take() { return std::move(bytes_); }

 private:
  std::vector<std::uint8_t> bytes_;
};

/// Numbers off untrusted bytes: beyond their end come zeros, and ok() is false.
class ByteReader {
 public:
  explicit ByteReader(std::span<const std::uint8_t> bytes) : bytes_(bytes) {}
  std::uint32_t next() {
    const std::uint32_t value = byte();
    if (value < kEscape) return value;
    std::uint32_t whole = 0;
    for (int shift = 0; shift < 32; shift += 8) whole |= byte() << shift;
    return whole;
  }
  std::int32_t nextSigned() {
    const std::uint32_t bits = next();
    return static_cast<std::int32_t>((bits >> 1) ^ (0u - (bits & 1)));
  }
  bool ok() const { return ok_; }
  bool finished() const { return ok_ && at_ == bytes_.size(); }

 private:
  std::uint32_t byte() {
    if (at_ < bytes_.size()) return bytes_[at_++];
    ok_ = false;
    return 0;
  }
  std::span<const std::uint8_t> bytes_;
  std::size_t at_ = 0;
  bool ok_ = true;
};

/// Rows of H on their way through a coder, which writes (RangeEncoder) or reads (RangeDecoder) them: the row
/// above, this one, and how far each of their numbers was from what was predicted.
class MeansModel {
 public:
  explicit MeansModel(std::uint32_t columns) : above_(columns), row_(columns) {}

  /// Codes `number`, which a decoder ignores, at a column of the lower triangle or of a receiver; nullopt is
  /// beyond all numbers. Rows and their columns come in order.
  template <class Coder>
  std::optional<std::int32_t> code(Coder& coder, std::uint32_t row, std::uint32_t column,
                                   std::int32_t number) {
    if (column == 0) std::swap(above_, row_);
    const Cell none{}, left = column > 0 ? row_[column - 1] : none;
    const bool isBelow = column < row;  // else the row above has ended
    const Cell above = isBelow ? above_[column] : left;
    const Cell corner = isBelow && column > 0 ? above_[column - 1] : none;
    const std::int32_t prediction =
        isBelow && column > 0 ? between(left.number, above.number, corner.number) : above.number;
    const std::uint32_t activity = 14 * left.miss + 10 * above.miss + 8 * corner.miss;
    const std::int64_t coded = std::int64_t{prediction} +
                               model_.code(coder, activity, ResidualModel::kOrdinary, 0, number - prediction);
    if (coded < 0 || coded > kLargest) return std::nullopt;
    const auto value = static_cast<std::int32_t>(coded);
    row_[column] = {value, static_cast<std::uint32_t>(std::abs(value - prediction))};
    return value;
  }

 private:
  struct Cell {
    std::int32_t number = 0;
    std::uint32_t miss = 0;
  };
  /// On a plane through the three, but never beyond its neighbours: an edge between charts stays an edge.
  static std::int32_t between(std::int32_t left, std::int32_t above, std::int32_t corner) {
    return std::clamp(left + above - corner, std::min(left, above), std::max(left, above));
  }

  std::vector<Cell> above_, row_;
  ResidualModel model_;
};

std::uint32_t columnsOf(const ExchangeGroups& groups, std::uint32_t row) {
  return row < groups.count ? row + 1 : groups.count;
}

}  // namespace

std::vector<double> areasOf(const Patches& patches, const ExchangeGroups& groups) {
  std::vector<double> area(groups.total, 0);
  for (std::uint32_t p = 0; p < patches.rows(); ++p) area[groups.ofRow[p]] += patches.area[p];
  return area;
}

std::vector<std::uint8_t> encodeExchangeMeans(const Patches& patches, const ExchangeGroups& groups,
                                              const Exchange& exchange) {
  const std::vector<double> area = areasOf(patches, groups);
  RangeEncoder out;
  MeansModel model(groups.count);
  for (std::uint32_t c = 0; c < groups.total; ++c)
    for (std::uint32_t d = 0; d < columnsOf(groups, c); ++d) {
      const double coupling =
          exchange.means[std::size_t{c} * groups.count + d] * std::sqrt(area[c] * area[d]);
      const auto number = static_cast<std::int32_t>(std::clamp<double>(
          std::round(std::sqrt(std::max(0.0, coupling)) / kExchangeMeanStep), 0, kLargest));
      model.code(out, c, d, number);
    }
  return out.finish();
}

std::string decodeExchangeMeans(std::span<const std::uint8_t> bytes, const Patches& patches,
                                const ExchangeGroups& groups, Exchange& exchange, double step) {
  const std::vector<double> area = areasOf(patches, groups);
  exchange.means.assign(std::size_t{groups.total} * groups.count, 0.0f);
  RangeDecoder in(bytes);
  MeansModel model(groups.count);
  for (std::uint32_t c = 0; c < groups.total; ++c)
    for (std::uint32_t d = 0; d < columnsOf(groups, c); ++d) {
      const std::optional<std::int32_t> number = model.code(in, c, d, 0);
      if (!number) return kOutOfRange;
      const double root = step * *number;
      const auto mean = static_cast<float>(root * root / std::sqrt(area[c] * area[d]));
      if (!(mean < kStrongest)) return kOutOfRange;
      exchange.means[std::size_t{c} * groups.count + d] = mean;
      if (c < groups.count) exchange.means[std::size_t{d} * groups.count + c] = mean;
    }
  return in.ended() ? "" : "its length does not fit its values";
}

std::vector<std::uint8_t> encodeExchangeRest(const Patches& patches, const ExchangeGroups& groups,
                                             const Exchange& exchange) {
  const std::vector<double> area = areasOf(patches, groups);
  ByteWriter counts, gaps, values;
  for (std::uint32_t p = 0; p < patches.rows(); ++p) {
    std::uint32_t entries = 0, last = 0;
    for (std::uint32_t i = exchange.offset[p]; i < exchange.offset[p + 1]; ++i) {
      const std::uint32_t d = exchange.group[i];
      const double coupling = exchange.rest[i] * std::sqrt(patches.area[p] * area[d]);
      const auto number = static_cast<std::int32_t>(
          std::clamp<double>(std::round(coupling / kExchangeRestStep), -kLargest, kLargest));
      if (number == 0) continue;
      gaps.put(entries++ == 0 ? d : d - last - 1);
      values.putSigned(number);
      last = d;
    }
    counts.put(entries);
  }
  std::vector<std::uint8_t> bytes = counts.take();
  for (ByteWriter* part : {&gaps, &values}) {
    const std::vector<std::uint8_t> more = part->take();
    bytes.insert(bytes.end(), more.begin(), more.end());
  }
  return bytes;
}

std::string decodeExchangeRest(std::span<const std::uint8_t> bytes, const Patches& patches,
                               const ExchangeGroups& groups, Exchange& exchange, double step) {
  ByteReader in(bytes);
  exchange.offset.assign(1, 0);
  std::uint64_t entries = 0;
  for (std::uint32_t p = 0; p < patches.rows(); ++p) {
    const std::uint32_t more = in.next();
    entries += more;
    if (!in.ok() || more > groups.count || entries > kMostEntries || entries > bytes.size())
      return "it announces more values than it has";
    exchange.offset.push_back(static_cast<std::uint32_t>(entries));
  }
  exchange.group.clear();
  for (std::uint32_t p = 0; p < patches.rows(); ++p) {
    std::uint64_t next = 0;
    for (std::uint32_t i = exchange.offset[p]; i < exchange.offset[p + 1]; ++i) {
      next += in.next();
      if (next >= groups.count) return "a group is not there";
      exchange.group.push_back(static_cast<std::uint32_t>(next++));
    }
  }
  const std::vector<double> area = areasOf(patches, groups);
  exchange.rest.clear();
  for (std::uint32_t p = 0; p < patches.rows(); ++p)
    for (std::uint32_t i = exchange.offset[p]; i < exchange.offset[p + 1]; ++i) {
      const std::int32_t number = in.nextSigned();
      if (number < -kLargest || number > kLargest) return kOutOfRange;
      exchange.rest.push_back(
          static_cast<float>(step * number / std::sqrt(patches.area[p] * area[exchange.group[i]])));
      if (!(std::abs(exchange.rest.back()) < kStrongest)) return kOutOfRange;
    }
  return in.finished() ? "" : "its length does not fit its values";
}

}  // namespace fiatlux
