#include "precompute/validation/validation_scene.h"

namespace fiatlux {

ValidationScene::ValidationScene(Validation& validation, const std::string& topic, const SourceScene& source,
                                 double patch)
    : options_(validation.options) {
  Result<Room> room = roomOf(source, patch);
  if (!room) {
    validation.failure(topic, room.error().message);
    return;
  }
  room_ = std::make_unique<Room>(std::move(*room));
  Result<RayTracer> tracer = RayTracer::build(*room_);
  if (!tracer) {
    validation.failure(topic, tracer.error().message);
    return;
  }
  tracer_ = std::make_unique<RayTracer>(std::move(*tracer));
}

bool ValidationScene::belongs(std::uint32_t row, const std::string& name) const {
  const std::string& surface = room_->surfaces[room_->patches.surface[row]].name;
  return name.empty() || surface == name || surface.rfind(name + "/", 0) == 0;
}

double ValidationScene::area(const std::string& name) const {
  double sum = 0;
  for (std::uint32_t p = 0; p < room_->patches.count; ++p) {
    if (belongs(p, name)) sum += room_->patches.area[p];
  }
  return sum;
}

double ValidationScene::mean(const std::vector<float>& values, const std::string& name) const {
  double sum = 0;
  for (std::uint32_t p = 0; p < room_->patches.count; ++p) {
    if (belongs(p, name)) sum += room_->patches.area[p] * values[p];
  }
  return sum / area(name);
}

ForwardLight ValidationScene::light(const std::vector<Luminaire>& luminaires,
                                    const std::vector<float>& emission) const {
  ForwardOptions forward;
  forward.rays = options_.rays;
  forward.seed = options_.seed;
  forward.threads = options_.threads;
  Result<ForwardLight> light = computeForwardLight(*room_, *tracer_, luminaires, forward, emission);
  if (light) return std::move(*light);
  ForwardLight dark;  // a failing case shows as zeros
  dark.direct.assign(room_->patches.rows(), 0.0f);
  dark.illuminance = dark.radiosity = dark.direct;
  dark.residual = 1;
  return dark;
}

std::vector<PointReading> ValidationScene::read(const std::vector<MeasuringPoint>& points,
                                                const std::vector<Luminaire>& luminaires,
                                                const std::vector<float>& radiosity) const {
  PointOptions options;
  options.seed = options_.seed;
  options.threads = options_.threads;
  options.rays = 16384;
  options.spatial = false;
  return readPoints(*tracer_, points, luminaires, radiosity, options);
}

}  // namespace fiatlux
