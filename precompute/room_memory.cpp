#include "precompute/room_memory.h"

#include <algorithm>
#include <string>

#include "core/short_number.h"
#include "precompute/command_error.h"
#include "precompute/transport_memory.h"

namespace fiatlux {

void checkForeseenMemory(const RoomOptions& options, double patches, double clusters, double rows,
                         double sites, double surfaces) {
  struct Part {
    double bytes;
    std::string what, cure;
  };
  const std::string n = shortNumber(patches);
  constexpr double kRowBytes = 600;  // geometry
  const double kept = options.paper ? 0 : kUsualEntries * (sizeof(NearPatch) + sizeof(ClusterSlope));
  const Part parts[] = {
      {patches * clusters * 4, n + " patches x " + shortNumber(clusters) + " clusters",
       "a larger --patch or --cluster"},
      {options.paper ? patches * std::min<double>(options.rays, patches) * sizeof(NearPatch) : 0,
       n + " patches x " + std::to_string(options.rays) + " rays", "a larger --patch or fewer --rays"},
      {rows * sites * 4, shortNumber(rows) + " patches x " + shortNumber(sites) + " sites",
       "a larger --patch or --site-spacing"},
      {surfaces * sites * sites * 8,
       shortNumber(surfaces) + " surfaces x " + shortNumber(sites) + " sites squared",
       "a larger --site-spacing"},
      {rows * (kRowBytes + kept), n + " patches", "a larger --patch"}};
  double total = 0;
  const Part* largest = parts;
  for (const Part& part : parts) {
    total += part.bytes;
    if (part.bytes > largest->bytes) largest = &part;
  }
  if (!(total <= options.memory * 1e9))
    throw CommandError("this would need " + shortNumber(total / 1e9) + " GB, and --memory allows " +
                       shortNumber(options.memory) + ": too many are " + largest->what + "; pass " +
                       largest->cure);
}

double foreseenPatches(const std::vector<ChartDraft>& charts) {
  double patches = 0;
  for (const ChartDraft& draft : charts)
    patches += std::max(1.0, draft.area / (draft.chart.cellU * draft.chart.cellV));
  return patches;
}

void checkGrids(const std::vector<ChartDraft>& charts, const RoomOptions& options, double patch,
                std::uint32_t mostClusters) {
  double cells = 0;
  for (const ChartDraft& draft : charts) {
    cells += static_cast<double>(draft.chart.columns) * draft.chart.rows;
  }
  if (cells * 24 > options.memory * 1e9)
    throw CommandError("patches of " + shortNumber(patch) + " m need " + shortNumber(cells) +
                       " grid cells, more than --memory allows; pass a larger --patch");
  const double patches = foreseenPatches(charts);
  const double clusters = options.paper ? patches / (options.cluster * options.cluster)
                                        : std::min<double>(patches / 4, mostClusters);
  checkForeseenMemory(options, patches, clusters, patches, 0, 0);
}

}  // namespace fiatlux
