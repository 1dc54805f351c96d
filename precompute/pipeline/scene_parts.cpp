#include "precompute/pipeline/scene_parts.h"

#include <cassert>
#include <optional>
#include <utility>

#include "precompute/base/error.h"
#include "precompute/light/cast_light.h"
#include "precompute/light/light_part.h"
#include "precompute/pipeline/steps.h"

namespace fiatlux {

struct SceneParts::State {
  std::string name;  // of the model's file
  SceneOptions options;
  Host host;
  OpenedRoom opened;
  std::optional<FormFactorCaster> caster;  // once it is needed
  CastLight light;                         // added so far
  std::optional<std::uint32_t> missing;    // rows, once there are some
};

Result<SceneParts> SceneParts::open(ModelFile model, SceneOptions options, Host host) {
  assert(host.deflate && host.threads == 1 && !options.transport.paper);
  const auto open = [&] {
    SceneOptions same = consistent(std::move(options), host);
    OpenedRoom room = opened(model, same.room, host);
    return SceneParts(std::make_unique<State>(
        State{model.name, std::move(same), std::move(host), std::move(room), {}, {}, {}}));
  };
  return atDoor(open, kNoMemory);
}

SceneParts::SceneParts(std::unique_ptr<State> state) : state_(std::move(state)) {}
SceneParts::SceneParts(SceneParts&&) noexcept = default;
SceneParts& SceneParts::operator=(SceneParts&&) noexcept = default;
SceneParts::~SceneParts() = default;

const Room& SceneParts::room() const { return state_->opened.room; }

Result<std::vector<std::uint8_t>> SceneParts::cast(std::uint32_t first, std::uint32_t rows) {
  assert(first + rows <= room().patches.rows());
  const auto cast = [&] {
    const auto& [source, room, tracer] = state_->opened;
    const TransportOptions& options = state_->options.transport;
    if (!state_->caster) state_->caster.emplace(room, tracer, castOptionsOf(options));
    LightPart part{first, {}, {}};
    for (std::uint32_t p = first; p < first + rows; ++p) part.rows.push_back(state_->caster->row(p));
    part.direct =
        directLightOfRows(room, tracer, siteLuminaires(room), directOptionsOf(options), first, rows);
    return encodeLightPart(part);
  };
  return atDoor(cast, kNoMemory);
}

Result<Done> SceneParts::add(std::span<const std::uint8_t> bytes) {
  const auto add = [&] {
    const auto& [source, room, tracer] = state_->opened;
    const LightPart part = orThrow(decodeLightPart(bytes, room.patches.clusterCount, room.sites.size()));
    const std::uint32_t all = room.patches.rows();
    if (part.first > all || part.rows.size() > all - part.first)
      throw CommandError("a part of the light is of another room");
    CastLight& light = state_->light;
    if (light.factors.rows == 0) {
      if (!state_->caster) state_->caster.emplace(room, tracer, castOptionsOf(state_->options.transport));
      light.factors = state_->caster->withoutRows();
      light.direct.resize(std::size_t{all} * room.sites.size());
      state_->missing = all;
    }
    for (std::uint32_t i = 0; i < part.rows.size(); ++i) {
      setRow(light.factors, part.first + i, part.rows[i]);
      for (std::size_t j = 0; j < room.sites.size(); ++j)
        light.direct[j * all + part.first + i] = part.direct[j * part.rows.size() + i];
    }
    *state_->missing -= static_cast<std::uint32_t>(part.rows.size());
    return Done{};
  };
  return atDoor(add, kNoMemory);
}

Result<MadeScene> SceneParts::assemble() {
  const auto assemble = [&] {
    const auto& [source, room, tracer] = state_->opened;
    if (state_->missing != 0) throw CommandError("parts of the light are missing");
    state_->caster.reset();
    Transport transport =
        orThrow(completeTransport(room, tracer, std::exchange(state_->light, {}), state_->options.transport));
    return fileOf(state_->name, source, room, std::move(transport), state_->options, state_->host);
  };
  return atDoor(assemble, kNoMemory);
}

}  // namespace fiatlux
