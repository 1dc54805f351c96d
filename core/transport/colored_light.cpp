#include "core/transport/colored_light.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cassert>
#include <cmath>

namespace fiatlux {
namespace {

constexpr std::array<double, 3> kLuminance = {0.2126, 0.7152, 0.0722};  // of linear RGB, Rec. 709
constexpr float kMostReflectance = 0.95f;
constexpr std::uint32_t kMostRegions = 256;  // smaller surfaces share the last one
constexpr double kGreyUpTo = 1e-4;           // of a reflectance: no colour, but rounding
constexpr float kMostTaken = 0.6f;           // of the light in a channel, by what it has met

using GroupMatrix = Eigen::Matrix<float, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

template <class Values>
double luminanceOf(const Values& color) {
  return kLuminance[0] * color[0] + kLuminance[1] * color[1] + kLuminance[2] * color[2];
}

/// Groups overrate what reaches a gap that they do not resolve. Keeps the hue of D_k, `added`, and takes of
/// no channel of E, `white`, more than light loses that has met colours once or twice.
void moderate(float* added, float white) {
  const float taken = -std::min({added[0], added[1], added[2]});
  if (taken <= kMostTaken * white) return;
  for (int k = 0; k < 3; ++k) added[k] *= kMostTaken * white / taken;
}

/// The region of each group: its surface, or one for all but the largest.
std::vector<std::uint32_t> regionsOf(const Scene& scene) {
  const Patches& patches = scene.patches;
  const ExchangeGroups& groups = scene.lightOperator->groups;
  std::vector<std::uint32_t> order(scene.surfaces.size()), region(order.size()), ofGroup(groups.count);
  for (std::uint32_t s = 0; s < order.size(); ++s) order[s] = s;
  std::stable_sort(order.begin(), order.end(), [&](std::uint32_t a, std::uint32_t b) {
    return scene.surfaces[a].area > scene.surfaces[b].area;
  });
  for (std::uint32_t i = 0; i < order.size(); ++i) region[order[i]] = std::min(i, kMostRegions - 1);
  for (std::uint32_t p = 0; p < patches.count; ++p) ofGroup[groups.ofRow[p]] = region[patches.surface[p]];
  return ofGroup;
}

}  // namespace

struct ColoredLight::Regions {
  std::vector<std::uint32_t> ofGroup;
  GroupMatrix mean;  // regions x groups: mean lx over a region per lumen that leaves a group
  std::array<Eigen::PartialPivLU<Eigen::MatrixXd>, kChannels> solver;  // of I - mean Delta, between regions
};

ColoredLight::ColoredLight(const Scene& scene, const std::vector<float>& colors,
                           const std::vector<float>& reflectance)
    : scene_(scene), interpolation_(scene.patches, scene.lightOperator->groups) {
  assert(colors.size() == std::size_t{3} * scene.patches.count);
  assert(reflectance.size() >= scene.patches.count);
  setChanges(colors, reflectance);
  if (grey_) return;
  const std::uint32_t groups = scene.lightOperator->groups.count;
  const Eigen::Map<const GroupMatrix> exchange(scene.lightOperator->exchange.means.data(), groups, groups);
  auto made = std::make_unique<Regions>();
  made->ofGroup = regionsOf(scene);
  const std::uint32_t count = 1 + *std::max_element(made->ofGroup.begin(), made->ofGroup.end());
  std::vector<double> area(count, 0.0);
  for (std::uint32_t c = 0; c < groups; ++c) area[made->ofGroup[c]] += interpolation_.areas()[c];
  made->mean = GroupMatrix::Zero(count, groups);
  for (std::uint32_t c = 0; c < groups; ++c) {
    const std::uint32_t region = made->ofGroup[c];
    if (area[region] > 0)
      made->mean.row(region) +=
          static_cast<float>(interpolation_.areas()[c] / area[region]) * exchange.row(c);
  }
  for (int k = 0; k < kChannels; ++k) {
    Eigen::MatrixXd system = Eigen::MatrixXd::Identity(count, count);
    for (std::uint32_t d = 0; d < groups; ++d)
      system.col(made->ofGroup[d]) -= lumens_[k][d] * made->mean.col(d).cast<double>();
    made->solver[k].compute(system);
  }
  regions_ = std::move(made);
}

ColoredLight::~ColoredLight() = default;

void ColoredLight::setChanges(const std::vector<float>& colors, const std::vector<float>& reflectance) {
  const Patches& patches = scene_.patches;
  const ExchangeGroups& groups = scene_.lightOperator->groups;
  for (int k = 0; k < kChannels; ++k) {
    change_[k].resize(patches.count);
    lumens_[k].assign(groups.count, 0.0f);
  }
  for (std::uint32_t p = 0; p < patches.count; ++p) {
    const float* color = &colors[std::size_t{3} * p];
    const double luminance = luminanceOf(color);
    for (int k = 0; k < kChannels; ++k) {
      const float own = reflectance[p];
      float change = 0;
      if (luminance > 0 && std::abs(color[k] / luminance - 1) > kGreyUpTo)
        change = std::min(kMostReflectance, static_cast<float>(own * color[k] / luminance)) - own;
      change_[k][p] = change;
      lumens_[k][groups.ofRow[p]] +=
          static_cast<float>(patches.area[p]) * (own + change - patches.reflectance[p]);
      if (change != 0) grey_ = false;
    }
  }
}

std::vector<float> ColoredLight::of(const std::vector<float>& illuminance) const {
  const Patches& patches = scene_.patches;
  const ExchangeGroups& groups = scene_.lightOperator->groups;
  assert(illuminance.size() == patches.rows());
  std::vector<float> colors(std::size_t{2} * patches.rows(), 1.0f);
  if (grey_) return colors;

  // D_k between groups; receivers take that of no surface, for nobody sees what is measured there.
  const Eigen::Map<const GroupMatrix> exchange(scene_.lightOperator->exchange.means.data(), groups.count,
                                               groups.count);
  constexpr std::size_t kWhite = kChannels, kColumns = kChannels + 1;  // D_k, and E beside it
  std::vector<float> smooth(std::size_t{groups.total} * kColumns, 0.0f), onRow(patches.rows() * kColumns);
  std::vector<float> white(groups.total);
  interpolation_.means(illuminance.data(), 1, white.data());
  for (std::uint32_t c = 0; c < groups.count; ++c) smooth[c * kColumns + kWhite] = white[c];
  for (int k = 0; k < kChannels; ++k) {
    Eigen::VectorXf lumens = Eigen::VectorXf::Zero(groups.count);
    for (std::uint32_t p = 0; p < patches.count; ++p)
      lumens[groups.ofRow[p]] += static_cast<float>(patches.area[p]) * change_[k][p] * illuminance[p];
    const Eigen::VectorXd means = regions_->solver[k].solve((regions_->mean * lumens).cast<double>());
    for (std::uint32_t d = 0; d < groups.count; ++d)
      lumens[d] += lumens_[k][d] * static_cast<float>(means[regions_->ofGroup[d]]);
    const Eigen::VectorXf added = exchange * lumens;
    for (std::uint32_t c = 0; c < groups.count; ++c) smooth[c * kColumns + k] = added[c];
  }

  // What is smooth is spread over the patches; their own light is known patch by patch. Where that is more,
  // it came directly and met no colour; where it is less, in a gap or a shadow, less colour reached it, too.
  interpolation_.apply(smooth.data(), kColumns, onRow.data());
  for (std::uint32_t p = 0; p < patches.count; ++p) {
    if (!(illuminance[p] > 0)) continue;
    float* added = &onRow[p * kColumns];
    const float around = std::max(added[kWhite], illuminance[p]);
    moderate(added, around);
    std::array<float, kChannels> light;
    for (int k = 0; k < kChannels; ++k) light[k] = 1 + added[k] / around;
    const double luminance = luminanceOf(light);
    colors[2 * p] = static_cast<float>(light[0] / luminance);
    colors[2 * p + 1] = static_cast<float>(light[2] / luminance);
  }
  return colors;
}

}  // namespace fiatlux
