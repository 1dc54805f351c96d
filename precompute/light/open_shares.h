// What rows far away see of a cluster: mostly those of its patches that lie open.
#pragma once

#include "core/transport/form_factors.h"
#include "precompute/light/cluster_parts.h"
#include "precompute/room/room.h"

namespace fiatlux {

/// Sets FormFactors::share, by area until then, once all rows are there: a patch counts by the share of
/// distant light that nothing keeps away from it, which by reciprocity is what is seen of it from afar. By
/// area alone, floor under a table would count as much as floor beside it, which everybody sees, and which is
/// bright for the same reason: what a furnished room reflects came out 1 % too small. Slopes keep their first
/// moments.
void weighByOpenness(const Room& room, const ClusterParts& clusters, FormFactors& factors);

}  // namespace fiatlux
