// What observers see of a room and its luminaires: what glares at them, and before which background
// (core/scene/observer.h). Where patches are known, tiles of theirs stand in the way of sight; the background
// is what a few thousand lines of sight meet.
#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <memory>
#include <vector>

#include "core/base/result.h"
#include "core/scene/luminaire.h"
#include "core/scene/scene.h"
#include "core/transport/tile_tree.h"

namespace fiatlux {

/// Whether glare can be told of a luminaire: it is no point.
bool hasLuminousArea(const Luminaire& luminaire);
/// An Error that names the first of a layout which is one.
Result<Done> checkLuminousAreas(const std::vector<Luminaire>& luminaires);

/// 0.25 L^2 w / p^2 of a luminaire at its flux that nothing hides, cd2/m4; 0 of what lies outside CIE's table
/// of the position index, and of one without luminous area. As seen from its centre.
double glareOf(const Luminaire& luminaire, const Observer& observer);

/// lx at a point on what stands upright there, of each luminaire.
struct UprightRows {
  std::vector<float> cylindrical;            // on a small cylinder: the mean of all vertical planes
  std::vector<std::vector<float>> vertical;  // on planes that face each of the directions asked for
};

/// Lines of sight in a room: what is met from where. They are the same whatever hangs in it and however it is
/// painted, so what has been met from the latest places is kept. Refers to the scene, which must have a light
/// operator and outlive it. Not for several threads.
class SightLines {
 public:
  // From an eye, whose background holds UGR within 0.1, and from one of the many points of a measuring plane.
  static constexpr std::uint32_t kEyeSights = 12288;
  static constexpr std::uint32_t kPointSights = 2048;

  struct Sight {
    Vec3 direction;
    std::uint32_t patch;
  };

  explicit SightLines(const Scene& room) : room_(room), tree_(room) {}
  const TileTree& tree() const { return tree_; }
  /// `count` evenly over all directions, patch by patch; those that meet nothing are left out.
  std::shared_ptr<const std::vector<Sight>> from(const Vec3& position,
                                                 std::uint32_t count = kEyeSights) const;
  /// What white patches add to the readings of those who look from somewhere into some directions, per lx.
  struct Outlook {
    Vec3 position;
    std::vector<Vec3> directions;
    std::vector<std::uint32_t> patches;
    std::vector<double> cylindrical;  // patches: lx
    std::vector<double> background;   // patches x directions: cd/m2
  };
  using Outlooks = std::vector<std::shared_ptr<const Outlook>>;
  /// By the sights of an eye; kept, of the latest.
  std::shared_ptr<const Outlook> outlookOfEye(const Vec3& position,
                                              const std::vector<Vec3>& directions) const {
    return outlook(position, directions, kEyeSights, eyes_, kKept);
  }
  /// By those of a measuring plane's point; likewise, of more.
  std::shared_ptr<const Outlook> outlookOfPoint(const Vec3& position,
                                                const std::vector<Vec3>& directions) const {
    return outlook(position, directions, kPointSights, points_, kKeptPoints);
  }
  /// Of a luminaire's area. Kept.
  double visibleShare(const Vec3& eye, const Luminaire& luminaire) const;

 private:
  /// An eye, and a luminaire's place, axes and size.
  using Area = std::array<double, 14>;
  struct Known {
    Vec3 position;
    std::uint32_t count;
    std::shared_ptr<const std::vector<Sight>> sights;
  };
  std::vector<Sight> met(const Vec3& position, std::uint32_t count) const;
  Outlook outlookAt(const Vec3& position, const std::vector<Vec3>& directions, std::uint32_t count) const;
  std::shared_ptr<const Outlook> outlook(const Vec3& position, const std::vector<Vec3>& directions,
                                         std::uint32_t count, Outlooks& kept, std::size_t most) const;

  static constexpr std::size_t kKept = 64, kKeptPoints = 512;
  const Scene& room_;
  TileTree tree_;
  mutable std::vector<Known> known_;       // the latest last
  mutable Outlooks eyes_, points_;         // likewise
  mutable std::map<Area, double> shares_;  // of what has been asked for
};

/// Refers to the scene, which must have a light operator and outlive it.
class RoomView {
 public:
  explicit RoomView(const Scene& room) : RoomView(room, room.patches.reflectance) {}
  /// Under other paint: `reflectance` of the patches, referred to as well. `lines`: of that room, where they
  /// are there already.
  RoomView(const Scene& room, const std::vector<float>& reflectance,
           std::shared_ptr<const SightLines> lines = nullptr)
      : reflectance_(reflectance), lines_(lines ? std::move(lines) : std::make_shared<SightLines>(room)) {}

  /// Of luminaires at their fluxes under a common dimming, which have made that illuminance (lx, rows).
  std::vector<ObserverReading> readings(const std::vector<Observer>& observers,
                                        const std::vector<Luminaire>& luminaires, double dimming,
                                        const std::vector<float>& illuminance) const;
  /// Of each luminaire; column j of the responses is its light.
  std::vector<ObserverRows> rows(const std::vector<Observer>& observers,
                                 const std::vector<Luminaire>& luminaires, const Responses& responses) const;
  /// Of some of them: `some` are their numbers, ascending.
  std::vector<ObserverRows> rows(const std::vector<Observer>& observers,
                                 const std::vector<Luminaire>& luminaires, const Responses& responses,
                                 const std::vector<std::uint32_t>& some) const;

  /// Of each luminaire at its flux, which is lit by parts; column j of the responses is its light. Of columns
  /// beyond the luminaires: what the room reflects of them.
  UprightRows upright(const Vec3& point, const std::vector<Vec3>& directions,
                      const std::vector<Luminaire>& luminaires, const Responses& responses) const;

 private:
  class Reflected;

  ObserverReading directAt(const Observer& observer, const Luminaire& luminaire) const;

  const std::vector<float>& reflectance_;  // of the patches
  std::shared_ptr<const SightLines> lines_;
};

/// Fills scene.observers for these, unless they are there already. An Error in a scene whose file does not
/// tell the shape of its patches.
Result<Done> observe(Scene& scene, const std::vector<Observer>& observers);

}  // namespace fiatlux
