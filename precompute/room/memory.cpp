// Each array that grows with the room is one part: its bytes, what makes it large, and what makes it smaller.
#include "precompute/room/memory.h"

#include <algorithm>
#include <vector>

#include "core/base/short_number.h"
#include "core/transport/form_factors.h"
#include "core/transport/site_responses.h"

namespace fiatlux {
namespace {

/// What a row usually keeps of single patches and of slopes, outside --paper: furnished rooms have about as
/// many (the open office: 490 and 210).
constexpr double kUsualEntries = 512;

constexpr double kUsualGroup = 8;  // rows of a group between which light is exchanged, in furnished rooms
/// Share of the pairs of rows and groups that interpolation leaves something over of; bytes of one, twice.
constexpr double kUsualRest = 0.03, kRestBytes = 24;

constexpr double kRowBytes = 600;  // geometry: fragments, triangles, charts

struct Part {
  double bytes;
  std::string what, cure;
};

std::vector<Part> partsOf(const RunCounts& c) {
  constexpr double kFloat = sizeof(float), kDouble = sizeof(double);
  const double n = c.patches, k = c.clusters, m = c.sites;
  const std::string rows = shortNumber(c.rows) + " patches", sites = shortNumber(m) + " sites",
                    clusters = shortNumber(k) + " clusters";
  const double entries = c.paper ? sizeof(NearPatch) * std::min<double>(c.rays, n)
                                 : sizeof(NearPatch) * std::min(kUsualEntries, n) +
                                       sizeof(ClusterSlope) * std::min(kUsualEntries, k);
  const double copies = c.paper ? 1 : 2;  // responses; and direct light, of which they are made
  const double blocks = m > 0 && !c.paper ? c.threads * kFloat * kBlockWidth * (4 * n + 2 * c.rows) : 0;
  const double statistics = 2 * c.surfaces * kDouble * m * m + (c.paper ? c.surfaces * kDouble * k * k : 0);
  const double groups = c.exchange ? std::min<double>(kMostGroups, c.rows / kUsualGroup) : 0;
  const double visibility = c.exchange ? c.rows * m : 0,
               surfaceMeans = c.exchange ? 3 * kFloat * n * c.surfaces : 0;
  return {
      {c.rows * kRowBytes, rows, "a larger --patch"},
      {c.rows * entries, c.paper ? rows + " x " + std::to_string(c.rays) + " rays" : rows,
       c.paper ? "a larger --patch or fewer --rays" : "a larger --patch"},
      {(c.paper ? 2 : 1) * kFloat * c.rows * k + 3 * kDouble * k * k, rows + " x " + clusters,
       "a larger --patch or --cluster"},
      {copies * kFloat * c.rows * m + blocks, rows + " x " + sites, "a larger --patch or --site-spacing"},
      {visibility + surfaceMeans + 4 * kFloat * groups * groups + kUsualRest * kRestBytes * groups * c.rows,
       rows + " x " + sites + ", and their exchange", "--no-exchange or a larger --patch"},
      {statistics, shortNumber(c.surfaces) + " surfaces x " + sites + " squared", "a larger --site-spacing"}};
}

double sumOf(const std::vector<Part>& parts) {
  double total = 0;
  for (const Part& part : parts) total += part.bytes;
  return total;
}

}  // namespace

double bytesNeeded(const RunCounts& counts) { return sumOf(partsOf(counts)); }

Result<Done> checkMemory(const RunCounts& counts, double gigabytes) {
  const std::vector<Part> parts = partsOf(counts);
  const double total = sumOf(parts);
  if (total <= gigabytes * 1e9) return Done{};
  const Part& largest = *std::max_element(parts.begin(), parts.end(),
                                          [](const Part& a, const Part& b) { return a.bytes < b.bytes; });
  return Error{"this would need " + shortNumber(total / 1e9) + " GB, and --memory allows " +
               shortNumber(gigabytes) + ": too many are " + largest.what + "; pass " + largest.cure};
}

}  // namespace fiatlux
