// What rays tell of a room: the first half of computeTransport, whose other half is interreflection.h. Both
// for machines that share the work.
#pragma once

#include <vector>

#include "core/scene/light_operator.h"
#include "core/transport/form_factors.h"
#include "precompute/light/cast_form_factors.h"
#include "precompute/light/direct_light.h"
#include "precompute/light/transport.h"

namespace fiatlux {

/// All that computeTransport casts.
struct CastLight {
  FormFactors factors;
  std::vector<float> direct;  // as Transport::direct
  SiteVisibility visibility;  // only where the light operator is wanted
};

/// What to cast with.
CastOptions castOptionsOf(const TransportOptions& options);
DirectLightOptions directOptionsOf(const TransportOptions& options);
/// A luminaire of 1 lm on every site.
std::vector<Luminaire> siteLuminaires(const Room& room);

}  // namespace fiatlux
