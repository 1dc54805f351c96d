// The small parts of a crowded model by the room that sees them: its floor, its ceiling, its walls, and
// things in it. A building of a thousand nodes has rooms that a person can name, though no wall is large in
// it.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "precompute/geometry/faces.h"
#include "precompute/geometry/spaces.h"

namespace fiatlux {

/// The name of those that no room is known of.
inline constexpr const char* kSmallThings = "small things";

class SmallParts {
 public:
  /// `source` must outlive it; nothing is looked at before a name is asked for.
  explicit SmallParts(const SourceScene& source) : source_(source) {}

  /// Of the side of a triangle: "storey 1/room 2/floor", without what there is but one of; "small things"
  /// where no room sees it.
  std::string nameOf(const WeldedMesh& mesh, const Face& face);

 private:
  struct OneRoom {
    std::string path;               // "": of a space that is no room
    double floor = 0, ceiling = 0;  // m, where most of them lie
    double area = 0;                // m2, of its plan
  };
  void findRooms();
  void measure(std::vector<OneRoom>& rooms) const;
  void nameRooms();
  std::vector<std::vector<std::uint32_t>> storeys() const;
  const OneRoom* roomBefore(const WeldedMesh& mesh, const Face& face, const Vec3& normal) const;

  const SourceScene& source_;
  bool isFound_ = false;
  std::optional<Spaces> spaces_;                                // none: they cannot be told
  std::vector<OneRoom> rooms_;                                  // by space
  std::map<std::uint32_t, std::pair<double, double>> heights_;  // m, from and to, by node
};

}  // namespace fiatlux
