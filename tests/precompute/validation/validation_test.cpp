// Every analytic case of `fiatlux validate` (validate_form_factors, validate_identities, validate_cie171,
// validate_photometry), with the rays of the default; all stand on generated_scene, rectangle_room and
// validation_scene.
#include "precompute/validation/validation.h"

#include <gtest/gtest.h>

namespace fiatlux {
namespace {

class ValidationTest : public ::testing::TestWithParam<void (*)(Validation&)> {};

TEST_P(ValidationTest, EveryRowIsWithinItsTolerance) {
  Validation validation({});
  GetParam()(validation);
  EXPECT_GE(validation.rows.size(), 8u);
  for (const ValidationRow& row : validation.rows) {
    EXPECT_TRUE(row.passes()) << row.topic << ": " << row.name << ": expected " << row.expected << ", got "
                              << row.got;
  }
}

INSTANTIATE_TEST_SUITE_P(Cases, ValidationTest,
                         ::testing::Values(validateFormFactors, validateIdentities, validateFurnaces,
                                           validateDirectCie171, validateReflectedCie171,
                                           validatePhotometricFiles));

TEST(Validation, ARowFailsBeyondItsToleranceAndWhenItIsNoNumber) {
  Validation validation({});
  validation.relative("t", "off by 2 %", 100, 102, 0.01);
  validation.absolute("t", "not a number", 0, 0.0 / 0.0, 1);
  validation.failure("t", "cannot run");
  for (const ValidationRow& row : validation.rows) EXPECT_FALSE(row.passes()) << row.name;
}

}  // namespace
}  // namespace fiatlux
