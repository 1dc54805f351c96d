// Keys that stand twice, and those that only look so (json_walk too).
#include "precompute/base/repeated_key.h"

#include <gtest/gtest.h>

namespace fiatlux {
namespace {

std::string foundIn(const std::string& text) {
  const auto repeat = repeatedKey(text);
  return repeat ? repeat->key + " " + std::to_string(repeat->line) : "none";
}

TEST(RepeatedKey, IsNamedWithTheLineOfTheSecond) {
  EXPECT_EQ(foundIn("{\"a\": 1,\n \"b\": {\"a\": 2},\n \"a\": 3}"), "a 3");
  EXPECT_EQ(foundIn("{\"list\": [1, {\"x\": 1, \"y\": [],\n\"x\": 2}]}"), "x 2");
  EXPECT_EQ(foundIn("{\"b\": [{}, 1], \"a\": \"{\", \"\\u0061\": 1}"), "a 1") << "however it is written";
}

TEST(RepeatedKey, ObjectsHaveKeysOfTheirOwn) {
  EXPECT_EQ(foundIn("[{\"a\": \"a\"}, {\"a\": [\"a\", \"a\"]}]"), "none");
  EXPECT_EQ(foundIn("{\"__proto__\": {\"__proto__\": 0}}"), "none");
  EXPECT_EQ(foundIn("3"), "none");
}

}  // namespace
}  // namespace fiatlux
