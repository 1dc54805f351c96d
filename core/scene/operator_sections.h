// A scene's light operator as sections of its file, which version 1 readers of old pass over. All or none:
//
//   siteVisibility[.1 ...]  bytes     visible shares, in blocks of sites (visibility_codec.h)
//   charts                  rows      the chart of a row
//   chartFrames             F x 8     u axis, v axis, edges of a cell (m), each to 12 bits
//   groups                  rows x 2  the group of a row; barriers to its left (1) and upper (2) neighbour
//   exchange                bytes     means between groups
//   exchangeRest            bytes     what their interpolation leaves over
// and, not in the oldest files, whose exchange does not tell its steps either:
//   chartAspects            rows      how much longer a row is along u than its cell (Charts::aspect)
//   surfaceExchange         bytes     means over surfaces (surface_exchange_codec.h)
// Bytes tell their steps and are coded by what lies beside them in the room (Encoding::kBeside); older ones
// (kStepped; kPlain in the oldest, and of shares) are those of older_operator_codec.h.
#pragma once

#include <string_view>
#include <vector>

#include "core/base/result.h"
#include "core/scene/checked_sections.h"
#include "core/scene/scene.h"
#include "core/scene/scene_file.h"

namespace fiatlux {

inline constexpr std::uint32_t kChartColumns = 8, kGroupColumns = 2;
inline constexpr std::uint64_t kMaxExchangeValues = 1ull << 24;         // groups x groups
inline constexpr std::uint64_t kMaxSurfaceExchangeValues = 1ull << 26;  // patches x surfaces

/// Whether a section is one of these.
bool isOperatorSection(std::string_view name);

/// Appends the sections of scene.lightOperator, which is there. An error where it is beyond what a file
/// holds.
Result<Done> encodeOperator(const Scene& scene, std::vector<PlainSection>& sections);

/// Fills scene.lightOperator where its sections were provided; the scene's patches and sites are checked.
/// Faults go to `in`.
void readOperator(CheckedSections& in, const SceneCounts& counts, Scene& scene);

}  // namespace fiatlux
