#include "core/bound/evenness_limit.h"

#include <algorithm>
#include <cstddef>

#include "core/search/plane_values.h"

namespace fiatlux {
namespace {

constexpr double kMostProducts = 1e9;  // about a second; the limit holds whenever one stops
constexpr int kMostPlayed = 3000;
constexpr double kPlayedClosely = 0.002;  // share by which even the best split may be below the limit
constexpr double kFloatRounding = 1e-6;   // share: of light in floats and its sums

/// Columns of single luminaires, each as a share of its own mean: `points` entries a column.
struct ColumnsByMean {
  std::size_t points = 0;
  std::vector<float> entries;
  std::size_t count() const { return points == 0 ? 0 : entries.size() / points; }
  const float* column(std::size_t j) const { return entries.data() + j * points; }
};

ColumnsByMean columnsByMean(PreparedScene& prepared, const Constraint& constraint,
                            const std::vector<std::uint32_t>& excluded) {
  const std::vector<std::shared_ptr<const Responses>> light = lightAtPoints(prepared, constraint);
  std::vector<char> barred(prepared.scene().sites.size());
  for (const std::uint32_t site : excluded) barred[site] = 1;
  ColumnsByMean columns;
  for (const auto& part : light) columns.points += part->rows;
  std::vector<double> column;
  for (std::uint32_t j = 0; j < barred.size(); ++j) {
    column.clear();
    for (const auto& part : light) column.insert(column.end(), part->column(j), part->column(j) + part->rows);
    double mean = 0;
    for (const double value : column) mean += value / static_cast<double>(columns.points);
    if (barred[j] || !(mean > 0)) continue;
    for (const double value : column) columns.entries.push_back(static_cast<float>(value / mean));
  }
  return columns;
}

/// One player: how much it would rather have played each of its moves so far.
struct Player {
  std::vector<double> regrets, mix;

  explicit Player(std::size_t moves) : regrets(moves), mix(moves, 1 / static_cast<double>(moves)) {}
  void learn(const std::vector<double>& gains, double gained) {
    double sum = 0;
    for (std::size_t i = 0; i < regrets.size(); ++i)
      sum += regrets[i] = std::max(0.0, regrets[i] + gains[i] - gained);
    for (std::size_t i = 0; i < mix.size(); ++i)
      mix[i] = sum > 0 ? regrets[i] / sum : 1 / static_cast<double>(mix.size());
  }
};

double mixed(const std::vector<double>& a, const std::vector<double>& b) {
  double sum = 0;
  for (std::size_t i = 0; i < a.size(); ++i) sum += a[i] * b[i];
  return sum;
}

/// Luminaires choose where to be to light the points that count; points, how much they count.
class EvennessGame {
 public:
  explicit EvennessGame(const ColumnsByMean& columns)
      : columns_(columns),
        luminaires_(columns.count()),
        points_(columns.points),
        scores_(columns.count()),
        total_(columns.count()),
        light_(columns.points),
        losses_(columns.points),
        lit_(columns.points) {}

  /// `round` counts from 1; later ones weigh more.
  void play(double round) {
    for (std::size_t j = 0; j < scores_.size(); ++j) {
      const float* column = columns_.column(j);
      scores_[j] = 0;
      for (std::size_t p = 0; p < light_.size(); ++p) scores_[j] += points_.mix[p] * column[p];
      total_[j] += round * scores_[j];
    }
    luminaires_.learn(scores_, mixed(scores_, luminaires_.mix));
    std::fill(light_.begin(), light_.end(), 0.0);
    for (std::size_t j = 0; j < scores_.size(); ++j) {
      if (luminaires_.mix[j] == 0) continue;
      const float* column = columns_.column(j);
      for (std::size_t p = 0; p < light_.size(); ++p) light_[p] += luminaires_.mix[j] * column[p];
    }
    for (std::size_t p = 0; p < light_.size(); ++p) {
      losses_[p] = -light_[p];
      lit_[p] += round * light_[p];
    }
    points_.learn(losses_, mixed(losses_, points_.mix));
    weight_ += round;
  }

  /// What the weights so far prove, and what luminaires split over all sites reach.
  double limit() const { return *std::max_element(total_.begin(), total_.end()) / weight_; }
  double reached() const { return *std::min_element(lit_.begin(), lit_.end()) / weight_; }

 private:
  const ColumnsByMean& columns_;
  Player luminaires_, points_;
  std::vector<double> scores_, total_;
  std::vector<double> light_, losses_, lit_;
  double weight_ = 0;
};

}  // namespace

double evennessLimit(PreparedScene& prepared, const Constraint& constraint,
                     const std::vector<std::uint32_t>& excluded) {
  const ColumnsByMean columns = columnsByMean(prepared, constraint, excluded);
  if (columns.count() == 0) return columns.points == 0 ? 1 : 0;
  const double products = 2 * static_cast<double>(columns.entries.size());
  const int rounds = std::clamp(static_cast<int>(kMostProducts / products), 20, kMostPlayed);
  EvennessGame game(columns);
  double limit = 1;  // the least is never above the mean
  for (int round = 1; round <= rounds; ++round) {
    game.play(round);
    limit = std::min(limit, game.limit());
    if (limit - game.reached() <= kPlayedClosely * limit) break;
  }
  return std::min(1.0, limit * (1 + kFloatRounding));
}

}  // namespace fiatlux
