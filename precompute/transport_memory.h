// What the transport of a finished room will hold, asked before anything of it is allocated.
#pragma once

#include "core/form_factors.h"
#include "core/result.h"
#include "precompute/room.h"
#include "precompute/transport.h"

namespace fiatlux {

/// What a row usually keeps of single patches and of slopes, outside --paper: furnished rooms have about as
/// many (the open office: 490 and 210).
inline constexpr double kUsualEntries = 512;

/// Bytes that computeTransport would hold at its peak.
double transportBytes(const Patches& patches, std::size_t sites, const TransportOptions& options);

/// An error that names what is too many, and the cure, where that is more than `gigabytes`.
Result<Done> checkTransportMemory(const Room& room, const TransportOptions& options, double gigabytes);

}  // namespace fiatlux
