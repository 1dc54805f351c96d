// The two ray tracers side by side in rooms: tracer_bench [--rays N] ROOM.glb... A line a room: millions of
// rays per second of each, and how many hits differ that are not at an edge (none should). Ends with 1 where
// some do.
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <functional>
#include <string>

#include "core/base/random.h"
#include "precompute/files/command_host.h"
#include "precompute/pipeline/pipeline.h"
#include "precompute/rays/embree_scene.h"
#include "precompute/rays/hemisphere.h"
#include "precompute/rays/patch_sampler.h"
#include "precompute/rays/triangle_tree.h"
#include "tests/precompute/rays/tracer_agreement.h"

namespace fiatlux {
namespace {

using testing::LocalTriangles;

/// Millions of rays per second, the better of three runs.
double rate(const std::vector<RayPacket>& packets, const std::function<void(const RayPacket&)>& trace) {
  double best = 0;
  for (int run = 0; run < 3; ++run) {
    const auto begin = std::chrono::steady_clock::now();
    for (const RayPacket& packet : packets) trace(packet);
    const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - begin;
    best = std::max(best, static_cast<double>(packets.size()) * RayPacket::kSize / 1e6 / seconds.count());
  }
  return best;
}

/// What one patch casts: cosine rays to wherever, and shadow rays from all over it to one site.
void castFrom(const Room& room, const LocalTriangles& local, double offset, Random& random, RayPacket& bounce,
              RayPacket& shadow) {
  const PatchSampler sampler(room, random.below(room.patches.rows()));
  const Site* site = room.sites.empty() ? nullptr : &room.sites[random.below(room.sites.size())];
  for (std::uint32_t i = 0; i < RayPacket::kSize; ++i) {
    const PatchPoint point = sampler.at(random.unit(), random.unit());
    const Vec3 origin = point.position + offset * point.normal - local.center;
    const Vec3 direction = cosineDirection(Frame(point.normal), random.unit(), random.unit());
    testing::aimAt(bounce, origin, direction, INFINITY);
    const Vec3 target = site ? site->position + offset * site->normal - local.center : origin + 2 * direction;
    testing::aimAt(shadow, origin, target - origin, 1);
  }
}

struct Tracers {
  EmbreeScene embree;
  TriangleTree tree;
};

std::uint32_t differingHits(const LocalTriangles& local, double offset, const Tracers& tracers,
                            const std::vector<RayPacket>& packets) {
  std::uint32_t count = 0;
  for (const RayPacket& packet : packets) {
    HitPacket here, there;
    tracers.tree.intersect(packet, here);
    tracers.embree.intersect(packet, there);
    count += testing::differing(local, offset, packet, here, there);
  }
  return count;
}

std::uint32_t compare(const std::string& path, std::uint32_t rays) {
  TerminalProgress progress;
  const auto model = modelAt(path);
  const auto opened = model ? openRoom(*model, {}, commandHost(path, 1, progress, false)) : model.error();
  progress.clear();
  if (!opened) {
    std::fprintf(stderr, "%s: %s\n", path.c_str(), opened.error().message.c_str());
    return 1;
  }
  const Room& room = opened->room;
  std::vector<RayTracer::Triangle> triangles;
  for (const RoomTriangle& t : room.triangles) triangles.push_back(t.vertex);
  const LocalTriangles local(room.positions, std::move(triangles));
  const double offset = opened->tracer.offset();
  const Tracers tracers{std::move(*EmbreeScene::build(local.positions, local.triangles)),
                        std::move(*TriangleTree::build(local.positions, local.triangles))};

  std::vector<RayPacket> bounces(rays / RayPacket::kSize), shadows(bounces.size());
  Random random(7);
  for (std::size_t i = 0; i < bounces.size(); ++i)
    castFrom(room, local, offset, random, bounces[i], shadows[i]);
  HitPacket hits;
  bool blocked[RayPacket::kSize];
  const double bounce[] = {rate(bounces, [&](const RayPacket& p) { tracers.embree.intersect(p, hits); }),
                           rate(bounces, [&](const RayPacket& p) { tracers.tree.intersect(p, hits); })};
  const double shadow[] = {
      rate(shadows, [&](const RayPacket& p) { tracers.embree.occluded(p, blocked, true); }),
      rate(shadows, [&](const RayPacket& p) { tracers.tree.occluded(p, blocked, true); })};
  const std::uint32_t differ =
      differingHits(local, offset, tracers, bounces) + differingHits(local, offset, tracers, shadows);
  std::printf(
      "{\"room\": \"%s\", \"triangles\": %zu, \"bounceEmbree\": %.2f, \"bounceTree\": %.2f, "
      "\"shadowEmbree\": %.2f, \"shadowTree\": %.2f, \"differ\": %u}\n",
      path.c_str(), local.triangles.size(), bounce[0], bounce[1], shadow[0], shadow[1], differ);
  return differ;
}

}  // namespace
}  // namespace fiatlux

int main(int argc, char** argv) {
  std::uint32_t rays = 1'000'000, differ = 0;
  for (int i = 1; i < argc; ++i) {
    if (std::string(argv[i]) == "--rays" && i + 1 < argc) {
      rays = static_cast<std::uint32_t>(std::atoi(argv[++i]));
    } else {
      differ += fiatlux::compare(argv[i], rays);
    }
  }
  return differ > 0 ? 1 : 0;
}
