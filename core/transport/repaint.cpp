#include "core/transport/repaint.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cassert>

namespace fiatlux {

struct Repaint::Solver {
  Eigen::PartialPivLU<Eigen::MatrixXd> factors;
};

Repaint::Repaint(const Scene& scene, const ExchangeOperator& exchange, const std::vector<float>& reflectance)
    : scene_(scene), exchange_(exchange) {
  const Patches& patches = scene.patches;
  const std::vector<std::uint32_t>& ofRow = scene.lightOperator->groups.ofRow;
  assert(reflectance.size() == patches.count);
  // Delta, lumens per lux, of each group; the groups where there is any.
  std::vector<double> delta(scene.lightOperator->groups.count, 0.0);
  std::vector<char> painted(delta.size(), 0);
  for (std::uint32_t p = 0; p < patches.count; ++p) {
    change_.push_back(reflectance[p] - patches.reflectance[p]);
    delta[ofRow[p]] += patches.area[p] * change_[p];
    if (change_[p] != 0) painted[ofRow[p]] = 1;
  }
  for (std::uint32_t c = 0; c < painted.size(); ++c)
    if (painted[c]) groups_.push_back(c);

  const auto q = static_cast<Eigen::Index>(groups_.size());
  Eigen::MatrixXd system = Eigen::MatrixXd::Identity(q, q);
  for (Eigen::Index i = 0; i < q; ++i)
    for (Eigen::Index j = 0; j < q; ++j)
      system(i, j) -= delta[groups_[i]] * exchange.between(groups_[i], groups_[j]);
  solver_ = std::make_unique<const Solver>(Solver{system.partialPivLu()});
}

Repaint::~Repaint() = default;

std::vector<float> Repaint::light(const std::vector<float>& light, std::uint32_t columns) const {
  if (groups_.empty()) return light;
  const Patches& patches = scene_.patches;
  const std::size_t rows = patches.rows();
  const std::vector<std::uint32_t>& ofRow = scene_.lightOperator->groups.ofRow;
  std::vector<std::uint32_t> place(scene_.lightOperator->groups.count, kNone);
  for (std::uint32_t i = 0; i < groups_.size(); ++i) place[groups_[i]] = i;

  // What the new paint reflects more: at once, and of what comes back.
  Eigen::MatrixXd lumens = Eigen::MatrixXd::Zero(static_cast<Eigen::Index>(groups_.size()), columns);
  for (std::uint32_t p = 0; p < patches.count; ++p) {
    if (change_[p] == 0) continue;
    for (std::uint32_t j = 0; j < columns; ++j)
      lumens(place[ofRow[p]], j) += patches.area[p] * change_[p] * light[j * rows + p];
  }
  lumens = solver_->factors.solve(lumens);

  // Where it goes.
  std::vector<float> sources(place.size() * columns, 0.0f);
  for (std::size_t i = 0; i < groups_.size(); ++i)
    for (std::uint32_t j = 0; j < columns; ++j)
      sources[std::size_t{groups_[i]} * columns + j] = static_cast<float>(lumens(i, j));
  std::vector<float> painted = exchange_.spread(sources, columns);
  for (std::size_t i = 0; i < painted.size(); ++i) painted[i] = std::max(0.0f, light[i] + painted[i]);
  return painted;
}

std::vector<float> lightPerReflectance(const Scene& scene, const ExchangeOperator& exchange,
                                       const std::vector<float>& light, std::uint32_t surface) {
  const Patches& patches = scene.patches;
  const ExchangeGroups& groups = scene.lightOperator->groups;
  std::vector<float> sources(groups.count, 0.0f);
  for (std::uint32_t p = 0; p < patches.count; ++p)
    if (patches.surface[p] == surface)
      sources[groups.ofRow[p]] += static_cast<float>(patches.area[p] * light[p]);
  return exchange.spread(sources, 1);
}

}  // namespace fiatlux
