// The best of all moves in one pass against every move summed by itself.
#include "core/search/move_rows.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

#include "core/base/random.h"

namespace fiatlux {
namespace {

constexpr float kFactor = -0.7f, kEdgeFactor = 0.4f;
const std::vector<std::uint32_t> kFrom = {3, 0, 11};

/// Random rows over some candidates, with one edge of its own product and one without.
struct Problem {
  std::vector<float> coming, edge, plainEdge, covariance, leaving;
  std::uint32_t candidates;

  explicit Problem(std::uint32_t count) : candidates(count) {
    Random random(count);
    const auto fill = [&](std::vector<float>& values, std::size_t size) {
      for (std::size_t k = 0; k < size; ++k) values.push_back(static_cast<float>(random.unit() - 0.5));
    };
    for (std::vector<float>* row : {&coming, &edge, &plainEdge}) fill(*row, count);
    fill(covariance, std::size_t{count} * count);
    fill(leaving, 3 * kFrom.size());
  }

  RowMove least() const {
    const MoveProduct products[] = {{covariance.data(), kFactor}};
    const MoveEdge edges[] = {{edge.data(), {covariance.data(), kEdgeFactor}}, {plainEdge.data(), {}}};
    return leastMove({candidates, coming.data(), products, edges}, kFrom, leaving.data());
  }

  float worthOf(std::uint32_t luminaire, std::uint32_t to) const {
    const float product = covariance[std::size_t{kFrom[luminaire]} * candidates + to];
    const float* left = leaving.data() + 3 * std::size_t{luminaire};
    return coming[to] + left[0] + kFactor * product +
           std::max(0.0f, edge[to] + left[1] + kEdgeFactor * product) +
           std::max(0.0f, plainEdge[to] + left[2]);
  }
};

TEST(LeastMove, IsTheLeastOfAll) {
  for (const std::uint32_t candidates : {kMoveLanes, kMoveLanes + 1, 3 * kMoveLanes - 1, 4 * kMoveLanes}) {
    const Problem problem(candidates);
    const RowMove found = problem.least();
    ASSERT_LT(found.candidate, candidates);
    ASSERT_LT(found.luminaire, kFrom.size());
    EXPECT_NEAR(problem.worthOf(found.luminaire, found.candidate), found.worth, 1e-6);
    for (std::uint32_t i = 0; i < kFrom.size(); ++i)
      for (std::uint32_t to = 0; to < candidates; ++to)
        EXPECT_GE(problem.worthOf(i, to), found.worth - 1e-6f);
  }
}

TEST(LeastMove, OfEqualsIsTheFirst) {
  Problem problem(2 * kMoveLanes + 3);
  for (std::vector<float>* values :
       {&problem.coming, &problem.edge, &problem.plainEdge, &problem.covariance, &problem.leaving})
    std::fill(values->begin(), values->end(), 1.0f);
  problem.coming[7] = problem.coming[kMoveLanes - 1] = problem.coming[2 * kMoveLanes] = -1;
  EXPECT_EQ(problem.least().candidate, 7u);
  EXPECT_EQ(problem.least().luminaire, 0u);
}

TEST(LeastMove, IsWorthNothingWhereAllIsClosed) {
  Problem problem(kMoveLanes + 2);
  std::fill(problem.coming.begin(), problem.coming.end(), kNoMove);
  EXPECT_GE(problem.least().worth, kNoMove / 2);
}

}  // namespace
}  // namespace fiatlux
