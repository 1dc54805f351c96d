#include "precompute/light/part_kernels.h"

#include <cstddef>
#include <numbers>

#include "precompute/rays/float8.h"

namespace fiatlux {

PartKernels::PartKernels(const ClusterParts& clusters) : eights_((clusters.parts().size() + 7) / 8) {
  const std::vector<ClusterPart>& parts = clusters.parts();
  if (!parts.empty()) base_ = parts[0].center;
  for (std::size_t i = 0; i < parts.size(); ++i) {
    const Vec3 center = parts[i].center - base_, &normal = parts[i].normal;
    const double column[kColumns]{
        center.x, center.y, center.z, normal.x, normal.y, normal.z, parts[i].area / std::numbers::pi};
    for (int c = 0; c < kColumns; ++c) eights_[i / 8].value[c][i % 8] = static_cast<float>(column[c]);
  }
}

void PartKernels::at(const Vec3& position, const Vec3& normal, std::vector<float>& kernels) const {
  const Vec3 local = position - base_;
  const auto x = static_cast<float>(local.x), y = static_cast<float>(local.y),
             z = static_cast<float>(local.z);
  const auto nx = static_cast<float>(normal.x), ny = static_cast<float>(normal.y),
             nz = static_cast<float>(normal.z);
  kernels.resize(eights_.size() * 8);
  for (std::size_t i = 0; i < eights_.size(); ++i) {
    const auto& of = eights_[i].value;
    const Float8 dx = load8(of[kX]) - x, dy = load8(of[kY]) - y, dz = load8(of[kZ]) - z;
    const Float8 out = dx * nx + dy * ny + dz * nz;
    const Float8 in = -(dx * load8(of[kNormalX]) + dy * load8(of[kNormalY]) + dz * load8(of[kNormalZ]));
    const Float8 squared = dx * dx + dy * dy + dz * dz;
    const Float8 kernel = max8(out, all8(0)) * max8(in, all8(0)) * load8(of[kArea]) / (squared * squared);
    std::memcpy(&kernels[i * 8], &kernel, sizeof kernel);
  }
}

}  // namespace fiatlux
