#include "precompute/validation/validation.h"

#include <cmath>
#include <limits>

namespace fiatlux {

void Validation::relative(const std::string& topic, const std::string& name, double expected, double got,
                          double tolerance) {
  rows.push_back({topic, name, expected, got, std::abs(got / expected - 1), tolerance, false});
}

void Validation::absolute(const std::string& topic, const std::string& name, double expected, double got,
                          double tolerance) {
  rows.push_back({topic, name, expected, got, std::abs(got - expected), tolerance, true});
}

void Validation::failure(const std::string& topic, const std::string& reason) {
  constexpr double kNever = std::numeric_limits<double>::infinity();
  rows.push_back({topic, reason, 0, 0, kNever, 0, true});
}

std::vector<ValidationRow> validateAll(const ValidationOptions& options) {
  Validation validation(options);
  validateFormFactors(validation);
  validateIdentities(validation);
  validateFurnaces(validation);
  validateDirectCie171(validation);
  validateReflectedCie171(validation);
  validatePhotometricFiles(validation);
  return validation.rows;
}

}  // namespace fiatlux
