#include "precompute/geometry/outlook.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "precompute/rays/hemisphere.h"
#include "precompute/room/disjoint_sets.h"

namespace fiatlux {
namespace {

constexpr std::size_t kMostPieces = std::size_t{1} << 16;
constexpr double kRayBudget = 2e6;                        // of one look at all pieces
constexpr std::uint32_t kFewRays = 64, kManyRays = 4096;  // from a piece: at least, at most
constexpr std::uint32_t kCloserRays = 1024;               // before a piece is called unlit
constexpr std::uint32_t kLightRays = 256;                 // from a piece, or a mount, to where light starts
constexpr double kOpen = 0.5;                             // share of lost rays from which a space is open
constexpr double kSees = 0.005;                           // share of rays that must meet what is lit

}  // namespace

Outlook::Outlook(const WeldedMesh& mesh, const RayTracer& tracer, const std::vector<ChartDraft>& pieces)
    : mesh_(mesh),
      tracer_(tracer),
      sequence_(kManyRays),
      pieceOfSide_(mesh.triangles.size(), {kNone, kNone}),
      swallowed_(mesh.triangles.size(), {0, 0}) {
  if (pieces.empty() || pieces.size() > kMostPieces) return;
  double area = 0;
  for (std::uint32_t p = 0; p < pieces.size(); ++p) {
    for (const Face& face : pieces[p].faces) pieceOfSide_[face.triangle][face.back] = p;
    pieces_.push_back({AreaSampler(trianglesOf(mesh, pieces[p].faces)), 0, 0, {}});
    area += pieces_.back().sampler.area();
  }

  // Cast rays by area, a few at least from every piece.
  const auto least = static_cast<std::uint32_t>(
      std::clamp<double>(kRayBudget / static_cast<double>(pieces_.size()), RayPacket::kSize, kFewRays));
  for (std::uint32_t p = 0; p < pieces_.size(); ++p) {
    const auto share = static_cast<std::uint32_t>(16 * kManyRays * pieces_[p].sampler.area() / area);
    cast(p, std::min(least + share, kManyRays), p);
  }
}

void Outlook::cast(std::uint32_t index, std::uint32_t rays, std::uint64_t seed) {
  Piece& piece = pieces_[index];
  const auto scramble = RaySequence::scramble(mixBits(seed));
  Vec3 direction[RayPacket::kSize];
  for (std::uint32_t first = 0; first < rays; first += RayPacket::kSize) {
    RayPacket packet;
    for (std::uint32_t i = first; i < std::min(first + RayPacket::kSize, rays); ++i) {
      const auto random = sequence_.point(i, scramble);
      const AreaSampler::Point from = piece.sampler.at(random[2], random[3]);
      direction[i - first] = cosineDirection(Frame(from.normal), random[0], random[1]);
      tracer_.aim(packet, from.position + tracer_.offset() * from.normal, direction[i - first],
                  std::numeric_limits<float>::infinity());
    }
    HitPacket hits;
    tracer_.intersect(packet, hits);
    for (std::uint32_t i = 0; i < packet.count; ++i) {
      const std::uint32_t t = hits.triangle[i];
      std::uint32_t met = kNone;
      if (t != kNone) {
        const bool back = dot(direction[i], areaVector(mesh_.positions, mesh_.triangles[t].vertex)) > 0;
        met = pieceOfSide_[t][back];
        if (met == kNone) ++swallowed_[t][back];
      }
      if (met == kNone)
        ++piece.lost;
      else
        piece.met.push_back(met);
    }
  }
  piece.rays += rays;
}

double Outlook::lost(std::uint32_t triangle, bool back) const {
  const std::uint32_t piece = pieceOfSide_[triangle][back];
  if (piece == kNone) return 0;
  return static_cast<double>(pieces_[piece].lost) / pieces_[piece].rays;
}

bool Outlook::seesLight(std::uint32_t index, const std::vector<LightPlace>& places,
                        std::uint32_t rays) const {
  const auto scramble = RaySequence::scramble(mixBits(~std::uint64_t{index}));
  RayPacket packet;
  const auto reaches = [&] {
    bool blocked[RayPacket::kSize];
    tracer_.occluded(packet, blocked);
    const bool all = std::all_of(blocked, blocked + packet.count, [](bool b) { return b; });
    packet.count = 0;
    return !all;
  };
  for (std::uint32_t i = 0; i < rays; ++i) {
    const auto random = sequence_.point(i, scramble);
    const AreaSampler::Point from = pieces_[index].sampler.at(random[2], random[3]);
    const LightPlace& light = places[std::size_t{i} * places.size() / rays];
    const Vec3 way = light.position - from.position;
    if (dot(way, from.normal) <= 0 || dot(way, light.normal) > 0) continue;
    tracer_.aim(packet, from.position + tracer_.offset() * from.normal, way, 1);
    if (packet.count == RayPacket::kSize && reaches()) return true;
  }
  return packet.count > 0 && reaches();
}

/// Light goes from what is lit to what sees it, by the rays of either (A_p F_pq = A_q F_qp).
void Outlook::spread(std::vector<bool>& lit) const {
  for (bool changed = true; changed;) {
    changed = false;
    std::vector<double> received(pieces_.size(), 0);  // m2
    for (std::uint32_t p = 0; p < pieces_.size(); ++p)
      if (lit[p])
        for (const std::uint32_t q : pieces_[p].met)
          received[q] += pieces_[p].sampler.area() / pieces_[p].rays;
    for (std::uint32_t p = 0; p < pieces_.size(); ++p) {
      if (lit[p]) continue;
      const auto seen = std::count_if(pieces_[p].met.begin(), pieces_[p].met.end(),
                                      [&](std::uint32_t q) { return lit[q]; });
      if (static_cast<double>(seen) < kSees * pieces_[p].rays &&
          received[p] < kSees * pieces_[p].sampler.area())
        continue;
      lit[p] = changed = true;
    }
  }
}

/// Which of the dark pieces are open: together with the dark ones they see, they lose half of their rays.
std::vector<bool> Outlook::open(const std::vector<bool>& lit) const {
  DisjointSets spaces(pieces_.size());
  std::vector<std::uint32_t> met;
  for (std::uint32_t p = 0; p < pieces_.size(); ++p) {
    if (lit[p]) continue;
    met = pieces_[p].met;
    std::sort(met.begin(), met.end());
    for (std::size_t i = 0, j; i < met.size(); i = j) {
      for (j = i; j < met.size() && met[j] == met[i]; ++j) {
      }
      if (!lit[met[i]] && static_cast<double>(j - i) >= kSees * pieces_[p].rays) spaces.join(p, met[i]);
    }
  }
  std::vector<double> area(pieces_.size(), 0), lost(pieces_.size(), 0);
  for (std::uint32_t p = 0; p < pieces_.size(); ++p) {
    area[spaces.find(p)] += pieces_[p].sampler.area();
    lost[spaces.find(p)] += pieces_[p].sampler.area() * pieces_[p].lost / pieces_[p].rays;
  }
  std::vector<bool> open(pieces_.size());
  for (std::uint32_t p = 0; p < pieces_.size(); ++p)
    open[p] = !lit[p] && lost[spaces.find(p)] >= kOpen * area[spaces.find(p)];
  return open;
}

Outlook::Unlit Outlook::unlit(const std::vector<Face>& mounts, const std::vector<LightPlace>& places) {
  const std::vector<std::array<bool, 2>> none(mesh_.triangles.size(), {false, false});
  Unlit unlit{none, none};
  if (pieces_.empty() || (mounts.empty() && places.empty())) return unlit;
  std::vector<LightPlace> lights = places;
  if (!mounts.empty()) {
    const AreaSampler sampler(trianglesOf(mesh_, mounts));
    const auto scramble = RaySequence::scramble(0);
    for (std::uint32_t i = 0; i < kLightRays; ++i) {
      const auto random = sequence_.point(i, scramble);
      const auto [position, normal] = sampler.at(random[0], random[1]);
      lights.push_back({position + 2 * tracer_.offset() * normal, normal});
    }
  }
  std::vector<bool> lit(pieces_.size(), false);
  for (const Face& face : mounts)
    if (const std::uint32_t p = pieceOfSide_[face.triangle][face.back]; p != kNone) lit[p] = true;
  spread(lit);
  const auto raysOfEach = [&](const std::vector<bool>& which, bool value, std::uint32_t most) {
    const auto count = static_cast<double>(std::count(which.begin(), which.end(), value));
    return static_cast<std::uint32_t>(
        std::clamp<double>(kRayBudget / std::max(count, 1.0), RayPacket::kSize, most));
  };
  const std::uint32_t lightRays = raysOfEach(lit, false, kLightRays);
  for (std::uint32_t p = 0; p < pieces_.size(); ++p)
    if (!lit[p]) lit[p] = seesLight(p, lights, lightRays);
  spread(lit);

  // A closer look at what would be given up.
  std::vector<bool> outside = open(lit);
  const std::uint32_t rays = raysOfEach(outside, true, kCloserRays);
  for (std::uint32_t p = 0; p < pieces_.size(); ++p)
    if (outside[p]) cast(p, rays, p + (std::uint64_t{1} << 32));
  spread(lit);
  outside = open(lit);
  for (std::size_t t = 0; t < none.size(); ++t)
    for (const bool back : {false, true})
      if (const std::uint32_t p = pieceOfSide_[t][back]; p != kNone) {
        unlit.outside[t][back] = outside[p];
        unlit.shutOff[t][back] = !outside[p] && !lit[p];
      }
  return unlit;
}

}  // namespace fiatlux
