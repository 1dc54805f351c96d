#include "precompute/transport_memory.h"

#include <algorithm>
#include <cstdio>
#include <string>

#include "precompute/parallel.h"

namespace fiatlux {

namespace {

/// What rows keep of single patches and of slopes: in paper mode one entry a ray at most.
double nearBytes(const Patches& patches, const TransportOptions& options) {
  const double rows = patches.rows(), n = patches.count, k = patches.clusterCount;
  if (options.paper) return rows * sizeof(NearPatch) * std::min<double>(options.rays, n);
  return rows *
         (sizeof(NearPatch) * std::min(kUsualEntries, n) + sizeof(ClusterSlope) * std::min(kUsualEntries, k));
}

}  // namespace

double transportBytes(const Patches& patches, std::size_t sites, const TransportOptions& options) {
  const double n = patches.count, rows = patches.rows(), k = patches.clusterCount,
               m = static_cast<double>(sites);
  const double near = nearBytes(patches, options), u = 4 * rows * k, core = 3 * 8 * k * k,
               responses = 4 * rows * m;
  const double blocks = threadCount(options.threads) * 4.0 * kBlockWidth * (4 * n + 2 * rows);
  double surfaces = 0;
  if (!patches.surface.empty())
    surfaces = 1.0 + *std::max_element(patches.surface.begin(), patches.surface.end());
  const double statistics = 2 * surfaces * 8 * m * m;
  if (!options.paper) return near + u + core + 2 * responses + blocks + statistics;
  return near + 2 * u + core + responses + statistics + surfaces * 8 * k * k;
}

Result<Done> checkTransportMemory(const Room& room, const TransportOptions& options, double gigabytes) {
  const double bytes = transportBytes(room.patches, room.sites.size(), options);
  if (bytes <= gigabytes * 1e9) return Done{};
  const Patches& patches = room.patches;
  const double rays = options.paper ? nearBytes(patches, options) : 0;
  const double clusters = 4.0 * patches.count * patches.clusterCount;
  const double responses = 8.0 * patches.rows() * static_cast<double>(room.sites.size());
  std::string cure = std::to_string(patches.rows()) + " patches x " + std::to_string(patches.clusterCount) +
                     " clusters are too many: pass a larger --patch";
  if (rays >= clusters && rays >= responses)
    cure = std::to_string(patches.rows()) + " patches x " + std::to_string(options.rays) +
           " rays are too many: pass a larger --patch or fewer --rays";
  else if (responses >= clusters)
    cure = std::to_string(patches.rows()) + " patches x " + std::to_string(room.sites.size()) +
           " sites are too many: pass a larger --patch or --site-spacing";
  char line[160];
  std::snprintf(line, sizeof line, "it would take %.1f GB where --memory allows %.1f: ", bytes / 1e9,
                gigabytes);
  return Error{line + cure};
}

}  // namespace fiatlux
