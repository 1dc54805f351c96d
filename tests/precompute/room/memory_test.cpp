// What a run needs, foreseen from its counts.
#include "precompute/room/memory.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace fiatlux {
namespace {

using ::testing::HasSubstr;

RunCounts office() {
  RunCounts counts;
  counts.patches = 25000, counts.rows = 26000, counts.clusters = 2000;
  counts.sites = 400, counts.surfaces = 60, counts.rays = 1024;
  return counts;
}

TEST(Memory, GrowsWithEveryCount) {
  const double usual = bytesNeeded(office());
  EXPECT_GT(usual, 26000.0 * 2000 * sizeof(float));  // U alone
  for (double RunCounts::*count : {&RunCounts::patches, &RunCounts::rows, &RunCounts::clusters,
                                   &RunCounts::sites, &RunCounts::surfaces}) {
    RunCounts more = office();
    more.*count *= 2;
    EXPECT_GT(bytesNeeded(more), usual);
  }
  RunCounts paper = office();
  paper.paper = true;
  EXPECT_GT(bytesNeeded(paper), usual);
  RunCounts exchange = office();
  exchange.exchange = true;
  EXPECT_GT(bytesNeeded(exchange), usual + exchange.rows * exchange.sites);
}

TEST(Memory, WhatIsTooMuchIsNamedWithItsCure) {
  EXPECT_TRUE(checkMemory(office(), 4));
  RunCounts patches = office();
  patches.patches = patches.rows = 1e7;
  EXPECT_THAT(checkMemory(patches, 4).error().message, HasSubstr("pass a larger --patch"));
  RunCounts sites = office();
  sites.sites = 1e5;
  const auto refused = checkMemory(sites, 4);
  ASSERT_FALSE(refused);
  EXPECT_THAT(refused.error().message, HasSubstr("--memory allows 4"));
  EXPECT_THAT(refused.error().message, HasSubstr("sites"));
  EXPECT_THAT(refused.error().message, HasSubstr("--site-spacing"));
}

}  // namespace
}  // namespace fiatlux
