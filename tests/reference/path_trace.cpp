// path_trace ROOM.glb LAYOUT.json VIEW.json OUT: what an eye sees in a room, by paths of light alone: no
// patch takes a mean, nothing is interpolated. Run by path-traced-pictures.mjs.
//   E_k(x) = direct(x) + mean over cosine rays x -> y of rho_k(y) E_k(y), traced until a path dies by chance
// VIEW: {"position", "target" (m), "fov" (degrees, vertical), "width", "height" (pixels), "paths" (a pixel)}.
// OUT: floats, kFields a pixel, rows from the top: direct light, lx; reflected light of one half of the
// paths, three channels, and of the other half, so that two pictures differ by chance alone; albedo, three
// channels; the share of what lies before a place that is near; the number of its surface, and of that which
// is nearest
// (-1: none). Standard output: {"surfaces": [name, ...]}.
#include <array>
#include <cmath>
#include <cstdio>
#include <nlohmann/json.hpp>
#include <numbers>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "core/base/random.h"
#include "precompute/base/error.h"
#include "precompute/base/parallel.h"
#include "precompute/files/command_host.h"
#include "precompute/files/files_on_disk.h"
#include "precompute/files/layout_json.h"
#include "precompute/gltf/reflectance.h"
#include "precompute/light/direct_light.h"
#include "precompute/pipeline/pipeline.h"
#include "precompute/rays/hemisphere.h"
#include "precompute/rays/ray_sequence.h"

namespace fiatlux {
namespace {

using Color = std::array<double, 3>;  // linear red, green, blue

constexpr std::uint32_t kFields = 13;
constexpr double kNear = 0.15;        // m: what a ray meets within is near
constexpr int kSureBounces = 3;       // before chance ends a path
constexpr std::uint32_t kSplit = 8;   // of a source's edge, for shadows that are seen
constexpr std::uint32_t kTexels = 4;  // a pixel's edge has so many for its albedo

struct View {
  Vec3 position, right, up, forward;  // m; `right` and `up` of half a picture's edge at a distance of 1
  std::uint32_t width = 0, height = 0, paths = 0;

  Vec3 direction(double x, double y) const {  // in pixels from the upper left
    return forward + (2 * x / width - 1) * right + (1 - 2 * y / height) * up;
  }
};

View viewOf(const std::string& path) {
  const std::vector<std::uint8_t> bytes = orThrow(readFileBytes(path));
  const auto json = nlohmann::json::parse(bytes);
  const auto point = [&](const char* key) {
    const auto p = json.at(key).get<std::array<double, 3>>();
    return Vec3{p[0], p[1], p[2]};
  };
  View view{point("position"), {}, {}, {}, json.at("width"), json.at("height"), json.at("paths")};
  view.forward = normalized(point("target") - view.position);
  const double tangent = std::tan(json.at("fov").get<double>() * std::numbers::pi / 360);
  const Vec3 right = normalized(cross(view.forward, {0, 1, 0}));
  view.right = tangent * view.width / view.height * right;
  view.up = tangent * cross(right, view.forward);
  return view;
}

/// Where a ray met something that reflects.
struct Meeting {
  std::uint32_t triangle = kNone, patch = kNone;
  bool back = false;
  double distance = 0;  // in lengths of the ray's direction
  Vec3 point, normal;   // m; unit, to where the ray came from
};

class PathTracer {
 public:
  PathTracer(const OpenedRoom& opened, const std::vector<Luminaire>& luminaires)
      : room_(opened.room), tracer_(opened.tracer), colors_(opened.source), luminaires_(luminaires) {}

  /// `throughBacks`: what has no surface on the side of the ray is not there, as where walls are cut away.
  std::optional<Meeting> meet(const Vec3& from, const Vec3& direction, bool throughBacks) const {
    Vec3 origin = from;
    for (int sheets = 0; sheets < 16; ++sheets) {
      const auto [t, distance] = tracer_.firstHit(origin, direction);
      if (t == kNone) return {};
      const auto& v = room_.triangles[t].vertex;
      const Vec3 a = room_.positions[v[0]];
      const Vec3 front = normalized(cross(room_.positions[v[1]] - a, room_.positions[v[2]] - a));
      const bool back = dot(direction, front) > 0;
      const std::uint32_t patch = room_.patchMet(origin, direction, t, distance);
      const Vec3 point = origin + distance * direction;
      if (patch != kNone)
        return Meeting{
            t, patch, back, length(point - from) / length(direction), point, back ? -front : front};
      if (!throughBacks) return {};
      origin = point + (2 * tracer_.offset() / length(direction)) * direction;
    }
    return {};
  }

  /// Of the material there, as the picture has it.
  Color albedo(const Meeting& at) const {
    const RoomTriangle& triangle = room_.triangles[at.triangle];
    const SourceTriangle& from = at.back ? triangle.backSource : triangle.source;
    const SourceMesh& mesh = colors_.source().meshes[from.mesh];
    const auto& v = mesh.triangles[from.triangle];
    const Vec3 a = mesh.positions[v[0]], ab = mesh.positions[v[1]] - a, ac = mesh.positions[v[2]] - a;
    const Vec3 normal = cross(ab, ac);
    const double whole = dot(normal, normal);
    const double u = dot(cross(at.point - a, ac), normal) / whole,
                 w = dot(cross(ab, at.point - a), normal) / whole;
    return colors_.colorAt(from.mesh, from.triangle, {1 - u - w, u, w});
  }

  /// The same hue as bright as the patch reflects.
  Color reflectance(const Meeting& at) const {
    Color color = albedo(at);
    const double whole = luminanceOf(color[0], color[1], color[2]);
    const double reflected = room_.patches.reflectance[at.patch];
    for (double& c : color) c = whole > 0 ? std::min(kMostReflectance, c * reflected / whole) : reflected;
    return color;
  }

  double direct(const Meeting& at, std::uint32_t split, std::uint64_t seed) const {
    double sum = 0;
    for (std::size_t i = 0; i < luminaires_.size(); ++i)
      sum += directLightAt(tracer_, receiver(at), luminaires_[i], split, mixBits(seed + i));
    return sum;
  }

  /// What one path brings that begins there along `direction`: reflected light alone, lx. `first`: what it
  /// met.
  Color pathLight(const Meeting& begin, const Vec3& direction, Random& random,
                  std::optional<Meeting>& first) const {
    Color sum{}, weight{1, 1, 1};
    Vec3 origin = receiver(begin).position, along = direction;
    for (int bounce = 0;; ++bounce) {
      const std::optional<Meeting> at = meet(origin, along, false);
      if (bounce == 0) first = at;
      if (!at) return sum;
      const Color rho = reflectance(*at);
      const auto [one, chance] = likely(*at, random);  // stands for all
      const double light = directLightAt(tracer_, receiver(*at), luminaires_[one], 1, random.next()) / chance;
      double most = 0;
      for (int k = 0; k < 3; ++k) {
        weight[k] *= rho[k];
        sum[k] += weight[k] * light;
        most = std::max(most, weight[k]);
      }
      if (bounce >= kSureBounces) {
        if (most <= 0 || random.unit() >= most) return sum;
        for (double& w : weight) w /= most;
      }
      origin = receiver(*at).position;
      along = cosineDirection(Frame(at->normal), random.unit(), random.unit());
    }
  }

  std::uint32_t surfaceOf(const Meeting& at) const { return room_.patches.surface[at.patch]; }

 private:
  /// One of the luminaires, those that might give more light the more often, and how often.
  std::pair<std::size_t, double> likely(const Meeting& at, Random& random) const {
    constexpr double kAny = 0.1;  // of the choices are made blindly
    std::vector<double> chance(luminaires_.size());
    double sum = 0;
    for (std::size_t i = 0; i < chance.size(); ++i) {
      const Luminaire& l = luminaires_[i];
      const Vec3 d = l.position - at.point;
      const double squared = dot(d, d) + l.width * l.height;
      chance[i] =
          l.flux * std::max(0.0, -dot(d, l.normal)) * std::max(0.0, dot(d, at.normal)) / (squared * squared);
      sum += chance[i];
    }
    for (double& c : chance) c = (sum > 0 ? (1 - kAny) * c / sum : 0) + (sum > 0 ? kAny : 1) / chance.size();
    double left = random.unit();
    std::size_t i = 0;
    while (i + 1 < chance.size() && left >= chance[i]) left -= chance[i++];
    return {i, chance[i]};
  }

  PatchPoint receiver(const Meeting& at) const {
    return {at.point + tracer_.offset() * at.normal, at.normal, 1};
  }

  const Room& room_;
  const RayTracer& tracer_;
  ReflectanceMap colors_;
  const std::vector<Luminaire>& luminaires_;
};

/// Light of one pixel, at its middle.
class PixelLight {
 public:
  PixelLight(const PathTracer& tracer, const View& view)
      : tracer_(tracer), view_(view), sequence_(view.paths / 2) {}

  /// kFields numbers.
  void read(std::uint32_t column, std::uint32_t row, float* out) const {
    const std::uint64_t seed = mixBits(std::uint64_t{row} << 32 | column);
    const auto at = tracer_.meet(view_.position, view_.direction(column + 0.5, row + 0.5), true);
    if (!at) return;
    const Color albedo = meanAlbedo(column, row, *at);
    out[0] = static_cast<float>(tracer_.direct(*at, kSplit, seed));
    for (int k = 0; k < 3; ++k) out[7 + k] = static_cast<float>(albedo[k]);
    out[11] = static_cast<float>(tracer_.surfaceOf(*at));
    gather(*at, seed, out);
  }

 private:
  /// As a filtered texture has it: over the pixel, of the same surface.
  Color meanAlbedo(std::uint32_t column, std::uint32_t row, const Meeting& at) const {
    Color sum = tracer_.albedo(at);
    int count = 1;
    for (std::uint32_t i = 0; i < kTexels * kTexels; ++i) {
      const double x = column + (i % kTexels + 0.5) / kTexels, y = row + (i / kTexels + 0.5) / kTexels;
      const auto other = tracer_.meet(view_.position, view_.direction(x, y), true);
      if (!other || tracer_.surfaceOf(*other) != tracer_.surfaceOf(at)) continue;
      const Color color = tracer_.albedo(*other);
      for (int k = 0; k < 3; ++k) sum[k] += color[k];
      ++count;
    }
    for (double& c : sum) c /= count;
    return sum;
  }

  /// note: halves of one sequence fill each other's gaps; of two, they differ by chance.
  void gather(const Meeting& at, std::uint64_t seed, float* out) const {
    const Frame frame(at.normal);
    Random random(seed);
    double nearest = kNear;
    std::uint32_t near = 0;
    const std::uint32_t count = sequence_.count();
    Color half[2] = {};
    for (std::uint32_t i = 0; i < 2 * count; ++i) {
      const auto s = sequence_.point(i % count, RaySequence::scramble(mixBits(seed + i / count)));
      std::optional<Meeting> first;
      const Color light = tracer_.pathLight(at, cosineDirection(frame, s[0], s[1]), random, first);
      for (int k = 0; k < 3; ++k) half[i / count][k] += light[k];
      if (!first || first->distance >= kNear) continue;
      ++near;
      if (first->distance >= nearest) continue;
      nearest = first->distance;
      out[12] = static_cast<float>(tracer_.surfaceOf(*first));
    }
    for (int k = 0; k < 6; ++k) out[1 + k] = static_cast<float>(half[k / 3][k % 3] / count);
    out[10] = static_cast<float>(near) / static_cast<float>(2 * count);
  }

  const PathTracer& tracer_;
  const View& view_;
  RaySequence sequence_;
};

void trace(const std::string& source, const std::string& layout, const std::string& viewFile,
           const std::string& target) {
  TerminalProgress progress;
  const Host host = commandHost(source, 0, progress, false);
  const LayoutFile file = orThrow(readLayoutFile(layout));
  RoomOptions options;
  for (const LayoutEntry& entry : file.luminaires)
    if (entry.free) options.luminaires.push_back(*entry.free);
  const OpenedRoom opened = orThrow(source, openRoom(orThrow(modelAt(source)), options, host));
  const std::vector<Luminaire> luminaires = orThrow(freeLuminaires(file, opened.room.sites));
  progress.clear();

  const View view = viewOf(viewFile);
  const PathTracer tracer(opened, luminaires);
  const PixelLight pixels(tracer, view);
  const std::array<float, kFields> nothing{0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, -1, -1};
  std::vector<float> out;
  for (std::size_t i = 0; i < std::size_t{view.width} * view.height; ++i)
    out.insert(out.end(), nothing.begin(), nothing.end());
  parallelFor(view.height, 0, [&](std::size_t row) {
    for (std::uint32_t column = 0; column < view.width; ++column)
      pixels.read(column, static_cast<std::uint32_t>(row), &out[kFields * (row * view.width + column)]);
  });
  const auto* bytes = reinterpret_cast<const std::uint8_t*>(out.data());
  orThrow(replaceFile(target, std::vector<std::uint8_t>(bytes, bytes + out.size() * sizeof(float))));

  nlohmann::ordered_json names = nlohmann::ordered_json::array();
  for (const Surface& surface : opened.room.surfaces) names.push_back(surface.name);
  std::printf("%s\n", nlohmann::ordered_json{{"surfaces", names}}.dump().c_str());
}

}  // namespace
}  // namespace fiatlux

int main(int argc, char** argv) try {
  if (argc != 5) throw fiatlux::CommandError("path_trace ROOM.glb LAYOUT.json VIEW.json OUT");
  fiatlux::trace(argv[1], argv[2], argv[3], argv[4]);
  return 0;
} catch (const std::exception& error) {
  std::fprintf(stderr, "%s\n", error.what());
  return 2;
}
