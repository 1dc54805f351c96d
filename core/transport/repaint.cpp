#include "core/transport/repaint.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cassert>
#include <string>

#include "core/base/short_number.h"

namespace fiatlux {

struct Repaint::Solver {
  Eigen::PartialPivLU<Eigen::MatrixXd> factors;
};

Result<Done> checkPaint(const Scene& scene, const std::vector<SurfacePaint>& paint) {
  if (!scene.lightOperator)
    return Error{
        "this room's file does not tell how its surfaces light each other, so nobody can say what other "
        "paint does; make it again with fiatlux precompute, without --no-exchange"};
  for (const auto& [surface, reflectance] : paint) {
    if (surface >= scene.surfaces.size())
      return Error{"paint: there is no surface " + std::to_string(surface)};
    const std::string name = "paint: \"" + scene.surfaces[surface].name + "\"";
    if (scene.surfaces[surface].measuring)
      return Error{name + " only measures light; name a surface that can be painted"};
    if (!(reflectance >= kLeastPaint && reflectance <= kMostPaint))
      return Error{name + ": a reflectance lies between 0.05 and 0.9"};
  }
  return Done{};
}

std::vector<float> paintedReflectance(const Scene& scene, const std::vector<SurfacePaint>& paint) {
  const Patches& patches = scene.patches;
  std::vector<float> reflectance(patches.reflectance.begin(), patches.reflectance.begin() + patches.count);
  std::vector<float> painted(scene.surfaces.size(), -1);
  for (const SurfacePaint& each : paint) painted[each.surface] = static_cast<float>(each.reflectance);
  for (std::uint32_t p = 0; p < patches.count; ++p)
    if (painted[patches.surface[p]] >= 0) reflectance[p] = painted[patches.surface[p]];
  return reflectance;
}

Repaint::Repaint(const Scene& scene, const ExchangeOperator& exchange, const std::vector<float>& reflectance)
    : scene_(scene), exchange_(exchange), reflectance_(reflectance) {
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

double Repaint::meanReflectance(std::uint32_t surface) const {
  const Patches& patches = scene_.patches;
  double area = 0, sum = 0;
  for (std::uint32_t p = 0; p < patches.count; ++p) {
    if (patches.surface[p] != surface) continue;
    area += patches.area[p];
    sum += patches.area[p] * reflectance_[p];
  }
  return area > 0 ? sum / area : 0;
}

std::vector<float> Repaint::light(const std::vector<float>& light, std::uint32_t columns) const {
  if (groups_.empty()) return light;
  const Patches& patches = scene_.patches;
  const std::size_t rows = patches.rows();
  const std::vector<std::uint32_t>& ofRow = scene_.lightOperator->groups.ofRow;
  std::vector<std::uint32_t> place(scene_.lightOperator->groups.count, kNone);
  for (std::uint32_t i = 0; i < groups_.size(); ++i) place[groups_[i]] = i;

  // What the new paint reflects more: at once, and of what comes back.
  Eigen::MatrixXd lumens = Eigen::MatrixXd::Zero(static_cast<Eigen::Index>(groups_.size()), columns);
  for (std::uint32_t j = 0; j < columns; ++j)
    for (std::uint32_t p = 0; p < patches.count; ++p)
      if (change_[p] != 0) lumens(place[ofRow[p]], j) += patches.area[p] * change_[p] * light[j * rows + p];
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
                                       const std::vector<float>& light,
                                       const std::vector<std::uint32_t>& surfaces) {
  const Patches& patches = scene.patches;
  const ExchangeGroups& groups = scene.lightOperator->groups;
  std::vector<std::uint32_t> column(scene.surfaces.size(), kNone);
  for (std::uint32_t j = 0; j < surfaces.size(); ++j) column[surfaces[j]] = j;
  std::vector<float> sources(groups.count * surfaces.size(), 0.0f);
  for (std::uint32_t p = 0; p < patches.count; ++p) {
    const std::uint32_t j = column[patches.surface[p]];
    if (j != kNone)
      sources[groups.ofRow[p] * surfaces.size() + j] += static_cast<float>(patches.area[p] * light[p]);
  }
  return exchange.spread(sources, static_cast<std::uint32_t>(surfaces.size()));
}

}  // namespace fiatlux
