#include "precompute/pipeline/draft.h"

#include <algorithm>
#include <cmath>

#include "precompute/pipeline/foreseen.h"

namespace fiatlux {
namespace {

constexpr double kOfPair = 0.1;  // of what a row and a site take in full: one ray where that has four or more
constexpr double kUsualTimes = 2.5, kMostTimes = 6;  // times as long are patches
constexpr double kLittle = 1.35;                     // s of work: where it would be more, they get longer
constexpr double kFewer = 1.6;  // rows fall with this power of their length: furniture keeps its faces

}  // namespace

double draftSeconds(double rows, double sites, double triangles) {
  return coreSeconds(rows, kOfPair * sites, triangles, kDraftRays);
}

double draftCoarseness(double rows, double sites, double triangles) {
  return std::clamp(std::pow(draftSeconds(rows, sites, triangles) / kLittle, 1 / kFewer), kUsualTimes,
                    kMostTimes);
}

}  // namespace fiatlux
