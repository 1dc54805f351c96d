// Numbers and text of photometric files (photometric_text): decimals, line ends, encodings.
#include "core/photometry/photometric_numbers.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/core/photometry/photometric_files.h"

namespace fiatlux {
namespace {

using samples::bytesOf;
using ::testing::ElementsAre;

TEST(PhotometricText, ReadsDecimalNumbersExactly) {
  EXPECT_EQ(numberOf("0"), 0.0);
  EXPECT_EQ(numberOf("-1"), -1.0);
  EXPECT_EQ(numberOf("+3.0"), 3.0);
  EXPECT_EQ(numberOf(".5"), 0.5);
  EXPECT_EQ(numberOf("5."), 5.0);
  EXPECT_EQ(numberOf("0.1"), 0.1);
  EXPECT_EQ(numberOf("123456.789"), 123456.789);
  EXPECT_EQ(numberOf("1.5e3"), 1500.0);
  EXPECT_EQ(numberOf("1.5D-3"), 0.0015);
  EXPECT_DOUBLE_EQ(numberOf("0.00000000000000000000001").value(), 1e-23);
  EXPECT_EQ(numberOf("12345678901234567890"), 12345678901234567890.0);
  EXPECT_EQ(numberOf("1e-999"), 0.0);
}

TEST(PhotometricText, RefusesWhatIsNoNumber) {
  for (const char* token : {"", "-", ".", "e5", "1e", "1e+", "1x", "nan", "NaN", "inf", "0x10", "1.2.3",
                            "1e999", "1,5", " 1", "--1", "1e5.0"})
    EXPECT_FALSE(numberOf(token)) << token;
}

TEST(PhotometricText, TakesEveryLineEnd) {
  for (const char* end : {"\n", "\r", "\r\n"}) {
    const std::string text = std::string("a") + end + end + "b" + end;
    EXPECT_THAT(textOf(bytesOf(text)).lines, ElementsAre("a", "", "b")) << int(end[0]);
  }
  EXPECT_THAT(textOf(bytesOf("a\nb")).lines, ElementsAre("a", "b"));
}

TEST(PhotometricText, LeavesOutTheMarkAndWhatFollowsTheEnd) {
  EXPECT_THAT(textOf(bytesOf("\xef\xbb\xbf"
                             "a\nb\x1a"
                             "c\n"))
                  .lines,
              ElementsAre("a", "b"));
}

TEST(PhotometricText, ReadsUtf8OrWindows1252) {
  EXPECT_THAT(textOf(bytesOf("Stra\xc3\x9f"
                             "e"))
                  .lines,
              ElementsAre("Stra\xc3\x9f"
                          "e"));
  EXPECT_THAT(textOf(bytesOf("Stra\xdf"
                             "e"))
                  .lines,
              ElementsAre("Stra\xc3\x9f"
                          "e"));
  EXPECT_THAT(textOf(bytesOf("\x80 5")).lines, ElementsAre("\xe2\x82\xac 5"));
}

TEST(PhotometricText, CutsLongTextAtALetter) {
  std::string name;
  for (int i = 0; i < 150; ++i) name += "\xc3\x9f";
  EXPECT_EQ(shortText("  " + name + " "), name.substr(0, 200));
  EXPECT_EQ(shortText("x" + name), "x" + name.substr(0, 198));
  EXPECT_EQ(shortText("a\tb\x7f"), "a b ");
}

TEST(NumberReader, NumbersSpanLinesAndCommas) {
  const PhotometricText text{{"head", "1, 2 ,3", "", "\t4,5"}};
  StreamReader reader(text, 2);
  for (int i = 1; i <= 5; ++i) EXPECT_EQ(reader.next("n"), i);
  EXPECT_EQ(reader.line(), 4u);
  EXPECT_FALSE(reader.failure());
  (void)reader.next("a sixth");
  ASSERT_TRUE(reader.failure());
  EXPECT_EQ(reader.failure()->message.rfind("line 4: the file ends where a sixth should stand", 0), 0u);
}

TEST(NumberReader, TheFirstFailureStays) {
  const PhotometricText text{{"1", "x", "3"}};
  LineReader reader(text);
  EXPECT_EQ(reader.within("one", 0, 2), 1);
  EXPECT_EQ(reader.within("two", -4, 2), -4);
  EXPECT_EQ(reader.next("three"), 0);
  EXPECT_EQ(reader.failure()->message.rfind("line 2: \"x\" stands where two should", 0), 0u);
}

TEST(NumberReader, CountsAreWholeAndWithinTheirRange) {
  const auto failure = [](const char* number) {
    const PhotometricText text{{number}};
    LineReader reader(text);
    (void)reader.count("the count", 2, 9);
    return reader.failure() ? reader.failure()->message : "";
  };
  EXPECT_EQ(failure("9,0"), "");
  for (const char* number : {"1", "10", "2.5", "-3", "1e300"})
    EXPECT_EQ(failure(number).rfind("line 1: the count is ", 0), 0u) << number;
}

}  // namespace
}  // namespace fiatlux
