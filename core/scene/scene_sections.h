// What lies in a scene file of version 2: the sections' names, shapes and units, for the writer and the
// reader alike. With n patches, r receivers, rows = n + r, k clusters, m sites, c columns, S surfaces:
//
//   surfaceNames            bytes     UTF-8, a zero after each
//   surfaces                S x 5     area (m2), reflectance, share of lost rays, measuring (0 or 1),
//                                     error bound
//   planeBorders            S x 1     m, of measuring planes (Surface::border); not there where all are 0
//   patchCenters            rows x 3  kPositionUnit metres
//   patchNormals            rows x 3  kDirectionUnit
//   patchAreas              rows      m2
//   patchReflectances       rows
//   patchSurfaces           rows
//   patchClusters           n
//   patchNeighbours         rows x 2  how many rows before is the left, the upper neighbour; 0 = none
//   sites                   m x 10    position, normal, axis, size (m)
//   responseScales          c x 2S    step and floor on each surface, lx per lm
//   responseReferences      c x 2     how many columns before are the two that it is predicted from; 0 = none
//   responses[.1 ...]       bytes     quantised columns, in blocks (response_codec.h)
//   responseOffsets         m + 1     site j is the sum of weight x column over its entries
//                                     [offset j, offset j + 1)
//   responseColumns         entries   the column of an entry
//   responseWeights         entries   its weight
//   illuminanceStatistics[.s]         a section a surface: means (lx per lm) and covariance, as corrections
//                                     to those of the stored responses (statistics_codec.h)
//   exitanceStatistics[.s]            only of surfaces with more than one reflectance (lm/m2 per lm)
// or, in files of version 1 and where deriving them would take long (rows x m x m over kMaxDerivedProducts):
//   illuminanceMeans        S x m     lx per lm
//   exitanceMeans           S x m     lm/m2 per lm; zeros where one reflectance gives them from the
//                                     illuminance
//   illuminanceCovariance[.s]         a section a surface (covariance_codec.h)
//   exitanceCovariance[.s]            only of surfaces with more than one reflectance
// Version 1 had no responseReferences: its responses are those of response_streams.h.
// and, where a layout was chosen to be seen first (opening_light.h):
//   openingLayout           N + 1 x 2 dimming and 0; then site and flux (lm) of each luminaire
//   openingScales           S x 2     step and floor of its light, lx
//   openingLight            bytes     its light, quantised
// and, where other photometries are to be lit with, the light operator (operator_sections.h);
// and, not needed to light the scene: `room` (a .glb), `provenance` (JSON), and the paper's matrices.
//
// A reader takes them in any order. A writer puts first what is seen first, for a file is opened as it
// arrives: surfaces to sites, opening, room and provenance; then responses, statistics and the operator or,
// where the room opens with luminaires of photometric files, the operator, the responses and the statistics,
// which these luminaires do without.
#pragma once

#include <algorithm>
#include <cstdint>
#include <iterator>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/result.h"
#include "core/scene/scene.h"
#include "core/scene/scene_file.h"

namespace fiatlux {

inline constexpr double kPositionUnit = 0x1p-16;   // m: 0.015 mm; a room reaches 32 km
inline constexpr double kDirectionUnit = 0x1p-15;  // of a unit vector's component
inline constexpr std::uint32_t kSurfaceColumns = 5, kSiteColumns = 10;
inline constexpr double kCovarianceTolerance = 1e-6;

/// "covariance.12": sections that come in numbers carry them after a dot; the first block has none.
std::string numberedName(std::string_view name, std::uint32_t number);

/// What encoding did to the numbers, for the file's own report.
struct EncodingReport {
  std::vector<float> responseRms;    // sites x surfaces: RMS error over the surface, as a share of its mean
  std::vector<std::uint32_t> ranks;  // per surface: rows of the factored covariance, 0 = packed;
                                     // none where covariances are derived
};

SceneCounts countsOf(const Scene& scene);

/// Whether the reader may be asked to derive statistics from the responses: it takes a second or so at most.
bool derivable(const SceneCounts& counts);

/// The sections that SceneReader needs, from a scene with unquantised responses and statistics (errorBound is
/// computed here). An error where the scene is beyond what a file holds.
Result<std::vector<PlainSection>> encodeScene(const Scene& scene, EncodingReport* report = nullptr);

/// Puts the light operator, if there is one, behind the sites and so before the responses: for rooms that
/// open with luminaires of photometric files, which need both, and no statistics.
void putOperatorFirst(std::vector<PlainSection>& sections);

/// Puts sections that are wanted early (the opening light, the picture, the provenance) behind the sites and
/// so before the responses. `Section` is a PlainSection or a StoredSection.
template <class Section>
void insertEarly(std::vector<Section>& sections, std::vector<Section> early) {
  const auto sites = std::find_if(sections.begin(), sections.end(),
                                  [](const Section& part) { return part.section.name == "sites"; });
  sections.insert(sites + 1, std::make_move_iterator(early.begin()), std::make_move_iterator(early.end()));
}

}  // namespace fiatlux
