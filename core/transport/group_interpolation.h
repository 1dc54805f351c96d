// Between groups and their rows: a value a group becomes a value a row by a local linear fit through the
// groups beside it on its surface, so that the mean over each group is what it was.
#pragma once

#include <cstdint>
#include <vector>

#include "core/scene/light_operator.h"
#include "core/scene/patches.h"

namespace fiatlux {

/// W, rows x groups. All matrices row-major with `width` columns.
class GroupInterpolation {
 public:
  /// `patches` and `groups` agree and are checked: labels in range, every group has a row.
  GroupInterpolation(const Patches& patches, const ExchangeGroups& groups);

  /// rows x width = W values; values: total x width.
  void apply(const float* values, std::uint32_t width, float* rows) const;
  /// rows += W values.
  void add(const float* values, std::uint32_t width, float* rows) const;
  /// total x width = W^T rows; `sums` (total x width) gets the plain sums over each group.
  void reduce(const float* rows, std::uint32_t width, float* sums, float* values) const;
  /// total x width: area-weighted means over the groups.
  void means(const float* rows, std::uint32_t width, float* means) const;
  /// Takes from lumens of patches what they have evenly over their groups, given the `sums` over these.
  void takeEven(const float* sums, std::uint32_t width, std::vector<float>& lumens) const;
  float shareOf(std::size_t row) const { return share_[row]; }

  const std::vector<double>& areas() const { return area_; }  // of the groups, m2

 private:
  struct Neighbour {
    std::uint32_t group;
    float u, v;  // what its difference adds to the gradient along the two tangents, 1/m
  };
  struct Tangents {
    Vec3 center, u, v;  // m; unit, in the group's mean plane
  };
  struct Link {
    std::uint32_t from, to;
    bool operator==(const Link&) const = default;
  };
  void measure(const Patches& patches);
  void place(const Patches& patches);
  void link(const Patches& patches, const ExchangeGroups& groups);
  void fit(std::uint32_t group, const Link* first, const Link* last);
  void gradients(const float* values, std::uint32_t width, std::vector<float>& u,
                 std::vector<float>& v) const;

  std::uint32_t total_;
  std::vector<std::uint32_t> group_;    // of each row
  std::vector<float> share_;            // of each row in its group's area
  std::vector<float> alongU_, alongV_;  // m, of each row from its group's centre
  std::vector<double> area_;            // of the groups
  std::vector<Tangents> tangents_;      // of the groups
  std::vector<std::uint32_t> offset_;   // total + 1, into the neighbours
  std::vector<Neighbour> neighbours_;
};

}  // namespace fiatlux
