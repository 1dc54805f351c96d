#include "precompute/rays/effort.h"

#include <algorithm>

namespace fiatlux {

std::vector<std::uint32_t> effortOfRows(const Patches& patches, bool isEven) {
  if (isEven) return std::vector<std::uint32_t>(patches.rows(), 1);
  std::vector<std::uint32_t> size;
  for (const std::uint32_t s : patches.surface) {
    size.resize(std::max<std::size_t>(size.size(), s + 1), 0);
    ++size[s];
  }
  // Surfaces of fewer than `enough` patches are made up for; halved until it costs no more than twice as
  // much.
  for (std::uint32_t enough = 512;; enough /= 2) {
    std::vector<std::uint32_t> effort;
    std::uint64_t total = 0;
    for (const std::uint32_t s : patches.surface) {
      effort.push_back(std::clamp(enough / size[s], 1u, kMostEffort));
      total += effort.back();
    }
    if (enough == 1 || total <= 2 * std::uint64_t{patches.rows()}) return effort;
  }
}

}  // namespace fiatlux
