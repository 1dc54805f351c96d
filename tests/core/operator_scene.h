// A made-up light operator on the made-up scene (synthetic_scene.h): smooth couplings, some rest, some
// shadows.
#pragma once

#include <algorithm>
#include <cmath>

#include "tests/core/synthetic_scene.h"

namespace fiatlux {

/// Groups are blocks of 4 x 4 cells, `cells` is that of syntheticScene.
inline Scene operatorScene(std::uint32_t cells, std::uint32_t sites) {
  Scene scene = syntheticScene(cells, sites);
  const Patches& patches = scene.patches;
  const std::uint32_t rows = patches.rows();
  LightOperator op;
  op.groups.barriers.assign(rows, 0);
  op.groups.barriers[rows / 3] = ExchangeGroups::kLeftBarrier;
  for (std::uint32_t p = 0; p < rows; ++p) {
    op.charts.ofRow.push_back(patches.surface[p]);
    const bool receiver = p >= patches.count;
    op.groups.ofRow.push_back(receiver ? patches.clusterCount + (p - patches.count) / 16
                                       : patches.cluster[p]);
    op.groups.total = std::max(op.groups.total, op.groups.ofRow[p] + 1);
  }
  op.groups.count = patches.clusterCount;
  op.charts.frames = {{{0, 0, 1}, {1, 0, 0}, 0.25, 0.25},
                      {{1, 0, 0}, {0, 1, 0}, 0.25, 0.25},
                      {{0, 0, 1}, {1, 0, 0}, 0.25, 0.25}};

  const std::uint32_t k = op.groups.count, total = op.groups.total;
  op.exchange.means.resize(std::size_t{total} * k);
  for (std::uint32_t c = 0; c < total; ++c)
    for (std::uint32_t d = 0; d < k; ++d)
      op.exchange.means[c * k + d] =
          static_cast<float>(0.02 + 0.05 / (1 + std::abs(static_cast<double>(c) - d)));
  op.exchange.offset.push_back(0);
  for (std::uint32_t p = 0; p < rows; ++p) {
    if (p % 3 == 0) {
      op.exchange.group.push_back(p % k);
      op.exchange.rest.push_back(p % 2 == 0 ? 0.03f : -0.02f);
    }
    op.exchange.offset.push_back(static_cast<std::uint32_t>(op.exchange.rest.size()));
  }

  op.visibility = {rows, sites, std::vector<std::uint8_t>(std::size_t{rows} * sites, SiteVisibility::kSteps)};
  for (std::size_t i = 0; i < op.visibility.steps.size(); ++i)
    if (i % 11 < 3) op.visibility.steps[i] = static_cast<std::uint8_t>(i % (SiteVisibility::kSteps + 1));
  scene.lightOperator = std::move(op);
  return scene;
}

}  // namespace fiatlux
