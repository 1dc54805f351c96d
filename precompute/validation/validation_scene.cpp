#include "precompute/validation/validation_scene.h"

#include <cassert>

namespace fiatlux {

std::vector<RectangleSurface> zUpBox(double x, double y, double z, double reflectance) {
  return {zUpRectangle("floor", {0, 0, 0}, {x, 0, 0}, {0, y, 0}, reflectance),
          zUpRectangle("ceiling", {0, 0, z}, {0, y, 0}, {x, 0, 0}, reflectance),
          zUpRectangle("wall x=0", {0, 0, 0}, {0, y, 0}, {0, 0, z}, reflectance),
          zUpRectangle("wall x=max", {x, 0, 0}, {0, 0, z}, {0, y, 0}, reflectance),
          zUpRectangle("wall y=0", {0, 0, 0}, {0, 0, z}, {x, 0, 0}, reflectance),
          zUpRectangle("wall y=max", {0, y, 0}, {x, 0, 0}, {0, 0, z}, reflectance)};
}

ValidationScene::ValidationScene(Validation& validation, const std::string& topic, const SourceScene& source,
                                 double patch)
    : options_(validation.options) {
  Result<TracedRoom> traced = roomOf(source, patch);
  if (!traced) {
    validation.failure(topic, traced.error().message);
    return;
  }
  traced_ = std::make_unique<TracedRoom>(std::move(*traced));
}

bool ValidationScene::belongs(std::uint32_t row, const std::string& name) const {
  const std::string& surface = traced_->room.surfaces[traced_->room.patches.surface[row]].name;
  return name.empty() || surface == name || surface.rfind(name + "/", 0) == 0;
}

double ValidationScene::area(const std::string& name) const {
  double sum = 0;
  for (std::uint32_t p = 0; p < traced_->room.patches.count; ++p) {
    if (belongs(p, name)) sum += traced_->room.patches.area[p];
  }
  return sum;
}

double ValidationScene::mean(const std::vector<float>& values, const std::string& name) const {
  assert(values.size() >= traced_->room.patches.count);
  double sum = 0;
  for (std::uint32_t p = 0; p < traced_->room.patches.count; ++p) {
    if (belongs(p, name)) sum += traced_->room.patches.area[p] * values[p];
  }
  return sum / area(name);
}

ForwardLight ValidationScene::light(const std::vector<Luminaire>& luminaires,
                                    const std::vector<float>& emission) const {
  ForwardOptions forward;
  forward.rays = options_.rays;
  forward.seed = options_.seed;
  forward.threads = options_.threads;
  Result<ForwardLight> light =
      computeForwardLight(traced_->room, traced_->tracer, luminaires, forward, emission);
  if (light) return std::move(*light);
  ForwardLight dark;  // a failing case shows as zeros
  dark.direct.assign(traced_->room.patches.rows(), 0.0f);
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
  return readPoints(traced_->room, traced_->tracer, points, luminaires, radiosity, options);
}

}  // namespace fiatlux
