// What kernels and clusters cost in truth, against form factors by rays alone, patch by patch, which know
// neither: rays_bench ROOM.glb [patch in m] [rays a patch] [cluster]. Both solve the same direct light of
// eight single luminaires to the end. Prints the row of docs/transport.md: over surfaces and luminaires, the
// mean and the root mean square of the relative differences of mean illuminance, and the noise of the rays.
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <string>
#include <vector>

#include "precompute/base/error.h"
#include "precompute/files/command_host.h"
#include "precompute/files/files_on_disk.h"
#include "precompute/files/source_file.h"
#include "precompute/files/terminal.h"
#include "precompute/light/cast_light.h"
#include "precompute/pipeline/pipeline.h"

namespace fiatlux {
namespace {

constexpr std::uint32_t kSources = 8;
constexpr int kBounces = 40;

/// Direct light of luminaires on evenly chosen sites, rows x kSources, row-major.
std::vector<float> directOf(const OpenedRoom& opened) {
  const std::vector<Luminaire> all = siteLuminaires(opened.room);
  std::vector<Luminaire> chosen;
  for (std::uint32_t i = 0; i < kSources; ++i)
    chosen.push_back(all[(2 * i + 1) * all.size() / (2 * kSources)]);
  const std::vector<float> columns = directLight(opened.room, opened.tracer, chosen, {});
  const std::size_t rows = opened.room.patches.rows();
  std::vector<float> direct(columns.size());
  for (std::size_t p = 0; p < rows; ++p)
    for (std::uint32_t i = 0; i < kSources; ++i) direct[p * kSources + i] = columns[i * rows + p];
  return direct;
}

/// Mean illuminance of each surface by each luminaire.
std::vector<double> meansOf(const Room& room, const FormFactors& factors, const std::vector<float>& direct) {
  const Patches& patches = room.patches;
  std::vector<float> light = direct, exitance(std::size_t{patches.count} * kSources), reflected(light.size());
  for (int bounce = 0; bounce < kBounces; ++bounce) {
    for (std::size_t i = 0; i < exitance.size(); ++i)
      exitance[i] = light[i] * static_cast<float>(patches.reflectance[i / kSources]);
    irradiance(factors, exitance.data(), kSources, reflected.data());
    for (std::size_t i = 0; i < light.size(); ++i) light[i] = direct[i] + reflected[i];
  }
  std::vector<double> means(room.surfaces.size() * kSources), area(room.surfaces.size());
  for (std::size_t p = 0; p < patches.rows(); ++p) {
    area[patches.surface[p]] += patches.area[p];
    for (std::uint32_t i = 0; i < kSources; ++i)
      means[patches.surface[p] * kSources + i] += patches.area[p] * light[p * kSources + i];
  }
  for (std::size_t i = 0; i < means.size(); ++i) means[i] /= area[i / kSources];
  return means;
}

struct Difference {
  double mean = 0, rms = 0;  // %
};

Difference differenceOf(const std::vector<double>& means, const std::vector<double>& truth) {
  double sum = 0, squares = 0;
  for (std::size_t i = 0; i < means.size(); ++i) {
    const double error = means[i] / truth[i] - 1;
    sum += error;
    squares += error * error;
  }
  const auto count = static_cast<double>(means.size());
  return {100 * sum / count, 100 * std::sqrt(squares / count)};
}

void measure(const std::string& model, const RoomOptions& options, std::uint32_t rays) {
  TerminalProgress progress;
  const OpenedRoom opened =
      orThrow(openRoom(orThrow(modelAt(model)), options, commandHost(model, 0, progress, false)));
  if (opened.room.sites.size() < kSources) throw CommandError(model + " has fewer than 8 sites");
  const std::vector<float> direct = directOf(opened);
  const auto solved = [&](std::uint32_t count, bool plain, std::uint64_t seed) {
    return meansOf(opened.room, castFormFactors(opened.room, opened.tracer, {count, plain, seed, 0, {}}),
                   direct);
  };
  const std::vector<double> truth = solved(rays, true, 7);
  const Difference usual = differenceOf(solved(kUsualRays, false, 1), truth);
  const Difference noise = differenceOf(solved(rays, true, 8), truth);
  std::printf("| %s | %u | %+.2f | %.2f | %.2f |\n", model.substr(model.rfind('/') + 1).c_str(),
              opened.room.patches.rows(), usual.mean, usual.rms, noise.rms / std::sqrt(2));
}

}  // namespace
}  // namespace fiatlux

int main(int count, char** arguments) {
  if (count < 2) {
    std::fprintf(stderr, "rays_bench ROOM.glb [patch in m] [rays a patch] [cluster]\n");
    return 2;
  }
  try {
    fiatlux::RoomOptions options;
    if (count > 2) options.patch = std::atof(arguments[2]);
    options.cluster = count > 4 ? std::strtoul(arguments[4], nullptr, 10) : 4;
    const auto rays = static_cast<std::uint32_t>(count > 3 ? std::strtoul(arguments[3], nullptr, 10) : 4096);
    fiatlux::measure(arguments[1], options, rays);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "rays_bench: %s\n", error.what());
    return 1;
  }
}
