#include "core/photometry/photometric_description.h"

#include "core/photometry/intensity.h"
#include "core/photometry/photometric_values.h"
#include "core/photometry/unified_glare.h"

namespace fiatlux {
namespace {

constexpr double kBeamShare = 0.5, kFieldShare = 0.1;

}  // namespace

PhotometricDescription describe(const Photometry& photometry) {
  const double flux = integratedFlux(photometry);
  return {flux,
          isFluxDisputed(photometry, flux),
          efficacy(photometry),
          maxCandela(photometry),
          openingAngle(photometry, kBeamShare),
          openingAngle(photometry, kFieldShare),
          upwardShare(photometry),
          ugr4h8h(photometry)};
}

std::vector<float> sampledIntensities(const Photometry& photometry) {
  std::vector<float> samples;
  samples.reserve(static_cast<std::size_t>(kSampledPlanes * kSampledGammas));
  for (int plane = 0; plane < kSampledPlanes; ++plane)
    for (int gamma = 0; gamma < kSampledGammas; ++gamma)
      samples.push_back(static_cast<float>(intensityAt(photometry, plane * 360.0 / kSampledPlanes, gamma)));
  return samples;
}

}  // namespace fiatlux
