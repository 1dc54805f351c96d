// JSON text in and out: what is refused and where, the line of a value, and time that grows with the length
// alone.
#include "precompute/base/json_text.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <ctime>
#include <nlohmann/json.hpp>

namespace fiatlux {
namespace {

using ::testing::HasSubstr;

std::string errorOf(const std::string& text) {
  const Result<nlohmann::json> json = parseJson(text);
  return json ? "no error" : json.error().message;
}

std::string nested(int depth) {
  return std::string(static_cast<std::size_t>(depth), '[') +
         std::string(static_cast<std::size_t>(depth), ']');
}

TEST(JsonText, SyntaxErrorsNameTheLine) {
  EXPECT_EQ(errorOf("{\n \"a\": 1,\n \"b\" 2}"), "not valid JSON: syntax error in line 3 (byte 16)");
  EXPECT_THAT(errorOf(""), HasSubstr("line 1"));
  EXPECT_THAT(errorOf("[1e999]"), HasSubstr("out of range"));
  EXPECT_THAT(errorOf("[\"\xff\"]"), HasSubstr("line 1"));
}

TEST(JsonText, DepthIsLimitedBracketsInTextsAreNot) {
  EXPECT_TRUE(parseJson(nested(64)));
  EXPECT_THAT(errorOf(nested(65)), HasSubstr("nested deeper than 64"));
  EXPECT_THAT(errorOf(std::string(1 << 20, '{')), HasSubstr("nested deeper than 64"));
  EXPECT_TRUE(parseJson("[\"" + std::string(100, '[') + "\\\"" + std::string(100, '{') + "\"]"));
  EXPECT_THAT(errorOf("\"" + std::string(100, '[')), HasSubstr("not valid JSON"));
}

TEST(JsonText, LongListsTakeLinearTime) {
  std::string text = "[";
  for (int i = 0; i < 300000; ++i) text += "{\"k\":[1,2]},";
  text.back() = ']';
  const std::clock_t begin = std::clock();
  ASSERT_TRUE(parseJson(text));
  const double seconds = static_cast<double>(std::clock() - begin) / CLOCKS_PER_SEC;
  EXPECT_LT(seconds, 8) << "quadratic time is twice that";
}

TEST(JsonText, TheLineOfAValue) {
  const std::string text =
      "\n{\"a\": {\"x\\\"\": [1, {\"a\": 0}]},\n \"list\": [\n  1,\n  {\"a\": \"}\",\n   \"b\": \n -2}]}";
  ASSERT_TRUE(parseJson(text));
  EXPECT_EQ(jsonLineOf(text, {}), 2u);
  EXPECT_EQ(jsonLineOf(text, {"a"}), 2u);
  EXPECT_EQ(jsonLineOf(text, {"list"}), 3u);
  EXPECT_EQ(jsonLineOf(text, {"list", "0"}), 4u);
  EXPECT_EQ(jsonLineOf(text, {"list", "1"}), 5u);
  EXPECT_EQ(jsonLineOf(text, {"list", "1", "b"}), 7u);
  EXPECT_EQ(jsonLineOf(text, {"list", "1", "none"}), 5u) << "the last that is there";
}

TEST(JsonText, WhatIsNotUtf8IsReplacedOnTheWayOut) {
  const nlohmann::ordered_json json = {{"b", "\xff"}, {"a", 1}};
  EXPECT_EQ(jsonText(json), "{\"b\":\"\xef\xbf\xbd\",\"a\":1}");
  EXPECT_EQ(jsonDocument(json), "{\n  \"b\": \"\xef\xbf\xbd\",\n  \"a\": 1\n}\n");
}

}  // namespace
}  // namespace fiatlux
