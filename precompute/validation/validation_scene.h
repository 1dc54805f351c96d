// A generated room with its tracer, and the few questions that the analytic cases ask of it.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "precompute/light/forward_light.h"
#include "precompute/light/point_light.h"
#include "precompute/validation/generated_scene.h"
#include "precompute/validation/validation.h"

namespace fiatlux {

/// x, y and z up, as the analytic cases are written, into the room's y up.
inline Vec3 zUp(double x, double y, double z) { return {x, z, -y}; }

/// A rectangle given in z-up coordinates; its front is where u x v points.
inline RectangleSurface zUpRectangle(const std::string& name, const Vec3& corner, const Vec3& u,
                                     const Vec3& v, double reflectance) {
  return {name, zUp(corner.x, corner.y, corner.z), zUp(u.x, u.y, u.z), zUp(v.x, v.y, v.z), reflectance, 1, 1,
          false};
}

/// A box from 0, 0, 0 to x, y, z, seen from inside: floor, ceiling, "wall x=0", "wall x=max", "wall y=0" and
/// "wall y=max".
std::vector<RectangleSurface> zUpBox(double x, double y, double z, double reflectance);

class ValidationScene {
 public:
  /// Reports to `validation` and is empty (false) where the room cannot be built.
  ValidationScene(Validation& validation, const std::string& topic, const SourceScene& source, double patch);
  explicit operator bool() const { return traced_ != nullptr; }

  const Room& room() const { return traced_->room; }
  const RayTracer& tracer() const { return traced_->tracer; }
  /// Whether the row belongs to surface `name` or to a surface below it.
  bool belongs(std::uint32_t row, const std::string& name) const;
  double area(const std::string& name) const;
  /// Area-weighted mean over a surface, or over all patches for "".
  double mean(const std::vector<float>& values, const std::string& name) const;
  /// Forward light; emission is asked of each patch where given.
  ForwardLight light(const std::vector<Luminaire>& luminaires, const std::vector<float>& emission = {}) const;
  std::vector<PointReading> read(const std::vector<MeasuringPoint>& points,
                                 const std::vector<Luminaire>& luminaires,
                                 const std::vector<float>& radiosity) const;

 private:
  const ValidationOptions options_;
  std::unique_ptr<TracedRoom> traced_;
};

}  // namespace fiatlux
