// How far light by a scene's operator is from the whole solution, measured where both are at hand.
#pragma once

#include <string>
#include <vector>

#include "core/base/result.h"
#include "core/scene/scene.h"
#include "core/transport/form_factors.h"

namespace fiatlux {

/// Relative errors of one photometry over some sites and all surfaces that are lit well enough to matter.
struct OperatorError {
  std::string photometry;
  double meanMedian = 0, meanWorst = 0, sigmaMedian = 0, sigmaWorst = 0;
};

/// Interreflection by the exchange against a refined solution on the form factors, for the same direct light:
/// a wide batwing and a narrow beam on a few sites. The scene has its operator as a file holds it.
Result<std::vector<OperatorError>> measureOperator(const Scene& scene, const FormFactors& factors);

}  // namespace fiatlux
