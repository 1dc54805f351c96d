#include "core/session/paint_gains.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/scene/zones.h"
#include "core/search/plane_values.h"
#include "core/search/shown.h"
#include "core/search/validate_intentions.h"
#include "core/transport/plane_light.h"
#include "core/transport/room_view.h"
#include "core/transport/surface_statistics.h"

namespace fiatlux {
namespace {

constexpr double kStep = 0.01;  // of reflectance, that the derivative is read over
constexpr double kTold = 0.1;   // of reflectance, that a gain is told for

/// The largest surfaces that can be painted, by their numbers.
std::vector<std::uint32_t> paintable(const Scene& room) {
  std::vector<std::uint32_t> surfaces;
  for (std::uint32_t s = 0; s < firstZone(room); ++s)
    if (!room.surfaces[s].measuring) surfaces.push_back(s);
  std::stable_sort(surfaces.begin(), surfaces.end(), [&](std::uint32_t a, std::uint32_t b) {
    return room.surfaces[a].area > room.surfaces[b].area;
  });
  surfaces.resize(std::min(surfaces.size(), kMostGains));
  std::sort(surfaces.begin(), surfaces.end());
  return surfaces;
}

Responses asOne(std::vector<float> light) {
  const auto rows = static_cast<std::uint32_t>(light.size());
  return {rows, 1, std::move(light)};
}

/// Of a layout together.
Responses together(const Responses& each, const Layout& layout) {
  std::vector<float> sum(each.rows, 0.0f);
  for (std::size_t i = 0; i < layout.sites.size(); ++i) {
    const float* column = each.column(layout.sites[i]);
    const auto flux = static_cast<float>(layout.dimming * layout.flux[i]);
    for (std::uint32_t p = 0; p < each.rows; ++p) sum[p] += flux * column[p];
  }
  return asOne(std::move(sum));
}

/// The room with one luminaire of flux 1, which does what the whole layout does.
Scene litScene(const Scene& room, const Repaint& paint, const LitLayout& lit) {
  const auto& [hung, layout] = lit;
  Scene scene;
  scene.patches = room.patches;
  scene.surfaces.assign(room.surfaces.begin(), room.surfaces.begin() + firstZone(room));
  scene.sites = {Site{}};
  scene.responses = asOne(illuminanceOf(hung, layout));
  std::copy(paint.reflectance().begin(), paint.reflectance().end(), scene.patches.reflectance.begin());
  if (hung.direct) {
    Responses direct = asOne(illuminanceOf(hung, layout, Quantity::kDirect));
    auto statistics = meanRows(scene.patches, scene.surfaces.size(), direct, Quantity::kDirect);
    scene.direct = DirectLight{std::move(direct), std::move(statistics)};
  }
  const std::vector<ObserverReading> seen = readObservers(hung.observers, layout);
  for (std::size_t o = 0; o < seen.size(); ++o)
    scene.observers.push_back({hung.observers[o].observer,
                               {seen[o].glare},
                               {seen[o].background},
                               {seen[o].vertical},
                               {seen[o].cylindrical}});
  for (const PlaneLight& plane : hung.planes) {
    scene.planes.push_back(
        {plane.surface, together(plane.horizontal, layout), together(plane.cylindrical, layout), {}});
    for (const auto& [direction, light] : plane.verticals)
      scene.planes.back().verticals.push_back({direction, together(light, layout)});
  }
  return scene;
}

Result<Done> check(const Scene& room, const LitLayout& lit, const Intentions& asked) {
  if (Result<Done> ok = checkIntentions(lit.scene, asked); !ok) return ok;
  if (Result<Done> ok = checkLayout(lit.scene, lit.layout); !ok) return ok;
  const auto isOf = [](const ObserverRows& rows, const Observer& observer) {
    return rows.observer == observer;
  };
  const std::vector<ObserverRows>& seen = lit.scene.observers;
  const std::vector<PlaneWish> wishes = planesAskedOf(asked);
  const bool isTold =
      lit.scene.zones == asked.zones && (!asksForDirect(asked) || lit.scene.direct) &&
      std::equal(seen.begin(), seen.end(), asked.observers.begin(), asked.observers.end(), isOf) &&
      std::all_of(wishes.begin(), wishes.end(),
                  [&](const PlaneWish& wish) { return isToldBy(lit.scene.planes, wish); });
  if (!isTold || lit.scene.responses.rows != room.patches.rows())
    return Error{"the light that is there does not tell what is asked"};
  return Done{};
}

PaintGain readingsOf(Scene& scene, const Intentions& asked) {
  (void)takeZones(scene, {});
  setMeanRows(asked.quantity, scene);
  (void)takeZones(scene, asked.zones);
  PreparedScene prepared(scene);
  const Shown shown = shownOf(prepared, asked, {{0}, {1}, 1});
  PaintGain readings{0, shown.goals, {}};
  for (const ConstraintReading& reading : shown.constraints) readings.constraints.push_back(reading.value);
  return readings;
}

std::vector<double> perTold(const std::vector<double>& after, const std::vector<double>& before) {
  std::vector<double> gains(after.size());
  for (std::size_t i = 0; i < after.size(); ++i) {
    const double gain = (after[i] - before[i]) * (kTold / kStep);
    gains[i] = std::isfinite(gain) ? gain : 0;
  }
  return gains;
}

/// The lit room as it is, and with one surface after the other a step lighter. What luminaires do on their
/// own stays; what the room reflects to observers and to the points of planes changes.
class Lightened {
 public:
  Lightened(const Scene& room, const PhotometricLight& light, const Repaint& paint, Scene lit,
            const std::vector<std::uint32_t>& surfaces)
      : room_(room),
        lines_(light.sightLines()),
        paint_(paint),
        base_(std::move(lit)),
        lit_(base_),
        surfaces_(surfaces) {
    const std::vector<float>& now = base_.responses.illuminance;
    const auto columns = static_cast<std::uint32_t>(surfaces.size());
    const std::vector<float> more =
        paint.light(lightPerReflectance(room, light.exchange(), now, surfaces), columns);
    light_ = {room.patches.rows(), columns + 1, now};
    for (std::size_t i = 0; i < more.size(); ++i)
      light_.illuminance.push_back(now[i % now.size()] + static_cast<float>(kStep) * more[i]);
    if (!base_.observers.empty()) seen_ = backgroundsOf(columns);
    if (!base_.planes.empty()) reflectOnPlanes();
  }

  Scene& asItIs() { return lit_; }

  /// With surfaces[j] lighter, until it is asked again.
  Scene& with(std::uint32_t j) {
    const std::size_t rows = light_.rows;
    const auto lighter = light_.illuminance.begin() + static_cast<std::ptrdiff_t>(rows * (j + 1));
    lit_.responses.illuminance.assign(lighter, lighter + static_cast<std::ptrdiff_t>(rows));
    const std::vector<float> reflectance = reflectanceWith(j);
    std::copy(reflectance.begin(), reflectance.end(), lit_.patches.reflectance.begin());
    if (!base_.observers.empty()) {
      const std::vector<double> seen = backgroundsOf(j);
      for (std::size_t o = 0; o < seen.size(); ++o)
        lit_.observers[o].background = {base_.observers[o].background[0] + seen[o] - seen_[o]};
    }
    for (std::size_t i = 0; i < reflected_.size(); ++i) {
      const PlaneLight &of = base_.planes[i], &by = reflected_[i];
      PlaneLight& plane = lit_.planes[i];
      plane.horizontal = moved(of.horizontal, by.horizontal, j);
      plane.cylindrical = moved(of.cylindrical, by.cylindrical, j);
      for (std::size_t d = 0; d < of.verticals.size(); ++d)
        plane.verticals[d].light = moved(of.verticals[d].light, by.verticals[d].light, j);
    }
    return lit_;
  }

 private:
  /// Of the patches, with surfaces[j] lighter where there is such a surface.
  std::vector<float> reflectanceWith(std::uint32_t j) const {
    std::vector<float> reflectance = paint_.reflectance();
    for (std::uint32_t p = 0; j < surfaces_.size() && p < reflectance.size(); ++p)
      if (room_.patches.surface[p] == surfaces_[j]) reflectance[p] += static_cast<float>(kStep);
    return reflectance;
  }

  std::vector<double> backgroundsOf(std::uint32_t j) const {
    std::vector<Observer> observers;
    for (const ObserverRows& rows : base_.observers) observers.push_back(rows.observer);
    const std::size_t column = j < surfaces_.size() ? j + 1 : 0;
    const float* light = light_.column(static_cast<std::uint32_t>(column));
    const std::vector<float> reflectance = reflectanceWith(j);
    std::vector<double> backgrounds;
    for (const ObserverReading& reading :
         RoomView(room_, reflectance, lines_).readings(observers, {}, 1, {light, light + light_.rows}))
      backgrounds.push_back(reading.background);
    return backgrounds;
  }

  /// All columns at once, for the lines of sight from a point take longest: exitances in a room that reflects
  /// all of its light.
  void reflectOnPlanes() {
    Responses exitance = light_;
    const auto columns = static_cast<std::uint32_t>(surfaces_.size());
    for (std::uint32_t c = 0; c < exitance.sites; ++c) {
      const std::vector<float> reflectance = reflectanceWith(c > 0 ? c - 1 : columns);
      float* column = &exitance.illuminance[std::size_t{c} * exitance.rows];
      for (std::size_t p = 0; p < reflectance.size(); ++p) column[p] *= reflectance[p];
    }
    std::vector<PlaneWish> wishes;
    for (const PlaneLight& plane : base_.planes) {
      wishes.push_back({plane.surface, {}});
      for (const auto& vertical : plane.verticals) wishes.back().directions.push_back(vertical.direction);
    }
    const std::vector<float> all(room_.patches.count, 1.0f);
    reflected_ = planeLight(room_, RoomView(room_, all, lines_), wishes, {}, exitance);
  }

  static Responses moved(const Responses& of, const Responses& by, std::uint32_t j) {
    Responses light = of;
    for (std::uint32_t p = 0; p < light.rows; ++p)
      light.illuminance[p] += by.column(j + 1)[p] - by.column(0)[p];
    return light;
  }

  const Scene& room_;
  std::shared_ptr<const SightLines> lines_;
  const Repaint& paint_;
  const Scene base_;
  Scene lit_;
  const std::vector<std::uint32_t>& surfaces_;
  Responses light_;                    // as it is, then with each of the surfaces lighter
  std::vector<double> seen_;           // background of each observer as it is, cd/m2
  std::vector<PlaneLight> reflected_;  // the room's part of the light on planes, columns as of light_
};

}  // namespace

Result<std::vector<PaintGain>> paintGains(const Scene& room, const PhotometricLight& light,
                                          const Repaint& paint, const LitLayout& lit,
                                          const Intentions& asked) {
  Intentions intentions = asked;
  intentions.luminaires = {};
  intentions.luminaires.count = 1;
  intentions.luminaires.flux = {1};
  if (Result<Done> ok = check(room, lit, intentions); !ok) return ok.error();
  const std::vector<std::uint32_t> surfaces = paintable(room);
  Lightened lightened(room, light, paint, litScene(room, paint, lit), surfaces);
  const PaintGain before = readingsOf(lightened.asItIs(), intentions);
  std::vector<PaintGain> gains;
  for (std::uint32_t j = 0; j < surfaces.size(); ++j) {
    const PaintGain after = readingsOf(lightened.with(j), intentions);
    gains.push_back(
        {surfaces[j], perTold(after.goals, before.goals), perTold(after.constraints, before.constraints)});
  }
  return gains;
}

}  // namespace fiatlux
