// Given layouts fitted to rules: what may stay stays, pinned luminaires keep their numbers.
#include "core/search/start_layout.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/core/corridor_scene.h"

namespace fiatlux {
namespace {

using Sites = std::vector<std::uint32_t>;
using ::testing::Contains;
using ::testing::ElementsAre;
using ::testing::Not;

LuminaireRules rulesFor(std::uint32_t count, Sites pinned = {}) {
  LuminaireRules rules;
  rules.count = count;
  rules.pinned = std::move(pinned);
  return rules;
}

const PreparedScene& room() {  // 20 sites
  static const PreparedScene prepared(fiatlux::testing::smallRoom());
  return prepared;
}

TEST(StartLayout, WhatIsAllowedStaysAsItIs) {
  EXPECT_THAT(fittedSites(room(), rulesFor(3), {9, 2, 17}), ElementsAre(9, 2, 17));
  EXPECT_THAT(fittedSites(room(), rulesFor(3, {kNone, 2}), {9, 2, 17}), ElementsAre(9, 2, 17));
}

TEST(StartLayout, WhatIsTooManyIsDroppedFromTheEnd) {
  EXPECT_THAT(fittedSites(room(), rulesFor(2), {9, 2, 17}), ElementsAre(9, 2));
  EXPECT_THAT(fittedSites(room(), rulesFor(2, {kNone, 17}), {9, 2, 17}), ElementsAre(9, 17));
}

TEST(StartLayout, WhatIsForbiddenOrMissingIsFilledUp) {
  LuminaireRules rules = rulesFor(4, {kNone, kNone, 5});
  rules.excluded = {9};
  const Sites sites = fittedSites(room(), rules, {9, 2, 17});
  ASSERT_EQ(sites.size(), 4u);
  EXPECT_EQ(sites[2], 5u);
  EXPECT_THAT(sites, Contains(2u));
  EXPECT_THAT(sites, Contains(17u));
  EXPECT_THAT(sites, Not(Contains(9u)));
}

TEST(StartLayout, EverySortOfLayoutHasItsPins) {
  const LuminaireRules rules = rulesFor(4, {kNone, 11, kNone, 0});
  Random random(1);
  for (const Sites& sites : {packSites(room(), rules), spreadSites(room(), rules),
                             randomSites(room(), rules, random), fittedSites(room(), rules, {1, 0, 11})}) {
    ASSERT_EQ(sites.size(), 4u);
    EXPECT_EQ(sites[1], 11u);
    EXPECT_EQ(sites[3], 0u);
    EXPECT_NE(sites[0], sites[2]);
  }
}

TEST(StartLayout, PinsAreHeldByWhoHangsThere) {
  EXPECT_THAT(pinsAsIn(rulesFor(4, {7, 3}), {3, 12, 7, 5}), ElementsAre(3, kNone, 7, kNone));
  EXPECT_THAT(pinsAsIn(rulesFor(4, {7, 3}), {12, 3}), ElementsAre(7, 3, kNone, kNone)) << "nobody on 7";
  EXPECT_THAT(pinsAsIn(rulesFor(2, {7, 3}), {1, 12, 7, 3}), ElementsAre(7, 3)) << "both will be dropped";
  EXPECT_THAT(pinsAsIn(rulesFor(2), {1, 12}), ElementsAre(kNone, kNone));
}

}  // namespace
}  // namespace fiatlux
