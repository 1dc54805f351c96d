#include "precompute/base/names.h"

#include <gtest/gtest.h>

namespace fiatlux {
namespace {

TEST(Names, HiddenCharactersGoAndSlashesTurn) {
  EXPECT_EQ(cleanName("  a\tb\n c\u202Ed/e\u200B "), "ab cd-e");
  EXPECT_EQ(cleanText("a/b"), "a/b");
  EXPECT_EQ(cleanName("Wände – größer"), "Wände – größer");
  EXPECT_EQ(cleanName("\xff\xc3(\x80"), "(");
  EXPECT_EQ(cleanName(""), "");
}

TEST(Names, LongNamesAreCutAtWholeCharacters) {
  std::string umlauts;
  for (int i = 0; i < 500; ++i) umlauts += "ä";
  const std::string cut = cleanName(umlauts);
  EXPECT_EQ(cut, umlauts.substr(0, 240) + "…");
}

TEST(Names, AreUniqueAndNeverAll) {
  UniqueNames names;
  EXPECT_EQ(names.take("desk"), "desk");
  EXPECT_EQ(names.take("desk"), "desk 2");
  EXPECT_EQ(names.take("desk 2"), "desk 2 2");
  EXPECT_EQ(names.take("desk"), "desk 3");
  EXPECT_EQ(names.take("all"), "all 2");
}

TEST(Names, TheClosestComeFirst) {
  EXPECT_EQ(closestNames("cieling", {"floor", "ceiling", "wall", "Ceiling 2"}),
            "'ceiling', 'Ceiling 2', 'floor'");
}

TEST(Names, OfPathsTheLastPartMayBeMeantAndOfPatternsWhatTheySay) {
  const std::vector<std::string> names{"lamp", "house/mesh.001/ceiling", "house/mesh.001/floor", "box"};
  EXPECT_EQ(closestNames("ceilling", names, '"', 1), "\"house/mesh.001/ceiling\"");
  EXPECT_EQ(closestNames("floor", names, '"', 1), "\"house/mesh.001/floor\"");
  EXPECT_EQ(closestNames("Ceil*", names, '"', 1), "\"house/mesh.001/ceiling\"");
}

TEST(Names, PatternsTakeAnyTextForAStar) {
  for (const char* pattern : {"Ceiling*", "*ling 0?", "ceiling 01", "*", "c*g*1"})
    EXPECT_TRUE(matchesPattern(pattern, "Ceiling 01")) << pattern;
  for (const char* pattern : {"Ceiling", "?eiling", "*02", "", "Ceiling 01?"})
    EXPECT_FALSE(matchesPattern(pattern, "Ceiling 01")) << pattern;
}

}  // namespace
}  // namespace fiatlux
