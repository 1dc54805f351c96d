// A draft is soon there, at the same places, and about as bright as what takes its place.
#include "precompute/pipeline/draft.h"

#include <gtest/gtest.h>

#include "tests/precompute/pipeline/box_model.h"

namespace fiatlux {
namespace {

TEST(Draft, TheMoreWorkARoomIsTheLongerAreItsPatchesWithinReason) {
  EXPECT_EQ(draftCoarseness(500, 25, 12), 2.5);
  EXPECT_EQ(draftCoarseness(1e6, 400, 60000), 6);
  const double little = draftCoarseness(25000, 100, 20000), much = draftCoarseness(25000, 400, 20000);
  EXPECT_GT(little, 2.5);
  EXPECT_GT(much, little);
  EXPECT_LT(much, 6);
}

TEST(Draft, IsAboutAsBrightAtTheSamePlaces) {
  SceneOptions options = testing::quickOptions();
  options.room.patch = 0.2, options.transport.rays = 256, options.transport.exchange = true;
  const auto full = makeScene(testing::boxModel(), options, testing::plainHost());
  options.draft = true;
  const auto draft = makeScene(testing::boxModel(), options, testing::plainHost());
  ASSERT_TRUE(full && draft);
  EXPECT_NE(draft->report.identity, full->report.identity);
  EXPECT_LT(3 * draft->report.patches, full->report.patches);

  const auto scene = readScene(full->file), soon = readScene(draft->file);
  ASSERT_TRUE(scene && soon);
  EXPECT_FALSE(soon->lightOperator);
  ASSERT_EQ(soon->sites.size(), scene->sites.size());
  ASSERT_EQ(soon->surfaces.size(), scene->surfaces.size());
  for (std::size_t s = 0; s < scene->surfaces.size(); ++s) {
    EXPECT_EQ(soon->surfaces[s].name, scene->surfaces[s].name);
    double sum = 0, truth = 0;
    for (std::size_t j = 0; j < scene->sites.size(); ++j)
      sum += soon->illuminance[s].mean[j], truth += scene->illuminance[s].mean[j];
    EXPECT_NEAR(sum / truth, 1, 0.03) << scene->surfaces[s].name;
  }
}

}  // namespace
}  // namespace fiatlux
