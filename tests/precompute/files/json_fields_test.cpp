// The strict reader: each way in which a value may not be what is asked for, with its place and its line.
#include "precompute/files/json_fields.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace fiatlux {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;

std::string errorOf(const std::string& text, const std::function<void(const JsonField&)>& read) {
  const Result<Done> result = readJson(text, read);
  return result ? "no error" : result.error().message;
}

TEST(JsonFields, ReadsWhatIsThere) {
  const auto read = [](const JsonField& json) {
    json.requireKeys({"n", "w", "t", "v", "l", "c"});
    EXPECT_EQ(json.at("n", "").number(-1, 0), -0.5);
    EXPECT_EQ(json.at("w", "").whole(), 4294967295u);
    EXPECT_EQ(json.at("t", "").text(), "x");
    EXPECT_THAT(json.at("v", "").numbers(2, "[a, b]"), ElementsAre(1, 2));
    EXPECT_EQ(json.at("l", "").list(3).size(), 3u);
    EXPECT_EQ(json.at("c", "").oneOf<int>({{"one", 1}, {"two", 2}}), 2);
    EXPECT_FALSE(json.find("none"));
  };
  EXPECT_TRUE(
      readJson(R"({"n": -0.5, "w": 4294967295, "t": "x", "v": [1, 2], "l": [1, 2, 3], "c": "two"})", read));
}

TEST(JsonFields, AnUnknownKeyIsNamedWithTheClosestOne) {
  EXPECT_EQ(errorOf("{\"a\": {\n \"cuont\": 1}}",
                    [](const JsonField& json) {
                      json.at("a", "").requireKeys({"flux", "count"});
                    }),
            "a: unknown key \"cuont\"; the closest is \"count\" (known are flux, count) (line 1)");
  const std::string longKey(1 << 20, 'k');
  EXPECT_LT(
      errorOf("{\"" + longKey + "\": 1}", [](const JsonField& json) { json.requireKeys({"a"}); }).size(),
      200u);
}

TEST(JsonFields, AKeyThatStandsTwiceIsNoneOfTwoValues) {
  EXPECT_EQ(errorOf("{\"flux\": 100,\n \"flux\": 200}", [](const JsonField&) { FAIL() << "read"; }),
            "key \"flux\" stands twice in one object; leave one out (line 2)");
  EXPECT_LT(errorOf("{\"" + std::string(1 << 10, 'k') + "\": 1, \"" + std::string(1 << 10, 'k') + "\": 1}",
                    [](const JsonField&) {})
                .size(),
            200u);
}

TEST(JsonFields, FaultsNameThePlaceAndTheLine) {
  const std::string text = "{\"list\": [\n1,\n\"x\"], \"n\": 1.5, \"v\": [1,\n\n \"y\"]}";
  const auto error = [&](const auto& read) { return errorOf(text, read); };
  EXPECT_EQ(error([](const JsonField& json) { json.at("list", "").list(9)[1].number(); }),
            "list[1]: expected a number, found a text (line 3)");
  EXPECT_EQ(error([](const JsonField& json) { json.at("list", "").list(9, "goal")[1].number(); }),
            "goal 2: expected a number, found a text (line 3)");
  EXPECT_EQ(error([](const JsonField& json) { json.at("n", "").whole(); }),
            "n: expected a whole number from 0 on, found 1.5 (line 3)");
  EXPECT_EQ(error([](const JsonField& json) { json.at("n", "").number(2, 1e9); }),
            "n: 1.5 is out of range; give 2 to 1000000000 (line 3)");
  EXPECT_EQ(error([](const JsonField& json) { json.at("v", "").numbers(2, "[a, b]"); }),
            "v[1]: expected a number, found a text (line 5)");
  EXPECT_EQ(error([](const JsonField& json) { json.at("v", "").numbers(3, "[a, b, c]"); }),
            "v: expected [a, b, c], found 2 entries (line 3)");
  EXPECT_EQ(error([](const JsonField& json) { json.at("list", "").list(1); }),
            "list: more than 1 entries (line 1)");
  EXPECT_EQ(error([](const JsonField& json) { json.at("flux", "give it in lumens"); }),
            "no \"flux\"; give it in lumens (line 1)");
  EXPECT_EQ(error([](const JsonField& json) { json.at("n", "").text(); }),
            "n: expected a text, found a number (line 3)");
  EXPECT_EQ(error([](const JsonField& json) {
              json.at("list", "").list(2)[1].oneOf<int>({{"y", 1}, {"abc", 2}});
            }),
            "list[1]: unknown \"x\"; the closest is \"y\" (known are y, abc) (line 3)");
}

TEST(JsonFields, TooLongTextIsNotParsed) {
  const auto never = [](const JsonField&) { FAIL(); };
  EXPECT_EQ(errorOf(std::string(kLongestJson + 1, ' '), never), "longer than 2 MB");
  EXPECT_THAT(errorOf("{", never), HasSubstr("not valid JSON"));
}

}  // namespace
}  // namespace fiatlux
