// Patches, clusters and luminaires as places that a shaft can join (shaft.h).
#pragma once

#include <atomic>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "precompute/rays/ray_tracer.h"
#include "precompute/room/room.h"

namespace fiatlux {

/// Where rays start that leave these patches of one chart, the tracer's offset above them, and end that meet
/// them: a rectangle around them. Nothing where they are not flat.
std::optional<Place> placeOf(const Room& room, const RayTracer& tracer,
                             std::span<const std::uint32_t> patches);

/// Of every cluster.
std::vector<std::optional<Place>> placesOfClusters(const Room& room, const RayTracer& tracer);

/// What stands between pairs of places, each asked for when it is wanted first, on any thread.
class BetweenPlaces {
 public:
  using Places = std::vector<std::optional<Place>>;
  BetweenPlaces(const RayTracer& tracer, Places from, Places to);
  Between at(std::size_t from, std::size_t to) const;
  const std::optional<Place>& to(std::size_t i) const { return to_[i]; }

 private:
  const RayTracer& tracer_;
  Places from_, to_;
  // note: two threads may ask at once; they get the same answer.
  mutable std::vector<std::atomic<std::uint8_t>> known_;  // from x to: 0, or 1 + the answer
};

}  // namespace fiatlux
