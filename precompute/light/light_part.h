// What was cast of some rows, as bytes that go from one worker to another of the same program.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "core/base/result.h"
#include "precompute/light/cast_form_factors.h"

namespace fiatlux {

/// Rows from `first` on, one after the other.
struct LightPart {
  std::uint32_t first = 0;
  std::vector<FormFactorRow> rows;
  std::vector<float> direct;  // lx per lm, column-major rows x sites
};

std::vector<std::uint8_t> encodeLightPart(const LightPart& part);

/// Of a room of so many clusters and sites; an error where the bytes are not of such a part.
Result<LightPart> decodeLightPart(std::span<const std::uint8_t> bytes, std::size_t clusters,
                                  std::size_t sites);

}  // namespace fiatlux
