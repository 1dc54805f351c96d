// Statistics of surfaces in words and numbers; see light_results.h.
#include "precompute/files/light_results.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <cstdio>
#include <limits>
#include <nlohmann/json.hpp>

#include "core/scene/zones.h"
#include "precompute/files/terminal.h"

namespace fiatlux {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

/// Mean, sigma, least and largest of weighted values that come one by one (Welford's updates: no
/// cancellation).
class WeightedMoments {
 public:
  void add(double area, double value) {
    area_ += area;
    const double deviation = value - mean_;
    mean_ += area / area_ * deviation;
    squares_ += area * deviation * (value - mean_);
    least_ = std::min(least_, value);
    largest_ = std::max(largest_, value);
  }
  ExplicitStatistics statistics() const {
    if (!(area_ > 0)) return {};
    return {mean_, std::sqrt(squares_ / area_), least_, largest_};
  }

 private:
  double area_ = 0, mean_ = 0, squares_ = 0, least_ = kInfinity, largest_ = -kInfinity;
};

/// Mean and sigma by the statistics; the extremes stay those of the patches.
void setMeanAndSigma(const SurfaceStatistics& statistics, const Layout& layout, ExplicitStatistics& result) {
  const MeanAndSigma light = meanAndSigmaOf(statistics, layout);
  result.mean = light.mean;
  result.sigma = light.sigma;
}

nlohmann::ordered_json statisticsJson(const ExplicitStatistics& s) {
  return {{"mean", s.mean}, {"sigma", s.sigma}, {"min", s.minimum}, {"max", s.maximum}};
}

std::string quotedForCsv(const std::string& name) {
  if (name.find_first_of(",\"\r\n") == std::string::npos) return name;
  std::string quoted = "\"";
  for (char c : name) quoted += c == '"' ? std::string("\"\"") : std::string(1, c);
  return quoted + "\"";
}

/// Characters of UTF-8 text, to align columns.
std::size_t widthOf(const std::string& text) {
  return static_cast<std::size_t>(
      std::count_if(text.begin(), text.end(), [](char c) { return (c & 0xc0) != 0x80; }));
}

}  // namespace

LightResults lightResults(const Patches& patches, const std::vector<Surface>& surfaces,
                          const std::vector<float>& light) {
  assert(light.size() == patches.rows());
  std::vector<WeightedMoments> lit(surfaces.size()), reflected(surfaces.size());
  WeightedMoments litAll, reflectedAll;
  LightResults results;
  for (std::uint32_t p = 0; p < patches.rows(); ++p) {
    const std::uint32_t s = patches.surface[p];
    if (!patches.counts(p)) continue;
    const double exitance = double{patches.reflectance[p]} * light[p];
    lit[s].add(patches.area[p], light[p]);
    if (surfaces[s].measuring) continue;
    reflected[s].add(patches.area[p], exitance);
    litAll.add(patches.area[p], light[p]);
    reflectedAll.add(patches.area[p], exitance);
    results.all.reflectance += patches.area[p] * patches.reflectance[p];
  }
  for (std::size_t s = 0; s < surfaces.size(); ++s) {
    const Surface& surface = surfaces[s];
    results.surfaces.push_back({surface.name, surface.area, surface.patches, surface.reflectance,
                                surface.measuring, lit[s].statistics(), reflected[s].statistics()});
    if (surface.measuring) continue;
    results.all.area += surface.area;
    results.all.patches += surface.patches;
  }
  results.all.name = "all";
  if (results.all.area > 0) results.all.reflectance /= results.all.area;
  results.all.illuminance = litAll.statistics();
  results.all.exitance = reflectedAll.statistics();
  return results;
}

LightResults lightResults(const Scene& scene, const std::vector<float>& light) {
  const std::uint32_t first = firstZone(scene);
  LightResults results =
      lightResults(scene.patches, {scene.surfaces.begin(), scene.surfaces.begin() + first}, light);
  for (std::size_t z = 0; z < scene.zones.size(); ++z) {
    const Surface& surface = scene.surfaces[first + z];
    WeightedMoments lit;
    for (const std::uint32_t p : scene.zones[z].rows) lit.add(scene.patches.area[p], light[p]);
    results.surfaces.push_back(
        {surface.name, surface.area, surface.patches, surface.reflectance, true, lit.statistics(), {}});
  }
  return results;
}

LightResults lightResults(const Scene& scene, const Layout& layout) {
  LightResults results = lightResults(scene, illuminanceOf(scene, layout));
  for (std::size_t s = 0; s < scene.surfaces.size(); ++s) {
    setMeanAndSigma(scene.illuminance[s], layout, results.surfaces[s].illuminance);
    if (!scene.surfaces[s].measuring)
      setMeanAndSigma(scene.exitance[s], layout, results.surfaces[s].exitance);
  }
  setMeanAndSigma(unionStatistics(scene, Quantity::kIlluminance, {}), layout, results.all.illuminance);
  setMeanAndSigma(unionStatistics(scene, Quantity::kExitance, {}), layout, results.all.exitance);
  return results;
}

nlohmann::ordered_json gridsJson(const std::vector<Surface>& surfaces,
                                 const std::vector<GridReading>& grids) {
  nlohmann::ordered_json json = nlohmann::ordered_json::array();
  for (const GridReading& grid : grids)
    json.push_back({{"surface", surfaces[grid.surface].name},
                    {"points", grid.points},
                    {"spacing", grid.spacing},
                    {"rim", grid.rim},
                    {"mean", grid.mean},
                    {"min", grid.least},
                    {"max", grid.most},
                    {"uniformity", grid.uniformity()}});
  return json;
}

std::string gridLines(const std::vector<Surface>& surfaces, const std::vector<GridReading>& grids) {
  std::string lines;
  for (const GridReading& grid : grids) {
    char numbers[160];
    std::snprintf(numbers, sizeof numbers,
                  ": %u points, spacing at most %.2f m, rim %.2f m: E_m %.4g lx, E_min %.4g lx, U_o %.3f\n",
                  grid.points, grid.spacing, grid.rim, grid.mean, grid.least, grid.uniformity());
    lines += "grid on " + printable(surfaces[grid.surface].name) + numbers;
  }
  return lines;
}

nlohmann::ordered_json surfaceJson(const SurfaceResult& result) {
  nlohmann::ordered_json json = {{"name", result.name}, {"area", result.area}, {"patches", result.patches}};
  json.update(statisticsJson(result.illuminance));
  json["uniformity"] =
      result.illuminance.mean > 0 ? result.illuminance.minimum / result.illuminance.mean : 0.0;
  json["reflectance"] = result.reflectance;
  if (result.measuring)
    json["measuring"] = true;
  else
    json["exitance"] = statisticsJson(result.exitance);
  return json;
}

nlohmann::ordered_json surfacesJson(const LightResults& results) {
  nlohmann::ordered_json list = nlohmann::ordered_json::array();
  for (const SurfaceResult& result : results.surfaces) list.push_back(surfaceJson(result));
  return list;
}

std::string surfacesTable(const LightResults& results) {
  std::vector<SurfaceResult> rows = results.surfaces;
  rows.push_back(results.all);
  std::size_t width = 8;
  for (SurfaceResult& row : rows) {
    row.name = printable(row.name, 60);
    width = std::max(width, widthOf(row.name));
  }
  std::string table = "surface" + std::string(width - 7, ' ') +
                      "     area   mean lx     sigma       min       max   U_o  exitance lm/m2\n";
  for (const SurfaceResult& row : rows) {
    char line[160];
    const ExplicitStatistics& e = row.illuminance;
    std::snprintf(line, sizeof line, " %8.2f %9.4g %9.4g %9.4g %9.4g %5.2f", row.area, e.mean, e.sigma,
                  e.minimum, e.maximum, e.mean > 0 ? e.minimum / e.mean : 0.0);
    table += row.name + std::string(width - widthOf(row.name), ' ') + line;
    if (!row.measuring) {
      std::snprintf(line, sizeof line, " %9.4g", row.exitance.mean);
      table += line;
    }
    table += '\n';
  }
  return table;
}

std::string patchesCsv(const Patches& patches, const std::vector<Surface>& surfaces,
                       const std::vector<float>& light) {
  assert(light.size() == patches.rows());
  std::string csv = "surface,x,y,z,nx,ny,nz,area,reflectance,illuminance,exitance\n";
  std::vector<std::string> names;
  for (const Surface& surface : surfaces) names.push_back(quotedForCsv(surface.name));
  for (std::uint32_t p = 0; p < patches.rows(); ++p) {
    char line[256];
    const Vec3 &c = patches.center[p], &n = patches.normal[p];
    std::snprintf(line, sizeof line, ",%.6g,%.6g,%.6g,%.6g,%.6g,%.6g,%.9g,%.6g,%.7g,%.7g\n", c.x, c.y, c.z,
                  n.x, n.y, n.z, patches.area[p], double{patches.reflectance[p]}, double{light[p]},
                  double{patches.reflectance[p]} * light[p]);
    csv += names[patches.surface[p]] + line;
  }
  return csv;
}

}  // namespace fiatlux
