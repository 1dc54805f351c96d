// U x by blocks of rows and clusters that are passed over (cluster_product) against the sum written out.
#include "core/transport/cluster_product.h"

#include <gtest/gtest.h>

#include <vector>

#include "core/base/random.h"

namespace fiatlux {
namespace {

TEST(ClusterProduct, IsTheSumOverAllClusters) {
  Random random(2);
  for (const std::uint32_t width : {3u, 8u, 16u, 32u}) {
    for (const std::size_t clusters : {5u, 8u, 61u, 64u}) {
      for (const std::size_t rows : {2u, 4u, 11u}) {
        std::vector<float> u(rows * clusters), x(clusters * width), product(rows * width, -1);
        // Rows see runs of clusters, and the fifth sees none.
        for (std::size_t at = 0; at < u.size(); ++at) {
          const bool isSeen = at % clusters / 9 % 3 == at / clusters / 4 && at / clusters != 4;
          u[at] = isSeen ? static_cast<float>(random.unit()) : 0.0f;
        }
        for (float& value : x) value = static_cast<float>(random.unit());
        clusterProduct(u.data(), rows, clusters, x.data(), width, product.data());
        for (std::size_t at = 0; at < product.size(); ++at) {
          double sum = 0;
          for (std::size_t c = 0; c < clusters; ++c)
            sum += double{u[at / width * clusters + c]} * x[c * width + at % width];
          EXPECT_NEAR(product[at], sum, 1e-5 * sum) << width << ' ' << clusters << ' ' << rows << ' ' << at;
        }
      }
    }
  }
}

}  // namespace
}  // namespace fiatlux
