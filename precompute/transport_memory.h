// What the transport of a finished room will hold, asked before anything of it is allocated.
#pragma once

#include "core/result.h"
#include "precompute/room.h"
#include "precompute/transport.h"

namespace fiatlux {

/// Bytes that computeTransport would hold at its peak.
double transportBytes(const Patches& patches, std::size_t sites, const TransportOptions& options);

/// An error that names what is too many, and the cure, where that is more than `gigabytes`.
Result<Done> checkTransportMemory(const Room& room, const TransportOptions& options, double gigabytes);

}  // namespace fiatlux
