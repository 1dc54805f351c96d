#include "precompute/light/part_kernels.h"

#include <cstddef>
#include <cstring>

#include "precompute/light/kernel.h"

namespace fiatlux {

PartKernels::PartKernels(const ClusterParts& clusters) : eights_((clusters.parts().size() + 7) / 8) {
  const std::vector<ClusterPart>& parts = clusters.parts();
  if (!parts.empty()) base_ = parts[0].center;
  for (std::size_t i = 0; i < parts.size(); ++i) {
    const auto [x, y, z] = inFloats(parts[i].center - base_);
    const auto [nx, ny, nz] = inFloats(parts[i].normal);
    const float column[kColumns]{x, y, z, nx, ny, nz, static_cast<float>(parts[i].area)};
    for (int c = 0; c < kColumns; ++c) eights_[i / 8].value[c][i % 8] = column[c];
  }
}

void PartKernels::at(const Vec3& position, const Vec3& normal, std::vector<float>& kernels) const {
  const auto [x, y, z] = inFloats(position - base_);
  const auto [nx, ny, nz] = inFloats(normal);
  const EightVectors leaving{all8(nx), all8(ny), all8(nz)};
  kernels.resize(eights_.size() * 8);
  for (std::size_t i = 0; i < eights_.size(); ++i) {
    const auto& of = eights_[i].value;
    const EightVectors d{load8(of[kX]) - x, load8(of[kY]) - y, load8(of[kZ]) - z},
        arriving{load8(of[kNormalX]), load8(of[kNormalY]), load8(of[kNormalZ])};
    const Float8 factor = load8(of[kArea]) * eightKernels(d, leaving, arriving);
    std::memcpy(&kernels[i * 8], &factor, sizeof factor);
  }
}

}  // namespace fiatlux
