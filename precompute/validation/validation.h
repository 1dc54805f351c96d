// The analytic cases that `fiatlux validate` and the tests run through the real pipeline: geometry, patches,
// rays, direct light and solver, on generated scenes whose light is known in closed form, from CIE 171:2006
// or by an independent sum.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "precompute/rays/effort.h"

namespace fiatlux {

struct ValidationOptions {
  std::uint32_t rays = kUsualRays;
  std::uint64_t seed = 1;
  unsigned threads = 0;
};

/// One number against what it must be.
struct ValidationRow {
  std::string topic, name;
  double expected = 0, got = 0;
  double error = 0;      // |got / expected - 1|, or |got - expected| where `absolute`
  double tolerance = 0;  // the row passes where error <= tolerance
  bool absolute = false;
  bool passes() const { return error <= tolerance; }
};

/// Collects rows; a case that cannot run at all is a failing row with its reason as name.
class Validation {
 public:
  explicit Validation(const ValidationOptions& options) : options(options) {}
  void relative(const std::string& topic, const std::string& name, double expected, double got,
                double tolerance);
  void absolute(const std::string& topic, const std::string& name, double expected, double got,
                double tolerance);
  void failure(const std::string& topic, const std::string& reason);

  const ValidationOptions options;
  std::vector<ValidationRow> rows;
};

void validateFormFactors(Validation& validation);
void validateIdentities(Validation& validation);
void validateFurnaces(Validation& validation);
void validateDirectCie171(Validation& validation);     // 5.2, 5.3, 5.4
void validateReflectedCie171(Validation& validation);  // 5.6, 5.7, 5.8
void validatePhotometricFiles(Validation& validation);

/// All of them.
std::vector<ValidationRow> validateAll(const ValidationOptions& options);

}  // namespace fiatlux
