// photometry_bench ROOM.glb ROOM.flux [single layouts] [sums of six]: light by the scene file's operator
// against the whole solution in the room, for four types of luminaires. What `fiatlux evaluate` and `fiatlux
// light` do, with the form factors cast once for all layouts. Prints one JSON array: for each type the
// relative errors of means and sigmas, per surface; of means also what is the stored direct light's, and
// what is left where direct light is true.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <nlohmann/json.hpp>
#include <numbers>
#include <string>

#include "core/base/random.h"
#include "core/candidates/mount_area.h"
#include "core/transport/candidate_fit.h"
#include "core/transport/low_rank_radiosity.h"
#include "core/transport/photometric_light.h"
#include "core/transport/site_responses.h"
#include "precompute/base/error.h"
#include "precompute/files/command_host.h"
#include "precompute/files/files_on_disk.h"
#include "precompute/files/scene_io.h"
#include "precompute/files/source_file.h"
#include "precompute/files/terminal.h"
#include "precompute/light/cast_form_factors.h"
#include "precompute/light/direct_light.h"
#include "precompute/pipeline/pipeline.h"

namespace fiatlux {
namespace {

using Json = nlohmann::ordered_json;

constexpr double kLit = 0.05;  // of the room's mean: dimmer surfaces do not count
constexpr double kTolerance = 1e-6;
constexpr std::uint32_t kMostSteps = 50, kLuminaires = 6;

struct Type {
  const char* name;
  Intensity intensity;
  double beam, size, tilt;  // degrees, m, degrees
};

std::vector<Type> types() {
  const auto power = [](int exponent) {
    return [exponent](const Vec3& d) { return d.z > 0 ? 1000 * std::pow(d.z, exponent) : 0.0; };
  };
  const auto batwing = [](const Vec3& d) { return d.z > 0 ? 300 * d.z * (1 + 2 * (1 - d.z * d.z)) : 0.0; };
  return {{"batwing", batwing, 100, 0.6, 0},
          {"cos^4, 60 degrees", power(4), 65, 0.2, 0},
          {"cos^20, 30 degrees", power(20), 30, 0.1, 0},
          {"cos^126, 12 degrees, tilted 30", power(126), 12, 0.1, 30}};
}

/// On a site, whether it fits there or not; tilted ones lean to one of four sides.
PhotometricCandidate anyCandidate(const Scene& scene, const Type& type, Random& random) {
  const std::uint32_t j = random.below(static_cast<std::uint32_t>(scene.sites.size()));
  const Site& site = scene.sites[j];
  Luminaire l = luminaireOf(site);
  l.distribution = Luminaire::Distribution::kPhotometric;
  l.width = l.height = type.size;
  l.intensity = type.intensity;
  const double degree = std::numbers::pi / 180;
  l.beam = type.beam * degree;
  if (type.tilt > 0) {
    const double side = 90 * degree * random.below(4), tilt = type.tilt * degree;
    const Vec3 across = cross(site.normal, site.axis);
    const Vec3 lean = std::cos(side) * site.axis + std::sin(side) * across;
    l.normal = normalized(std::cos(tilt) * site.normal + std::sin(tilt) * lean);
    l.axis = normalized(cross(l.normal, cross(site.normal, lean)));
  }
  l.position = mountedPosition(site, l.normal, l.axis, l.width, l.height);
  return {j, l};
}

/// What a search could be offered, as candidatesOf() has it: nothing over its mount's edge or through a wall.
class Offer {
 public:
  explicit Offer(const Scene& scene) : scene_(scene), mount_(scene.sites), fit_(scene) {}

  PhotometricCandidate candidate(const Type& type, Random& random) const {
    for (;;) {
      PhotometricCandidate drawn = anyCandidate(scene_, type, random);
      if (mount_.holds(drawn.site, drawn.luminaire) && fit_.fits(drawn.luminaire, 0)) return drawn;
    }
  }

 private:
  const Scene& scene_;
  MountArea mount_;
  CandidateFit fit_;
};

/// Layouts of one candidate, then of six.
std::vector<std::vector<PhotometricCandidate>> layoutsOf(const Scene& scene, const Type& type,
                                                         std::uint32_t singles, std::uint32_t sums) {
  Random random(1);
  const Offer offer(scene);
  std::vector<std::vector<PhotometricCandidate>> layouts(singles + sums);
  for (std::uint32_t i = 0; i < layouts.size(); ++i)
    for (std::uint32_t k = 0; k < (i < singles ? 1 : kLuminaires); ++k)
      layouts[i].push_back(offer.candidate(type, random));
  return layouts;
}

/// The sum of some columns of `rows` values each.
std::vector<float> sumOf(const std::vector<float>& columns, std::size_t rows) {
  std::vector<float> sum(rows, 0.0f);
  for (std::size_t i = 0; i < columns.size(); ++i) sum[i % rows] += columns[i];
  return sum;
}

/// Light as in `fiatlux light`, for a room whose form factors are known.
class WholeSolution {
 public:
  WholeSolution(const Room& room, const RayTracer& tracer)
      : room_(room),
        tracer_(tracer),
        factors_(castFormFactors(room, tracer, {})),
        lowRank_(orThrow(LowRankRadiosity::factorize(factors_, room.patches))) {}

  /// A column each.
  std::vector<float> direct(const std::vector<PhotometricCandidate>& layout) const {
    std::vector<Luminaire> luminaires;
    for (const PhotometricCandidate& candidate : layout) luminaires.push_back(candidate.luminaire);
    DirectLightOptions options;
    options.split = 4;
    return directLight(room_, tracer_, luminaires, options);
  }

  /// Of direct light.
  std::vector<float> light(const std::vector<float>& direct) const {
    ResponseBlock block;
    block.width = 1;
    block.direct = direct;
    solveResponses(factors_, room_.patches, lowRank_, kMostSteps, kTolerance, block);
    return block.irradiance;
  }

 private:
  const Room& room_;
  const RayTracer& tracer_;
  FormFactors factors_;
  LowRankRadiosity lowRank_;
};

/// One layout's light: the whole solution, what the scene file's operator makes of it, and this of true
/// direct light; with the direct light of both.
struct Light {
  std::vector<float> whole, exchanged, spread, direct, stored;
};

Light lightOf(const WholeSolution& whole, const PhotometricLight& exchange,
              const std::vector<PhotometricCandidate>& layout, std::size_t rows) {
  const std::vector<float> direct = whole.direct(layout), stored = exchange.direct(layout);
  Light light;
  light.direct = sumOf(direct, rows), light.stored = sumOf(stored, rows);
  light.whole = whole.light(light.direct);
  light.exchanged = sumOf(exchange.total(layout, stored), rows);
  light.spread = sumOf(exchange.total(layout, direct), rows);
  return light;
}

Json errorsOf(const Scene& scene, const Light& light) {
  Json json = Json::array();
  const auto& [whole, exchanged, spread, direct, stored] = light;
  const double least = kLit * explicitStatistics(scene, whole, {}).mean;
  for (std::uint32_t s = 0; s < scene.surfaces.size(); ++s) {
    const ExplicitStatistics a = explicitStatistics(scene, whole, {s}),
                             b = explicitStatistics(scene, exchanged, {s});
    if (a.mean < least) continue;
    const auto meanOf = [&](const std::vector<float>& of) { return explicitStatistics(scene, of, {s}).mean; };
    json.push_back({{"surface", scene.surfaces[s].name},
                    {"mean", std::abs(b.mean - a.mean) / a.mean},
                    {"direct", std::abs(meanOf(stored) - meanOf(direct)) / a.mean},
                    {"exchange", std::abs(meanOf(spread) - a.mean) / a.mean},
                    {"sigma", a.sigma > 0 ? std::abs(b.sigma - a.sigma) / a.sigma : 0}});
  }
  return json;
}

/// As the scene file says that its room was made.
RoomOptions optionsOf(const std::string& path) {
  const std::vector<std::uint8_t> file = orThrow(readFileBytes(path));
  const SceneTable table = orThrow(readSceneTable(file));
  const std::vector<std::uint8_t> bytes = orThrow(inflateSection(file, *table.find("provenance")));
  const Json options = Json::parse(bytes.begin(), bytes.end()).at("options");
  RoomOptions room;
  room.patch = options.at("patch");
  room.siteSpacing = options.at("siteSpacing");
  room.siteSize = options.at("siteSize");
  room.cluster = options.at("cluster");
  return room;
}

Json measure(const std::string& model, const std::string& file, std::uint32_t singles, std::uint32_t sums) {
  const Scene scene = orThrow(readSceneFile(file));
  if (!scene.lightOperator) throw CommandError(file + " has no light operator");
  TerminalProgress progress;
  const OpenedRoom opened =
      orThrow(openRoom(orThrow(modelAt(model)), optionsOf(file), commandHost(model, 0, progress, false)));
  if (opened.room.patches.rows() != scene.patches.rows()) throw CommandError(file + " is of another room");
  const WholeSolution whole(opened.room, opened.tracer);
  const PhotometricLight exchange(scene);
  Json json = Json::array();
  for (const Type& type : types()) {
    Json errors = Json::array();
    for (const auto& layout : layoutsOf(scene, type, singles, sums)) {
      const Light light = lightOf(whole, exchange, layout, scene.patches.rows());
      for (Json& error : errorsOf(scene, light)) errors.push_back(std::move(error));
    }
    json.push_back({{"type", type.name}, {"errors", std::move(errors)}});
  }
  return json;
}

}  // namespace
}  // namespace fiatlux

int main(int count, char** arguments) {
  if (count < 3) {
    std::fprintf(stderr, "photometry_bench ROOM.glb ROOM.flux [single layouts] [sums of six]\n");
    return 2;
  }
  const auto number = [&](int i, unsigned long fallback) {
    return static_cast<std::uint32_t>(count > i ? std::strtoul(arguments[i], nullptr, 10) : fallback);
  };
  try {
    std::puts(fiatlux::measure(arguments[1], arguments[2], number(3, 12), number(4, 24)).dump().c_str());
  } catch (const std::exception& error) {
    std::fprintf(stderr, "photometry_bench: %s\n", error.what());
    return 1;
  }
}
