#include "core/photometry/photometry.h"

#include <algorithm>

#include "core/photometry/eulumdat_file.h"
#include "core/photometry/ies_file.h"
#include "core/photometry/photometric_format.h"
#include "core/photometry/photometric_values.h"

namespace fiatlux {
namespace {

void compareFlux(Photometry& photometry, double flux) {
  if (photometry.flux == 0) {
    photometry.flux = flux;
  } else if (isFluxDisputed(photometry, flux)) {
    photometry.warnings.push_back("the file says that its lamps give " + shortNumber(photometry.flux) +
                                  " lm, its table holds " + shortNumber(flux) + " lm; which is right?");
  }
}

void compareRange(Photometry& photometry) {
  const double first = photometry.gamma.front(), last = photometry.gamma.back();
  if ((first != 0 && first != 90) || (last != 90 && last != 180))
    photometry.warnings.push_back("the table reaches from gamma " + shortNumber(first) + " to " +
                                  shortNumber(last) + " only; there is no light outside it");
}

}  // namespace

const char* nameOf(PhotometricFormat format) {
  constexpr std::array kNames = {"LM-63-1986", "LM-63-1991", "LM-63-1995",
                                 "LM-63-2002", "LM-63-2019", "EULUMDAT"};
  return kNames[static_cast<std::size_t>(format)];
}

const char* nameOf(PhotometricSymmetry symmetry) {
  constexpr std::array kNames = {"axial", "quadrant", "C0-C180", "C90-C270", "none"};
  return kNames[static_cast<std::size_t>(symmetry)];
}

Result<Photometry> readPhotometry(std::span<const std::uint8_t> bytes) {
  if (bytes.empty()) return Error{"the file is empty; fetch it again"};
  if (const auto refusal = refusalOfForeignFile(bytes)) return Error{*refusal};
  if (bytes.size() > kMaxPhotometricBytes)
    return Error{"the file has " + shortNumber(static_cast<double>(bytes.size()) / 1048576) +
                 " MB, more than the 4 MB of the largest table; is it a photometric file?"};
  const PhotometricText text = textOf(bytes);
  const bool eulumdat = !looksLikeIes(text) && looksLikeEulumdat(text);
  if (!eulumdat && !looksLikeIes(text) && countsLineOf(text) == 0)
    return Error{
        "neither LM-63 (no line begins with TILT) nor EULUMDAT (lines 2 to 7 are no numbers); take the "
        "luminaire's .ies or .ldt file"};
  Result<Photometry> photometry = eulumdat ? readEulumdat(text) : readIes(text);
  if (!photometry) return photometry;
  const double flux = integratedFlux(*photometry);
  if (!(flux > 0)) return Error{"the table holds no light: every intensity is 0; export the file again"};
  compareFlux(*photometry, flux);
  compareRange(*photometry);
  return photometry;
}

}  // namespace fiatlux
