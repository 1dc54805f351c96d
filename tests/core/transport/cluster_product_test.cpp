// U x by blocks of rows and clusters that are passed over (cluster_product) against the sum written out.
#include "core/transport/cluster_product.h"

#include <gtest/gtest.h>

#include <vector>

#include "core/base/random.h"

namespace fiatlux {
namespace {

TEST(ClusterProduct, IsTheSumOverAllClusters) {
  Random random(2);
  for (const std::uint32_t width : {3u, 8u, 16u}) {
    for (const std::size_t clusters : {5u, 8u, 61u, 64u}) {
      constexpr std::size_t kRows = 11;
      std::vector<float> u(kRows * clusters), x(clusters * width), product(kRows * width, -1);
      // Rows see runs of clusters, and the fifth sees none.
      for (std::size_t at = 0; at < u.size(); ++at) {
        const bool isSeen = at % clusters / 9 % 3 == at / clusters / 4 && at / clusters != 4;
        u[at] = isSeen ? static_cast<float>(random.unit()) : 0.0f;
      }
      for (float& value : x) value = static_cast<float>(random.unit());
      clusterProduct(u.data(), kRows, clusters, x.data(), width, product.data());
      for (std::size_t p = 0; p < kRows; ++p) {
        for (std::size_t j = 0; j < width; ++j) {
          double sum = 0;
          for (std::size_t c = 0; c < clusters; ++c) sum += double{u[p * clusters + c]} * x[c * width + j];
          EXPECT_NEAR(product[p * width + j], sum, 1e-5 * sum) << width << ' ' << clusters << ' ' << p;
        }
      }
    }
  }
}

}  // namespace
}  // namespace fiatlux
