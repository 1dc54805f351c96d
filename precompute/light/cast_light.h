// Light in two steps, for who casts elsewhere: what rays tell of a room, and the transport that follows from
// it.
#pragma once

#include <vector>

#include "core/scene/light_operator.h"
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

/// What computeTransport makes of it, for the same room and options; not in paper mode.
Result<Transport> completeTransport(const Room& room, const RayTracer& tracer, CastLight&& cast,
                                    const TransportOptions& options);

}  // namespace fiatlux
