// The light of a room that a test has made, with a tracer of its own.
#pragma once

#include "precompute/light/transport.h"
#include "precompute/rays/ray_tracer.h"

namespace fiatlux::testing {

inline Result<Transport> transportOf(const Room& room, const TransportOptions& options = {}) {
  const Result<RayTracer> tracer = RayTracer::build(room);
  if (!tracer) return tracer.error();
  return computeTransport(room, *tracer, options);
}

}  // namespace fiatlux::testing
