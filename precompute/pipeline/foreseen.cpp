#include "precompute/pipeline/foreseen.h"

#include <algorithm>
#include <cmath>

#include "core/base/short_number.h"

namespace fiatlux {
namespace {

constexpr double kPerRow = 8e-6;             // s, times the square of the triangles' logarithm
constexpr double kPerPair = 0.5e-6;          // s, of a row and a site, times that logarithm
constexpr double kPerPairAlone = 0.6e-6;     // s, whatever the model
constexpr double kLong = 180, kShort = 120;  // s: what is said beforehand, and what is offered instead

std::string minutes(double seconds) { return std::to_string(std::max(1L, std::lround(seconds / 60))); }

}  // namespace

double coreSeconds(double rows, double sites, double triangles, double rays) {
  const double depth = std::log2(std::max(2.0, triangles));
  return rows * kPerRow * depth * depth * rays / kUsualRays +
         rows * sites * (kPerPair * depth + kPerPairAlone);
}

std::string noteOfTime(const Room& room, std::uint32_t rays, unsigned threads) {
  const double work = coreSeconds(room.patches.rows(), static_cast<double>(room.sites.size()),
                                  static_cast<double>(room.triangles.size()), rays);
  const double seconds = work / std::max(1u, threads);
  if (seconds <= kLong) return "";
  const double patch = std::ceil(100 * room.patchSize * std::sqrt(seconds / kShort)) / 100;  // m
  return "this will take about " + minutes(seconds) + " minutes on " + std::to_string(threads) +
         (threads == 1 ? " core" : " cores") + ", and about " + minutes(kShort) + " with --patch " +
         shortNumber(patch);
}

}  // namespace fiatlux
