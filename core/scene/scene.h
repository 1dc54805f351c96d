// A scene, ready to be lit: what a .flux file holds once it is read and checked (scene_file.h), on both
// sides. Everything the evaluator and the search need, and nothing of how it was computed.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "core/scene/layout.h"
#include "core/scene/light_operator.h"
#include "core/scene/observer.h"
#include "core/scene/patches.h"

namespace fiatlux {

/// Statistics of one leaf surface's responses: mu = a x and sigma^2 = x^T C x for site fluxes x (lm).
struct SurfaceStatistics {
  std::vector<double> mean;        // a_s, m entries: lx (or lm/m2) per lm, paper (8)
  std::vector<double> covariance;  // C_s, m x m, row-major, symmetric, paper (11); {}: not made
};

/// Light of every patch for each site at 1 lm. Column j holds rows() values: illuminance in lx per lm, direct
/// light and all interreflections; exitance (reflected, lm/m2) is reflectance times that.
struct Responses {
  std::uint32_t rows = 0, sites = 0;
  std::vector<float> illuminance;  // column-major rows x sites
  const float* column(std::uint32_t site) const { return illuminance.data() + std::size_t{site} * rows; }
};

/// Part of a leaf surface that is a surface of its own (zones.h).
struct Zone {
  std::string name;
  std::uint32_t leaf = 0;           // surface of the file that it is part of
  std::vector<std::uint32_t> rows;  // of that leaf, ascending
};

inline bool operator==(const Zone& a, const Zone& b) {
  return a.name == b.name && a.leaf == b.leaf && a.rows == b.rows;
}

/// What a luminaire takes of its mount, laid flat on it: a rectangle around the middle; of no size where a
/// half is 0.
struct Body {
  Vec3 along;                              // unit
  double halfLength = 0, halfBreadth = 0;  // m, along and across it
};

/// One way to hang a luminaire in a room, where the sites of a scene are such ways (core/candidates).
struct Hanging {
  std::uint32_t place = 0;  // site of the room: those of one place exclude each other
  std::uint32_t type = 0;   // of luminaire
  std::uint32_t way = 0;    // type, turn and aim: the same number on every place
  double power = 1;         // W of the luminaire at a flux of 1
  Body body = {};
};

/// Light of every patch for each site at 1 lm before anything reflects it.
struct DirectLight {
  Responses responses;                        // lx per lm
  std::vector<SurfaceStatistics> statistics;  // per leaf surface, mean rows alone
};

/// Light of each site at 1 lm at the points of a measuring plane's EN 12464-1 grid: points x sites, lx per
/// lm.
struct PlaneLight {
  std::uint32_t surface = 0;
  Responses horizontal, cylindrical;  // on the plane; the mean of the vertical planes of all directions
  struct Vertical {
    Vec3 direction;  // unit, level: that the vertical plane faces
    Responses light;
  };
  std::vector<Vertical> verticals;
};

struct Scene {
  std::string identity;  // 16 hex digits: source, options that change the light, version of the method
  Patches patches;
  std::vector<Surface> surfaces;
  std::vector<Site> sites;
  std::vector<Hanging> hangings;  // of each site; none: they hold squares of light, and power is lm
  Responses responses;
  std::vector<float> errorBound;  // per surface, the largest |stored - true| of illuminance, as a share of
                                  // the surface's mean response to that site; guards true minima and maxima
  std::vector<SurfaceStatistics> illuminance;  // per leaf surface
  std::vector<SurfaceStatistics> exitance;     // per leaf surface; empty for measuring planes
  std::vector<Zone> zones;                     // of no file: the last of the surfaces (zones.h)
  std::optional<LightOperator> lightOperator;  // what other photometries need; older files have none
  std::vector<ObserverRows>
      observers;  // of no file: of those whose glare is asked for (core/transport/room_view.h)
  std::vector<PlaneLight> planes;     // of no file: made where it is asked for (core/transport/plane_light.h)
  std::optional<DirectLight> direct;  // of no file: made where it is asked for (core/transport/direct_part.h)
};

/// What a quantity is read from; exitance is reflectance times these. Precondition of kDirect: it is there.
const Responses& responsesOf(const Scene& scene, Quantity quantity);
const std::vector<SurfaceStatistics>& leafStatistics(const Scene& scene, Quantity quantity);

/// Mean rows of responses over the patches that count, per leaf surface; of exitance, of rho times them.
std::vector<SurfaceStatistics> meanRows(const Patches& patches, std::size_t surfaces,
                                        const Responses& responses, Quantity quantity);

/// What a luminaire of flux 1 draws on a site: W of its type, or lm where there are no types.
inline double powerAt(const Scene& scene, std::uint32_t site) {
  return scene.hangings.empty() ? 1 : scene.hangings[site].power;
}

/// The rows that a surface set is made of and that count, ascending; a row that two of its zones share is
/// there twice.
std::vector<std::uint32_t> rowsOf(const Scene& scene, const SurfaceSet& surfaces);

/// Statistics of a union of disjoint leaves by their areas: w_i = A_i / A, a = sum w_i a_i,
/// C = sum w_i (C_i + a_i a_i^T) - a a^T, or of responses. `surfaces` empty: all that are no measuring
/// planes.
SurfaceStatistics unionStatistics(const Scene& scene, Quantity quantity, const SurfaceSet& surfaces);

/// Mean and sigma of the light on a surface set, in the unit of its statistics.
struct MeanAndSigma {
  double mean = 0, sigma = 0;
};

/// mu = a x and sigma^2 = x^T C x of a layout, its dimming included; paper (8), (10).
MeanAndSigma meanAndSigmaOf(const SurfaceStatistics& statistics, const Layout& layout);

/// Illuminance of every row (patches, then receivers) for a layout, lx: sum over luminaires of t flux g_j. Of
/// kDirect that which nothing has reflected, else all of it.
std::vector<float> illuminanceOf(const Scene& scene, const Layout& layout,
                                 Quantity quantity = Quantity::kIlluminance);

/// Statistics of a surface set read off explicit values, one per row: area-weighted mean and sigma, least,
/// largest.
struct ExplicitStatistics {
  double mean = 0, sigma = 0, minimum = 0, maximum = 0;
};
ExplicitStatistics explicitStatistics(const Scene& scene, const std::vector<float>& values,
                                      const SurfaceSet& surfaces);

}  // namespace fiatlux
