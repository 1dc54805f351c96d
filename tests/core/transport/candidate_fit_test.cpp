// Luminaires that touch, that pierce and that hang free, on rectangles as large as the patches (patch_tiles).
#include "core/transport/candidate_fit.h"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/core/operator_scene.h"

namespace fiatlux {
namespace {

/// The made-up corridor: its floor faces up at y = 0, its wall faces +z at z = 0, a measuring plane lies at
/// y = 0.75.
class CandidateFits : public ::testing::Test {
 protected:
  Scene scene = operatorScene(12, 3);
  CandidateFit fit{scene};

  /// Shining down, `width` along the wall and `height` away from it, m.
  static Luminaire at(double y, double z, double width, double height) {
    Luminaire luminaire;
    luminaire.position = {1.5, y, z};
    luminaire.width = width;
    luminaire.height = height;
    return luminaire;
  }
};

TEST_F(CandidateFits, UnlessItPiercesTheWall) {
  EXPECT_TRUE(fit.fits(at(2, 0.7, 0.1, 1.2), 0));
  EXPECT_TRUE(fit.fits(at(2, 0.6, 0.1, 1.2), 0)) << "it touches";
  EXPECT_FALSE(fit.fits(at(2, 0.5, 0.1, 1.2), 0));
  EXPECT_TRUE(fit.fits(at(2, 0.5, 1.2, 0.1), 0)) << "along the wall";
}

TEST_F(CandidateFits, UnlessItsBodyReachesTheFloor) {
  EXPECT_TRUE(fit.fits(at(0.5, 1, 0.3, 0.3), 0.45));
  EXPECT_FALSE(fit.fits(at(0.5, 1, 0.3, 0.3), 0.6));
}

TEST_F(CandidateFits, TiltedOnesByTheirCorners) {
  Luminaire tilted = at(2, 0.45, 0.1, 1.2);
  EXPECT_FALSE(fit.fits(tilted, 0));
  tilted.normal = normalized({0, -1, 1});
  EXPECT_TRUE(fit.fits(tilted, 0)) << "its edge is 0.42 m from its middle";
  tilted.position.z = 0.35;
  EXPECT_FALSE(fit.fits(tilted, 0));
}

TEST_F(CandidateFits, AcrossAMeasuringPlane) { EXPECT_TRUE(fit.fits(at(0.85, 1, 0.3, 0.3), 0.3)); }

TEST(PatchTiles, AreAsLargeAsTheirPatches) {
  const Scene scene = operatorScene(8, 2);
  const std::vector<PatchTile> tiles = patchTiles(scene.patches, scene.lightOperator->charts);
  ASSERT_EQ(tiles.size(), scene.patches.rows());
  for (std::uint32_t p = 0; p < tiles.size(); ++p) {
    EXPECT_NEAR(length(cross(tiles[p].edgeU, tiles[p].edgeV)), scene.patches.area[p], 1e-9);
    EXPECT_NEAR(std::abs(dot(normalized(cross(tiles[p].edgeU, tiles[p].edgeV)), scene.patches.normal[p])), 1,
                1e-9);
  }
}

}  // namespace
}  // namespace fiatlux
