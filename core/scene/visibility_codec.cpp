#include "core/scene/visibility_codec.h"

#include <algorithm>
#include <array>
#include <limits>

#include "core/scene/range_coder.h"
#include "core/scene/residual_model.h"

namespace fiatlux {
namespace {

constexpr double kSameDistance = 1e-6;  // m: of two sites as far away the later is taken

std::uint8_t storedOf(std::uint8_t step, std::uint32_t whole) {
  return static_cast<std::uint8_t>((2 * step * whole + SiteVisibility::kSteps) /
                                   (2 * SiteVisibility::kSteps));
}
std::uint8_t stepOfStored(std::uint8_t stored, std::uint32_t whole) {
  return static_cast<std::uint8_t>((2 * stored * SiteVisibility::kSteps + whole) / (2 * whole));
}

/// The nearest site before the one that comes just before: across the row, where sites hang in rows. j - 1
/// where there is none.
std::uint32_t acrossOf(const std::vector<Site>& sites, std::uint32_t first, std::uint32_t j) {
  std::uint32_t nearest = j - 1;
  double least = std::numeric_limits<double>::infinity();
  for (std::uint32_t i = first; i + 1 < j; ++i)
    if (const double apart = length(sites[i].position - sites[j].position); apart <= least + kSameDistance)
      least = apart, nearest = i;
  return nearest;
}

/// Stored shares column after column through a coder, which writes (RangeEncoder) or reads (RangeDecoder)
/// them.
class VisibilityModel {
 public:
  VisibilityModel(const Patches& patches, std::uint32_t whole)
      : patches_(patches),
        whole_(static_cast<int>(whole)),
        right_(patches.rows(), kNone),
        down_(patches.rows(), kNone),
        kinds_(kKindContexts),
        shares_((2 * whole + 1) * 2 * kSpreads) {
    for (std::uint32_t p = 0; p < patches.rows(); ++p) {
      if (patches.left[p] != kNone) right_[patches.left[p]] = p;
      if (patches.up[p] != kNone) down_[patches.up[p]] = p;
    }
  }

  /// Columns of other sites: the one before, the one before that, across the row and before that.
  struct Known {
    const std::uint8_t *before, *earlier, *across, *acrossBefore;
  };

  /// Codes what rows see of one site; a decoder writes it.
  template <class Coder>
  void codeColumn(Coder& coder, const Known& known, std::uint8_t* column) {
    for (std::uint32_t p = 0; p < patches_.rows(); ++p) {
      const Around around = aroundOf(known, column, p);
      auto& [partly, wholly] = kinds_[contextOf(around)];
      if (!coder.bit(partly, kindOf(column[p]) == 1)) {
        column[p] = static_cast<std::uint8_t>(coder.bit(wholly, column[p] == whole_) ? whole_ : 0);
        continue;
      }
      const int halves = expectedHalves(around), prediction = std::clamp((halves + 1) / 2, 1, whole_ - 1);
      const std::uint32_t context =
          (static_cast<std::uint32_t>(halves) * kSpreads + spreadOf(around)) * 2 + around.isAlone;
      column[p] = static_cast<std::uint8_t>(
          prediction + shares_.code(coder, context, column[p] - prediction,
                                    static_cast<std::uint32_t>(prediction - 1),
                                    static_cast<std::uint32_t>(whole_ - 1 - prediction)));
    }
  }

 private:
  /// What is known when a cell's turn comes: of its own site left and up, of the site before also beyond.
  struct Around {
    bool isAlone;  // no cell beside it: what is left and up is then across
    int left, up, before, beforeLeft, beforeRight, beforeDown, earlier, across, acrossLeft, acrossBefore;
  };

  Around aroundOf(const Known& known, const std::uint8_t* column, std::uint32_t p) const {
    const auto at = [](const std::uint8_t* of, std::uint32_t cell, int otherwise) {
      return cell == kNone ? otherwise : int{of[cell]};
    };
    const std::uint32_t west = patches_.left[p], north = patches_.up[p];
    const int before = known.before[p], across = known.across[p];
    const int left = at(column, west, at(column, north, across));
    return {west == kNone && north == kNone,
            left,
            at(column, north, left),
            before,
            at(known.before, west, before),
            at(known.before, right_[p], before),
            at(known.before, down_[p], before),
            known.earlier[p],
            across,
            at(known.across, west, across),
            known.acrossBefore[p]};
  }

  /// 0 not seen, 1 partly, 2 wholly.
  std::uint32_t kindOf(int share) const { return share == 0 ? 0 : share == whole_ ? 2 : 1; }

  std::uint32_t contextOf(const Around& a) const {
    std::uint32_t context = 0;
    for (const int share :
         {a.left, a.up, a.before, a.beforeRight, a.beforeDown, a.earlier, a.across, a.acrossBefore})
      context = 3 * context + kindOf(share);
    return context;
  }

  /// In half steps, 0..2 whole.
  int expectedHalves(const Around& a) const {
    const auto within = [&](int share) { return std::clamp(share, 0, whole_); };
    const int onward = within(a.before + a.across - a.acrossBefore);
    if (a.isAlone) return (3 * a.before + 3 * a.across + onward + a.earlier) / 4;
    return (a.before + a.across + a.left + a.up + within(a.left + a.before - a.beforeLeft) + onward +
            2 * within(a.left + a.across - a.acrossLeft)) /
           4;
  }

  static std::uint32_t spreadOf(const Around& a) {
    const auto [least, most] = std::minmax({a.left, a.up, a.before, a.across});
    const auto spread = static_cast<std::uint32_t>(most - least);
    return spread < 4 ? spread : spread < 6 ? 4 : 5;
  }

  static constexpr std::uint32_t kKindContexts = 3 * 3 * 3 * 3 * 3 * 3 * 3 * 3, kSpreads = 6;
  struct Kinds {
    AdaptiveBit partly, wholly;
  };

  const Patches& patches_;
  int whole_;
  std::vector<std::uint32_t> right_, down_;  // rows: the next cell on the same chart, or kNone
  std::vector<Kinds> kinds_;
  ResidualContexts shares_;
};

/// Columns of the sites [first, last), which follow one another.
template <class Coder>
void codeColumns(Coder& coder, const Patches& patches, const std::vector<Site>& sites, std::uint32_t first,
                 std::uint32_t last, std::uint32_t whole, std::uint8_t* columns) {
  const std::size_t rows = patches.rows();
  const std::vector<std::uint8_t> none(rows, 0);
  VisibilityModel model(patches, whole);
  const auto columnOf = [&](std::int64_t j) {
    return j < std::int64_t{first} ? none.data() : columns + static_cast<std::size_t>(j - first) * rows;
  };
  for (std::int64_t j = first; j < std::int64_t{last}; ++j) {
    const std::int64_t across = j > first ? acrossOf(sites, first, static_cast<std::uint32_t>(j)) : j - 1;
    const std::int64_t acrossBefore = across > first ? across - 1 : across;
    model.codeColumn(coder, {columnOf(j - 1), columnOf(j - 2), columnOf(across), columnOf(acrossBefore)},
                     columns + static_cast<std::size_t>(j - first) * rows);
  }
}

}  // namespace

std::vector<std::uint8_t> encodeVisibility(const Patches& patches, const std::vector<Site>& sites,
                                           const SiteVisibility& visibility, std::uint32_t first,
                                           std::uint32_t last) {
  std::vector<std::uint8_t> columns(visibility.column(first), visibility.column(last));
  for (std::uint8_t& share : columns) share = storedOf(share, kStoredShares);
  RangeEncoder out;
  codeColumns(out, patches, sites, first, last, kStoredShares, columns.data());
  return out.finish();
}

std::string decodeVisibility(std::span<const std::uint8_t> bytes, const Patches& patches,
                             const std::vector<Site>& sites, std::uint32_t first, std::uint32_t last,
                             SiteVisibility& visibility, std::uint32_t stored) {
  RangeDecoder in(bytes);
  std::uint8_t* const columns = visibility.steps.data() + std::size_t{first} * visibility.rows;
  codeColumns(in, patches, sites, first, last, stored, columns);
  for (std::size_t i = 0; i < std::size_t{last - first} * visibility.rows; ++i)
    columns[i] = stepOfStored(columns[i], stored);
  return in.ended() ? "" : "its length does not fit its values";
}

}  // namespace fiatlux
