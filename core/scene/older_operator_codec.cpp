#include "core/scene/older_operator_codec.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "core/scene/exchange_codec.h"
#include "core/scene/range_coder.h"
#include "core/scene/residual_model.h"

namespace fiatlux {
namespace {

constexpr int kOlderWhole = SiteVisibility::kSteps;
constexpr std::uint8_t kOlderEscape = 255;  // a number of this or more follows in four bytes
constexpr const char* kOlderNoFit = "its length does not fit its values";

/// 0 not seen, 1 partly, 2 wholly.
std::uint32_t olderKindOf(int step) { return step == 0 ? 0 : step == kOlderWhole ? 2 : 1; }

/// Column after column.
class OlderVisibility {
 public:
  explicit OlderVisibility(const Patches& patches)
      : patches_(patches),
        right_(patches.rows(), kNone),
        down_(patches.rows(), kNone),
        before_(patches.rows(), 0),
        earlier_(patches.rows(), 0) {
    for (std::uint32_t p = 0; p < patches.rows(); ++p) {
      if (patches.left[p] != kNone) right_[patches.left[p]] = p;
      if (patches.up[p] != kNone) down_[patches.up[p]] = p;
    }
  }

  /// Reads the steps of one site. False: a number that no share has.
  bool read(RangeDecoder& in, std::uint8_t* column) {
    for (std::uint32_t p = 0; p < patches_.rows(); ++p) {
      const Around around = aroundOf(column, p);
      auto& [partly, wholly] = kinds_[contextOf(around)];
      if (!in.bit(partly)) {
        column[p] = in.bit(wholly) ? kOlderWhole : 0;
        continue;
      }
      const int prediction = predictionOf(around);
      const auto activity = static_cast<std::uint32_t>(8 * spreadOf(around) + 16);
      const std::int64_t step =
          std::int64_t{prediction} + shares_.code(in, activity, ResidualModel::kOrdinary, 0, 0);
      if (step < 0 || step > kOlderWhole) return false;
      column[p] = static_cast<std::uint8_t>(step);
    }
    std::swap(before_, earlier_);
    before_.assign(column, column + patches_.rows());
    return true;
  }

 private:
  /// What is known when a cell's turn comes: of its own site left and up, of the site before also beyond.
  struct Around {
    int left, up, before, beforeLeft, beforeRight, beforeDown, earlier;
  };

  Around aroundOf(const std::uint8_t* column, std::uint32_t p) const {
    const auto at = [&](const std::uint8_t* of, std::uint32_t cell, int otherwise) {
      return cell == kNone ? otherwise : int{of[cell]};
    };
    const int before = before_[p];
    const int left = at(column, patches_.left[p], at(column, patches_.up[p], before));
    return {left,
            at(column, patches_.up[p], left),
            before,
            at(before_.data(), patches_.left[p], before),
            at(before_.data(), right_[p], before),
            at(before_.data(), down_[p], before),
            earlier_[p]};
  }

  static std::uint32_t contextOf(const Around& a) {
    std::uint32_t context = 0;
    for (const int step : {a.left, a.up, a.before, a.beforeRight, a.beforeDown, a.earlier})
      context = 3 * context + olderKindOf(step);
    return context;
  }

  static int predictionOf(const Around& a) {
    const int plane = std::clamp(a.left + a.before - a.beforeLeft, 0, kOlderWhole);
    return (2 * a.before + a.left + a.up + plane) / 5;
  }

  static int spreadOf(const Around& a) {
    const auto [least, most] = std::minmax({a.left, a.up, a.before, a.beforeRight, a.beforeDown});
    return most - least;
  }

  static constexpr std::uint32_t kContexts = 3 * 3 * 3 * 3 * 3 * 3;
  struct Kinds {
    AdaptiveBit partly, wholly;
  };

  const Patches& patches_;
  std::vector<std::uint32_t> right_, down_;     // rows: the next cell on the same chart, or kNone
  std::vector<std::uint8_t> before_, earlier_;  // steps of the site before, and of the one before that
  std::array<Kinds, kContexts> kinds_;
  ResidualModel shares_;
};

/// Numbers off untrusted bytes: beyond their end come zeros, and ok() is false.
class OlderBytes {
 public:
  explicit OlderBytes(std::span<const std::uint8_t> bytes) : bytes_(bytes) {}
  std::uint32_t next() {
    const std::uint32_t value = byte();
    if (value < kOlderEscape) return value;
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

/// Rows of H: the row above, this one, and how far each of their numbers was from what was predicted by the
/// numbers left, above and at the corner of the table.
class OlderMeans {
 public:
  explicit OlderMeans(std::uint32_t columns) : above_(columns), row_(columns) {}

  /// Reads the number at a column of the lower triangle or of a receiver; nullopt is beyond all numbers. Rows
  /// and their columns come in order.
  std::optional<std::int32_t> read(RangeDecoder& in, std::uint32_t row, std::uint32_t column) {
    if (column == 0) std::swap(above_, row_);
    const Cell none{}, left = column > 0 ? row_[column - 1] : none;
    const bool isBelow = column < row;  // else the row above has ended
    const Cell above = isBelow ? above_[column] : left;
    const Cell corner = isBelow && column > 0 ? above_[column - 1] : none;
    const std::int32_t prediction =
        isBelow && column > 0 ? between(left.number, above.number, corner.number) : above.number;
    const std::uint32_t activity = 14 * left.miss + 10 * above.miss + 8 * corner.miss;
    const std::int64_t coded =
        std::int64_t{prediction} + model_.code(in, activity, ResidualModel::kOrdinary, 0, 0);
    if (coded < 0 || coded > kLargestExchangeNumber) return std::nullopt;
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

}  // namespace

std::string decodeOlderVisibility(std::span<const std::uint8_t> bytes, const Patches& patches,
                                  std::uint32_t first, std::uint32_t last, SiteVisibility& visibility) {
  RangeDecoder in(bytes);
  OlderVisibility model(patches);
  for (std::uint32_t j = first; j < last; ++j)
    if (!model.read(in, visibility.steps.data() + std::size_t{j} * visibility.rows))
      return "a share is out of range";
  return in.ended() ? "" : kOlderNoFit;
}

std::string decodeOlderExchangeMeans(std::span<const std::uint8_t> bytes, const Patches& patches,
                                     const ExchangeGroups& groups, Exchange& exchange, double step) {
  RangeDecoder in(bytes);
  OlderMeans model(groups.count);
  const std::string fault = fillExchangeMeans(patches, groups, step, exchange,
                                              [&](auto c, auto d) { return model.read(in, c, d); });
  return !fault.empty() ? fault : in.ended() ? "" : kOlderNoFit;
}

std::string decodeOlderExchangeRest(std::span<const std::uint8_t> bytes, const Patches& patches,
                                    const ExchangeGroups& groups, Exchange& exchange, double step) {
  OlderBytes in(bytes);
  exchange.offset.assign(1, 0);
  std::uint64_t entries = 0;
  for (std::uint32_t p = 0; p < patches.rows(); ++p) {
    const std::uint32_t more = in.next();
    entries += more;
    if (!in.ok() || more > groups.count || entries > kMostRestEntries || entries > bytes.size())
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
      if (number < -kLargestExchangeNumber || number > kLargestExchangeNumber) return kExchangeOutOfRange;
      exchange.rest.push_back(
          static_cast<float>(step * number / std::sqrt(patches.area[p] * area[exchange.group[i]])));
      if (!(std::abs(exchange.rest.back()) < kStrongestExchange)) return kExchangeOutOfRange;
    }
  return in.finished() ? "" : kOlderNoFit;
}

}  // namespace fiatlux
