#include "core/scene/exchange_codec.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <optional>

#include "core/scene/range_coder.h"
#include "core/scene/residual_model.h"

namespace fiatlux {
namespace {

constexpr const char* kNoFit = "its length does not fit its values";

/// The groups beside each group, of those before it: which most of its rows are the left and the upper
/// neighbours of. Its predecessor where none is; kNone of the first group and of the first of receivers.
struct GroupNeighbours {
  std::vector<std::uint32_t> left, up;
};

std::vector<std::uint32_t> mostFrequent(const std::vector<std::map<std::uint32_t, std::uint32_t>>& counts) {
  std::vector<std::uint32_t> best(counts.size(), kNone);
  for (std::size_t c = 0; c < counts.size(); ++c) {
    std::uint32_t most = 0;
    for (const auto& [group, count] : counts[c])
      if (count > most) most = count, best[c] = group;
  }
  return best;
}

GroupNeighbours besideGroups(const Patches& patches, const ExchangeGroups& groups) {
  std::vector<std::map<std::uint32_t, std::uint32_t>> left(groups.total), up(groups.total);
  for (std::uint32_t p = 0; p < patches.rows(); ++p) {
    const std::uint32_t c = groups.ofRow[p];
    const auto count = [&](std::uint32_t beside, auto& counts) {
      if (beside != kNone && groups.ofRow[beside] < c) ++counts[c][groups.ofRow[beside]];
    };
    count(patches.left[p], left), count(patches.up[p], up);
  }
  GroupNeighbours beside{mostFrequent(left), mostFrequent(up)};
  for (std::uint32_t c = 0; c < groups.total; ++c) {
    std::uint32_t &west = beside.left[c], &north = beside.up[c];
    if (c == 0 || c == groups.count)
      west = north = kNone;
    else if (west == kNone)
      west = north != kNone ? north : c - 1;
    if (north == kNone) north = west;
  }
  return beside;
}

/// Numbers of H on their way through a coder, which writes (RangeEncoder) or reads (RangeDecoder) them. What
/// group c and group d exchange is about what their neighbours do: four planes through three neighbours each
/// and the four numbers beside it.
class MeansModel {
 public:
  MeansModel(const Patches& patches, const ExchangeGroups& groups)
      : count_(groups.count), beside_(besideGroups(patches, groups)), residuals_(kSizes * kLeans * kSigns) {
    const std::size_t all = rowStart(groups.total);
    number_.resize(all), miss_.resize(all);
  }

  /// Codes `number`, which a decoder ignores, at a column of the lower triangle or of a receiver; nullopt is
  /// beyond all numbers. Rows and their columns come in order.
  template <class Coder>
  std::optional<std::int32_t> code(Coder& coder, std::uint32_t c, std::uint32_t d, std::int32_t number) {
    const auto [prediction, context] = expected(c, d);
    const std::int64_t coded =
        std::int64_t{prediction} + residuals_.code(coder, context, number - prediction,
                                                   static_cast<std::uint32_t>(prediction),
                                                   kLargestExchangeNumber);
    if (coded > kLargestExchangeNumber) return std::nullopt;
    const auto value = static_cast<std::int32_t>(coded);
    number_[placeOf(c, d)] = value;
    miss_[placeOf(c, d)] =
        static_cast<std::int8_t>(std::clamp(value - prediction, -kMostMissed, kMostMissed));
    return value;
  }

 private:
  struct Expected {
    std::int32_t number;
    std::uint32_t context;
  };
  /// A number that is known, and by how much it was not what was expected.
  struct Known {
    std::int32_t number = 0, miss = 0;
  };

  Expected expected(std::uint32_t c, std::uint32_t d) const {
    const std::uint32_t west = beside_.left[c], north = beside_.up[c], westOf = beside_.left[d],
                        northOf = beside_.up[d];
    std::array<Known, 4> beside{at(west, d), at(north, d), at(c, westOf), at(c, northOf)};
    if (west == kNone) beside[0].number = beside[1].number = beside[2].number;
    if (westOf == kNone) beside[2].number = beside[0].number, beside[3].number = beside[1].number;
    const auto [a, b, e, f] = beside;
    const std::int64_t sum = 2 * (plane(a, e, at(west, westOf)) + plane(b, f, at(north, northOf)) +
                                  plane(b, e, at(north, westOf)) + plane(a, f, at(west, northOf))) +
                             a.number + b.number + e.number + f.number;
    const auto [least, most] = std::minmax({a.number, b.number, e.number, f.number});
    std::int32_t misses = 0, lean = 0;
    for (const Known& known : beside) misses += std::abs(known.miss), lean += known.miss;
    const auto prediction = static_cast<std::int32_t>((sum + kWeights / 2) / kWeights);
    const std::int64_t past = sum - std::int64_t{kWeights} * prediction;
    const std::uint32_t size = std::min(
        halfOctaveOf(static_cast<std::uint32_t>(6 * misses) + 4 * static_cast<std::uint32_t>(most - least)),
        kSizes - 1);
    return {prediction, (size * kLeans + sideOf(past)) * kSigns + sideOf(lean)};
  }

  /// 0 below -1, 2 above 1, 1 between.
  static std::uint32_t sideOf(std::int64_t value) { return value > 1 ? 2 : value < -1 ? 0 : 1; }

  /// On a plane through the three, but never beyond its neighbours: an edge between charts stays an edge.
  static std::int64_t plane(const Known& a, const Known& b, const Known& corner) {
    return std::clamp(a.number + b.number - corner.number, std::min(a.number, b.number),
                      std::max(a.number, b.number));
  }

  Known at(std::uint32_t c, std::uint32_t d) const {
    if (c == kNone || d == kNone) return {};
    const std::size_t place = c >= d ? placeOf(c, d) : placeOf(d, c);
    return {number_[place], miss_[place]};
  }
  std::size_t placeOf(std::uint32_t c, std::uint32_t d) const { return rowStart(c) + d; }
  std::size_t rowStart(std::uint32_t c) const {
    const std::size_t inTriangle = std::min(c, count_);
    return inTriangle * (inTriangle + 1) / 2 +
           std::size_t{c - static_cast<std::uint32_t>(inTriangle)} * count_;
  }

  static constexpr std::int32_t kWeights = 12, kMostMissed = 127;
  static constexpr std::uint32_t kSizes = 26, kLeans = 3, kSigns = 3;
  std::uint32_t count_;
  GroupNeighbours beside_;
  std::vector<std::int32_t> number_;  // H's lower triangle, then the receivers' rows
  std::vector<std::int8_t> miss_;     // by how much each was not what was expected
  ResidualContexts residuals_;
};

/// One number of the rest: which group, how many steps.
struct RestEntry {
  std::uint32_t group;
  std::int32_t number;
};

/// Rows of the rest on their way through a coder. Groups that the row to the left or above has something of
/// are likely and come first; the others are told by the gaps between them.
class RestModel {
 public:
  RestModel(const Patches& patches, std::uint32_t groups)
      : patches_(patches),
        groups_(groups),
        rows_(patches.rows()),
        flags_(kStrengths * kStrengths * kLeft),
        numbers_(kNumberContexts) {}

  /// Codes row p, whose groups ascend; a decoder fills it. False: they do not. Rows come in order.
  template <class Coder>
  bool code(Coder& coder, std::uint32_t p, std::vector<RestEntry>& row) {
    const std::vector<RestEntry>& left = rowOr(patches_.left[p], none_);
    const std::vector<RestEntry>& up = rowOr(patches_.up[p], none_);
    const std::vector<RestEntry> original = std::move(row);
    row.clear();
    std::uint32_t count = codeCount(coder, p, static_cast<std::uint32_t>(original.size()));
    if (count > groups_) return false;
    std::vector<RestEntry> others;
    std::size_t next = 0;
    for (std::size_t i = 0, j = 0; count > 0 && (i < left.size() || j < up.size());) {
      const std::uint32_t group = std::min(groupAt(left, i), groupAt(up, j));
      const std::int32_t a = groupAt(left, i) == group ? left[i++].number : 0,
                         b = groupAt(up, j) == group ? up[j++].number : 0;
      while (groupAt(original, next) < group) others.push_back(original[next++]);
      const bool isThere = groupAt(original, next) == group;
      const std::int32_t number = isThere ? original[next++].number : 0;
      AdaptiveBit& flag =
          flags_[(strengthOf(a) * kStrengths + strengthOf(b)) * kLeft + std::min(count, kLeft) - 1];
      if (!coder.bit(flag, isThere)) continue;
      row.push_back({group, codeNumber(coder, 1 + contextOf(a, b), number)});
      --count;
    }
    others.insert(others.end(), original.begin() + static_cast<std::ptrdiff_t>(next), original.end());
    if (!codeOthers(coder, count, others)) return false;
    row.insert(row.end(), others.begin(), others.end());
    const auto byGroup = [](const RestEntry& x, const RestEntry& y) { return x.group < y.group; };
    std::sort(row.begin(), row.end(), byGroup);
    rows_[p] = row;
    return std::adjacent_find(row.begin(), row.end(), [](const RestEntry& x, const RestEntry& y) {
             return x.group == y.group;
           }) == row.end();
  }

 private:
  template <class Coder>
  std::uint32_t codeCount(Coder& coder, std::uint32_t p, std::uint32_t count) {
    const std::uint32_t west = patches_.left[p], north = patches_.up[p];
    const std::size_t beside = rowOr(west != kNone ? west : north != kNone ? north : p - 1, none_).size();
    const std::size_t above = north != kNone ? rows_[north].size() : beside;
    const auto activity = static_cast<std::uint32_t>(8 * (beside + above));
    return static_cast<std::uint32_t>(
        counts_.code(coder, activity, ResidualModel::kOrdinary, 0, static_cast<std::int32_t>(count)));
  }

  /// `count` entries of groups that are not likely.
  template <class Coder>
  bool codeOthers(Coder& coder, std::uint32_t count, std::vector<RestEntry>& others) {
    others.resize(count);
    std::uint32_t from = 0;
    for (std::uint32_t left = count; RestEntry & entry : others) {
      const std::uint32_t activity = 8 * (groups_ - from) / (left-- + 1);
      const std::int32_t gap = gaps_.code(coder, activity, ResidualModel::kOrdinary, 0,
                                          static_cast<std::int32_t>(entry.group - from));
      if (gap < 0 || static_cast<std::uint32_t>(gap) >= groups_ - from) return false;
      entry.group = from + static_cast<std::uint32_t>(gap);
      entry.number = codeNumber(coder, 0, entry.number);
      from = entry.group + 1;
    }
    return true;
  }

  template <class Coder>
  std::int32_t codeNumber(Coder& coder, std::uint32_t context, std::int32_t number) {
    return numbers_.code(coder, context, number, kLargestExchangeNumber, kLargestExchangeNumber);
  }

  const std::vector<RestEntry>& rowOr(std::uint32_t p, const std::vector<RestEntry>& otherwise) const {
    return p < rows_.size() ? rows_[p] : otherwise;
  }
  static std::uint32_t groupAt(const std::vector<RestEntry>& row, std::size_t i) {
    return i < row.size() ? row[i].group : kNone;
  }
  static std::uint32_t strengthOf(std::int32_t number) {
    return static_cast<std::uint32_t>(std::min(std::abs(number), 3));
  }
  /// 0..7, of what the rows beside have of a group.
  static std::uint32_t contextOf(std::int32_t a, std::int32_t b) {
    return (a != 0 && b != 0 ? 4u : 0u) + (a + b > 0 ? 2u : 0u) + (std::abs(a + b) > 2 ? 1u : 0u);
  }

  static constexpr std::uint32_t kStrengths = 4, kLeft = 16, kNumberContexts = 9;
  const Patches& patches_;
  std::uint32_t groups_;
  std::vector<std::vector<RestEntry>> rows_;  // that were coded
  const std::vector<RestEntry> none_;
  std::vector<AdaptiveBit> flags_;
  ResidualModel counts_, gaps_;
  ResidualContexts numbers_;
};

}  // namespace

std::uint32_t exchangeColumns(const ExchangeGroups& groups, std::uint32_t group) {
  return group < groups.count ? group + 1 : groups.count;
}

std::vector<double> areasOf(const Patches& patches, const ExchangeGroups& groups) {
  std::vector<double> area(groups.total, 0);
  for (std::uint32_t p = 0; p < patches.rows(); ++p) area[groups.ofRow[p]] += patches.area[p];
  return area;
}

std::vector<std::uint8_t> encodeExchangeMeans(const Patches& patches, const ExchangeGroups& groups,
                                              const Exchange& exchange) {
  const std::vector<double> area = areasOf(patches, groups);
  RangeEncoder out;
  MeansModel model(patches, groups);
  for (std::uint32_t c = 0; c < groups.total; ++c)
    for (std::uint32_t d = 0; d < exchangeColumns(groups, c); ++d) {
      const double coupling =
          exchange.means[std::size_t{c} * groups.count + d] * std::sqrt(area[c] * area[d]);
      const auto number = static_cast<std::int32_t>(std::clamp<double>(
          std::round(std::sqrt(std::max(0.0, coupling)) / kExchangeMeanStep), 0, kLargestExchangeNumber));
      model.code(out, c, d, number);
    }
  return out.finish();
}

std::string decodeExchangeMeans(std::span<const std::uint8_t> bytes, const Patches& patches,
                                const ExchangeGroups& groups, Exchange& exchange, double step) {
  RangeDecoder in(bytes);
  MeansModel model(patches, groups);
  const std::string fault = fillExchangeMeans(patches, groups, step, exchange,
                                              [&](auto c, auto d) { return model.code(in, c, d, 0); });
  return !fault.empty() ? fault : in.ended() ? "" : kNoFit;
}

std::vector<std::uint8_t> encodeExchangeRest(const Patches& patches, const ExchangeGroups& groups,
                                             const Exchange& exchange) {
  const std::vector<double> area = areasOf(patches, groups);
  RangeEncoder out;
  RestModel model(patches, groups.count);
  std::vector<RestEntry> row;
  for (std::uint32_t p = 0; p < patches.rows(); ++p) {
    row.clear();
    for (std::uint32_t i = exchange.offset[p]; i < exchange.offset[p + 1]; ++i) {
      const std::uint32_t d = exchange.group[i];
      const double coupling = exchange.rest[i] * std::sqrt(patches.area[p] * area[d]);
      const auto number = static_cast<std::int32_t>(std::clamp<double>(
          std::round(coupling / kExchangeRestStep), -kLargestExchangeNumber, kLargestExchangeNumber));
      if (number != 0) row.push_back({d, number});
    }
    model.code(out, p, row);
  }
  return out.finish();
}

std::string decodeExchangeRest(std::span<const std::uint8_t> bytes, const Patches& patches,
                               const ExchangeGroups& groups, Exchange& exchange, double step) {
  const std::vector<double> area = areasOf(patches, groups);
  exchange.offset.assign(1, 0), exchange.group.clear(), exchange.rest.clear();
  RangeDecoder in(bytes);
  RestModel model(patches, groups.count);
  std::vector<RestEntry> row;
  for (std::uint32_t p = 0; p < patches.rows(); ++p) {
    row.clear();
    if (!model.code(in, p, row)) return "a group is not there, or is there twice";
    if (in.ranOut() || exchange.group.size() + row.size() > kMostRestEntries)
      return "it announces more values than it has";
    for (const auto& [group, number] : row) {
      const auto rest = static_cast<float>(step * number / std::sqrt(patches.area[p] * area[group]));
      if (!(std::abs(rest) < kStrongestExchange)) return kExchangeOutOfRange;
      exchange.group.push_back(group), exchange.rest.push_back(rest);
    }
    exchange.offset.push_back(static_cast<std::uint32_t>(exchange.group.size()));
  }
  return in.ended() ? "" : kNoFit;
}

}  // namespace fiatlux
