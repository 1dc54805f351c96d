// Points of a .csv, as people and spreadsheets write them.
#include "precompute/light/point_light.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace fiatlux {
namespace {

using ::testing::HasSubstr;

TEST(ParsePoints, HeadingsBlankLinesAndTheMarkOfUtf8ArePassedOver) {
  for (const char* csv : {"1,2,3,0,2,0\n", "x,y,z,nx,ny,nz\n\n1, 2, 3, 0, 2, 0\r\n",
                          "\xef\xbb\xbfx,y,z,nx,ny,nz\r\n1,2,3,0,2,0\r\n",
                          "\xef\xbb\xbf"
                          "1,2,3,0,2,0"}) {
    const auto points = parsePoints(csv);
    ASSERT_TRUE(points) << points.error().message;
    ASSERT_EQ(points->size(), 1u);
    EXPECT_EQ((*points)[0].position.z, 3);
    EXPECT_EQ((*points)[0].normal.y, 1);
  }
}

TEST(ParsePoints, WhatIsNoPointIsRefusedByItsLine) {
  for (const char* line : {"1,2,3", "1,2,3,0,0,0", "1,2,3,0,1,0,7", "1;2;3;0;1;0", "1,2,nan,0,1,0", "a,b"}) {
    const auto points = parsePoints("0,0,0,0,1,0\n" + std::string(line));
    ASSERT_FALSE(points) << line;
    EXPECT_THAT(points.error().message, HasSubstr("line 2"));
  }
  EXPECT_FALSE(parsePoints(""));
}

}  // namespace
}  // namespace fiatlux
