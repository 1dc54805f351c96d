#include "core/scene/visibility_codec.h"

#include <algorithm>
#include <array>

#include "core/scene/range_coder.h"
#include "core/scene/residual_model.h"

namespace fiatlux {
namespace {

constexpr int kWhole = SiteVisibility::kSteps;

/// 0 not seen, 1 partly, 2 wholly.
std::uint32_t kindOf(int step) { return step == 0 ? 0 : step == kWhole ? 2 : 1; }

/// Column after column through a coder, which writes (RangeEncoder) or reads (RangeDecoder) it.
class VisibilityModel {
 public:
  explicit VisibilityModel(const Patches& patches)
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

  /// Codes the steps of one site; a decoder writes them. False: a number that no share has.
  template <class Coder>
  bool codeColumn(Coder& coder, std::uint8_t* column) {
    for (std::uint32_t p = 0; p < patches_.rows(); ++p) {
      const Around around = aroundOf(column, p);
      auto& [partly, wholly] = kinds_[contextOf(around)];
      if (!coder.bit(partly, kindOf(column[p]) == 1)) {
        column[p] = coder.bit(wholly, column[p] == kWhole) ? kWhole : 0;
        continue;
      }
      const int prediction = predictionOf(around);
      const auto activity = static_cast<std::uint32_t>(8 * spreadOf(around) + 16);
      const std::int64_t step =
          std::int64_t{prediction} +
          shares_.code(coder, activity, ResidualModel::kOrdinary, 0, column[p] - prediction);
      if (step < 0 || step > kWhole) return false;
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
      context = 3 * context + kindOf(step);
    return context;
  }

  static int predictionOf(const Around& a) {
    const int plane = std::clamp(a.left + a.before - a.beforeLeft, 0, kWhole);
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

}  // namespace

std::vector<std::uint8_t> encodeVisibility(const Patches& patches, const SiteVisibility& visibility,
                                           std::uint32_t first, std::uint32_t last) {
  RangeEncoder out;
  VisibilityModel model(patches);
  for (std::uint32_t j = first; j < last; ++j) {
    std::vector<std::uint8_t> column(visibility.column(j), visibility.column(j) + visibility.rows);
    model.codeColumn(out, column.data());
  }
  return out.finish();
}

std::string decodeVisibility(std::span<const std::uint8_t> bytes, const Patches& patches, std::uint32_t first,
                             std::uint32_t last, SiteVisibility& visibility) {
  RangeDecoder in(bytes);
  VisibilityModel model(patches);
  for (std::uint32_t j = first; j < last; ++j)
    if (!model.codeColumn(in, visibility.steps.data() + std::size_t{j} * visibility.rows))
      return "a share is out of range";
  return in.ended() ? "" : "its length does not fit its values";
}

}  // namespace fiatlux
