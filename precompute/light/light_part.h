// What was cast of some rows, and what was solved of it, as bytes that go from one worker to another of the
// same program.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "core/base/result.h"
#include "precompute/light/cast_form_factors.h"
#include "precompute/light/interreflection.h"

namespace fiatlux {

/// Rows from `first` on, one after the other.
struct LightPart {
  std::uint32_t first = 0;
  std::vector<FormFactorRow> rows;
  std::vector<float> direct;          // lx per lm, column-major rows x sites
  std::vector<std::uint8_t> visible;  // SiteVisibility::steps, like `direct`; or empty
};

std::vector<std::uint8_t> encodeLightPart(const LightPart& part);

/// Of a room of so many clusters and sites, with what is visible or without; an error where the bytes are not
/// of such a part.
Result<LightPart> decodeLightPart(std::span<const std::uint8_t> bytes, std::size_t clusters,
                                  std::size_t sites, bool isVisible);

/// A block of interreflection.h and its number.
struct SolvedPart {
  std::uint32_t block = 0;
  SolvedBlock solved;
};

std::vector<std::uint8_t> encodeSolvedPart(const SolvedPart& part);
/// An error where the bytes end too early or too late; whether the room has such a block is not asked.
Result<SolvedPart> decodeSolvedPart(std::span<const std::uint8_t> bytes);

}  // namespace fiatlux
