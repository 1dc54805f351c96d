#include "precompute/light/paper_transport.h"

#include <algorithm>
#include <cassert>
#include <map>

#include "core/transport/surface_statistics.h"
#include "precompute/base/parallel.h"

namespace fiatlux {

namespace {

constexpr double kHanging = 0.002;  // m, a mount lies within this of its site

/// V^T E of each site at 1 lm: the share of its square that lies on patches of cluster c, divided by A_c.
SparseRows clustersUnderSites(const Room& room, const RayTracer& tracer) {
  const Patches& patches = room.patches;
  std::vector<double> clusterArea(patches.clusterCount, 0.0);
  for (std::uint32_t q = 0; q < patches.count; ++q) clusterArea[patches.cluster[q]] += patches.area[q];
  constexpr std::uint32_t kEdge = 32;  // probes on a site's edge
  SparseRows rows;
  for (const Site& site : room.sites) {
    const Vec3 other = cross(site.normal, site.axis);
    std::map<std::uint32_t, std::uint32_t> probes;  // cluster -> probes that fell on it
    std::uint32_t found = 0;
    for (std::uint32_t i = 0; i < kEdge; ++i) {
      RayPacket packet;
      Vec3 origin[RayPacket::kSize];
      for (std::uint32_t j = 0; j < kEdge; ++j) {
        origin[packet.count] = site.position + kHanging * site.normal +
                               ((i + 0.5) / kEdge - 0.5) * site.size * site.axis +
                               ((j + 0.5) / kEdge - 0.5) * site.size * other;
        tracer.aim(packet, origin[packet.count], -site.normal, 2 * kHanging);
        if (packet.count < RayPacket::kSize) continue;
        HitPacket hits;
        tracer.intersect(packet, hits);
        for (std::uint32_t lane = 0; lane < packet.count; ++lane) {
          const std::uint32_t q =
              room.patchMet(origin[lane], -site.normal, hits.triangle[lane], hits.distance[lane]);
          if (q == kNone) continue;
          ++probes[patches.cluster[q]];
          ++found;
        }
        packet.count = 0;
      }
    }
    for (const auto& [cluster, count] : probes) {
      rows.column.push_back(cluster);
      rows.weight.push_back(static_cast<double>(count) / found / clusterArea[cluster]);
    }
    rows.offset.push_back(static_cast<std::uint32_t>(rows.column.size()));
  }
  return rows;
}

/// Irradiance of one site: U (I - V^T R U)^-1 x.
void respond(const FormFactors& factors, const std::vector<double>& coreInverse, const SparseRows& sites,
             std::uint32_t site, float* column) {
  const std::uint32_t k = factors.clusters;
  std::vector<double> solved(k, 0.0);
  for (std::uint32_t i = sites.offset[site]; i < sites.offset[site + 1]; ++i) {
    for (std::uint32_t c = 0; c < k; ++c) {
      solved[c] += coreInverse[std::size_t{c} * k + sites.column[i]] * sites.weight[i];
    }
  }
  for (std::uint32_t p = 0; p < factors.rows; ++p) {
    const float* u = factors.u.data() + std::size_t{p} * k;
    double sum = 0;
    for (std::uint32_t c = 0; c < k; ++c) sum += u[c] * solved[c];
    column[p] = static_cast<float>(sum);
  }
}

/// Mean row and covariance of -Y over one surface.
SurfaceStatistics clusterStatistics(const Patches& patches, const std::vector<float>& y,
                                    std::uint32_t surface) {
  const std::uint32_t k = patches.clusterCount;
  std::vector<float> values;
  std::vector<double> weights;
  for (std::uint32_t p = 0; p < patches.count; ++p) {
    if (patches.surface[p] != surface || !patches.counts(p)) continue;
    for (std::uint32_t c = 0; c < k; ++c) values.push_back(-y[std::size_t{p} * k + c]);
    weights.push_back(patches.area[p]);
  }
  if (weights.empty()) return {};
  return surfaceStatistics(values.data(), weights.data(), static_cast<std::uint32_t>(weights.size()), k);
}

}  // namespace

PaperTransport paperTransport(const Room& room, const RayTracer& tracer, const FormFactors& factors,
                              const LowRankRadiosity& lowRank, unsigned threads, Responses& responses,
                              const std::function<void(double)>& progress) {
  assert(responses.illuminance.size() == std::size_t{responses.rows} * responses.sites);
  PaperTransport paper;
  paper.siteClusters = clustersUnderSites(room, tracer);
  paper.y = lowRank.y();
  const std::vector<double> coreInverse = lowRank.coreInverse();
  const auto respondTo = [&](std::size_t site) {
    respond(factors, coreInverse, paper.siteClusters, static_cast<std::uint32_t>(site),
            responses.illuminance.data() + site * responses.rows);
  };
  parallelFor(responses.sites, threads, respondTo, progress);
  paper.exitance.resize(room.surfaces.size());
  parallelFor(room.surfaces.size(), threads, [&](std::size_t surface) {
    paper.exitance[surface] = clusterStatistics(room.patches, paper.y, static_cast<std::uint32_t>(surface));
  });
  return paper;
}

}  // namespace fiatlux
