// Numbers of sentences are read by people: no exponents where zeros do.
#include "core/base/short_number.h"

#include <gtest/gtest.h>

namespace fiatlux {
namespace {

TEST(ShortNumber, HasNoExponentThatAPersonMustWorkOut) {
  EXPECT_EQ(shortNumber(1843.2), "1840");
  EXPECT_EQ(shortNumber(-25049), "-25000");
  EXPECT_EQ(shortNumber(999.9), "1000");
  EXPECT_EQ(shortNumber(1e6), "1000000");
  EXPECT_EQ(shortNumber(117), "117");
  EXPECT_EQ(shortNumber(2.345, 2), "2.3");
  EXPECT_EQ(shortNumber(0.0042), "0.0042");
  EXPECT_EQ(shortNumber(0), "0");
  EXPECT_EQ(shortNumber(2e30), "2e+30");
}

}  // namespace
}  // namespace fiatlux
