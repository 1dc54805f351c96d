#include "precompute/light/observer_light.h"

#include <numbers>

#include "core/transport/room_view.h"
#include "precompute/light/emission.h"

namespace fiatlux {
namespace {

/// Share of a luminaire's rectangle that is seen from an eye, `split` x `split` points of it.
double seenShare(const RayTracer& tracer, const Vec3& eye, const Luminaire& luminaire, std::uint32_t split) {
  const Emission source(luminaire);
  std::uint32_t seen = 0;
  for (std::uint32_t i = 0; i < split * split;) {
    RayPacket packet;
    for (; packet.count < RayPacket::kSize && i < split * split; ++i)
      tracer.aim(packet, eye, source.startAt((i % split + 0.5) / split, (i / split + 0.5) / split) - eye, 1);
    bool blocked[RayPacket::kSize];
    tracer.occluded(packet, blocked, true);
    for (std::uint32_t k = 0; k < packet.count; ++k)
      if (!blocked[k]) ++seen;
  }
  return static_cast<double>(seen) / (split * split);
}

}  // namespace

std::vector<ObserverReading> observerReadings(const Room& room, const RayTracer& tracer,
                                              const std::vector<Observer>& observers,
                                              const std::vector<Luminaire>& luminaires,
                                              const std::vector<float>& radiosity,
                                              const PointOptions& options) {
  std::vector<MeasuringPoint> eyes;
  for (const Observer& observer : observers) eyes.push_back({observer.position, observer.direction});
  const std::vector<PointReading> points = readPoints(room, tracer, eyes, luminaires, radiosity, options);
  std::vector<ObserverReading> readings;
  for (std::size_t o = 0; o < observers.size(); ++o) {
    ObserverReading reading;
    reading.background = (points[o].total - points[o].direct) / std::numbers::pi;
    reading.vertical = points[o].total;
    reading.cylindrical = points[o].cylindrical;
    for (const Luminaire& luminaire : luminaires) {
      const double glare = glareOf(luminaire, observers[o]);
      if (glare > 0)
        reading.glare += glare * seenShare(tracer, observers[o].position, luminaire, options.split);
    }
    readings.push_back(reading);
  }
  return readings;
}

}  // namespace fiatlux
