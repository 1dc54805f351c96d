// Strangers' text on a terminal: nothing in it acts, and it is cut between characters.
#include "precompute/files/terminal.h"

#include <gtest/gtest.h>

namespace fiatlux {
namespace {

TEST(Terminal, ControlCharactersDoNotAct) {
  EXPECT_EQ(printable("a\x1b[31mb\r\n\x7f"), "a?[31mb???");
  EXPECT_EQ(printable("Wände \u202eund"), "Wände ???und");
}

TEST(Terminal, LongTextIsCutBetweenCharacters) {
  EXPECT_EQ(printable("abcd", 4), "abcd");
  EXPECT_EQ(printable("abcde", 4), "abcd...");
  EXPECT_EQ(printable("abcä", 4), "abc...");
  EXPECT_EQ(printable("ää", 1), "...");
}

}  // namespace
}  // namespace fiatlux
