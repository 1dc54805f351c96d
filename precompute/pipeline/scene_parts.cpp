#include "precompute/pipeline/scene_parts.h"

#include <algorithm>
#include <cassert>
#include <optional>
#include <utility>

#include "core/transport/low_rank_radiosity.h"
#include "core/transport/site_responses.h"
#include "precompute/base/error.h"
#include "precompute/light/cast_light.h"
#include "precompute/light/forward_light.h"
#include "precompute/light/interreflection.h"
#include "precompute/light/light_part.h"
#include "precompute/pipeline/steps.h"

namespace fiatlux {
namespace {

constexpr const char* kMissing = "parts of the light are missing";
constexpr const char* kElsewhere = "a part of the light is of another room";

ForwardOptions forwardOptionsOf(const TransportOptions& asked) {
  ForwardOptions options;
  options.rays = asked.rays;
  options.seed = asked.seed;
  options.threads = 1;
  return options;
}

/// What columns of direct light (lx, rows each) become with everything reflected: solved a block at a time.
std::vector<float> reflectedColumns(const Patches& patches, const FormFactors& factors,
                                    const LowRankRadiosity& lowRank, const std::vector<float>& direct,
                                    const ForwardOptions& options) {
  const std::size_t rows = patches.rows(), count = direct.size() / rows;
  std::vector<float> columns(direct.size());
  for (std::size_t first = 0; first < count; first += kBlockWidth) {
    ResponseBlock block;
    const std::size_t used = std::min<std::size_t>(kBlockWidth, count - first);
    block.width = paddedSources(static_cast<std::uint32_t>(used));
    block.direct.resize(rows * block.width);
    for (std::size_t j = 0; j < used; ++j)
      for (std::size_t p = 0; p < rows; ++p)
        block.direct[p * block.width + j] = direct[(first + j) * rows + p];
    solveResponses(factors, patches, lowRank, options.steps, options.tolerance, block);
    for (std::size_t j = 0; j < used; ++j)
      for (std::size_t p = 0; p < rows; ++p)
        columns[(first + j) * rows + p] = std::max(0.0f, block.irradiance[p * block.width + j]);
  }
  return columns;
}

/// Column `column` of a part, `rows` long, to its place.
template <class T>
void putRows(const std::vector<T>& part, std::size_t column, std::size_t rows, std::vector<T>& all,
             std::size_t at) {
  const auto from = part.begin() + static_cast<std::ptrdiff_t>(column * rows);
  std::copy(from, from + static_cast<std::ptrdiff_t>(rows), all.begin() + static_cast<std::ptrdiff_t>(at));
}

}  // namespace

struct SceneParts::State {
  std::string name;  // of the model's file
  SceneOptions options;
  Host host;
  OpenedRoom opened;
  std::optional<FormFactorCaster> caster;   // once it is needed
  CastLight light;                          // added so far
  std::optional<std::uint32_t> missing;     // rows, once there are some
  std::unique_ptr<Interreflection> solver;  // of all rows
  SolvedLight solved;                       // joined so far
  std::uint32_t unsolved = 0;               // blocks
  FormFactors factors;                      // of all rows, once the file is made
  std::optional<LowRankRadiosity> lowRank;  // of these, once it is needed
};

Result<SceneParts> SceneParts::open(ModelFile model, SceneOptions options, Host host) {
  assert(host.deflate && host.threads == 1 && !options.transport.paper);
  const auto open = [&] {
    SceneOptions same = consistent(std::move(options), host);
    OpenedRoom room = opened(model, same.room, host);
    return SceneParts(std::make_unique<State>(State{
        model.name, std::move(same), std::move(host), std::move(room), {}, {}, {}, {}, {}, {}, {}, {}}));
  };
  return atDoor(open, kNoMemory);
}

SceneParts::SceneParts(std::unique_ptr<State> state) : state_(std::move(state)) {}
SceneParts::SceneParts(SceneParts&&) noexcept = default;
SceneParts& SceneParts::operator=(SceneParts&&) noexcept = default;
SceneParts::~SceneParts() = default;

const Room& SceneParts::room() const { return state_->opened.room; }

double SceneParts::bytes() const { return bytesNeeded(countsOf(state_->options.room, room())); }

Result<std::vector<std::uint8_t>> SceneParts::cast(std::uint32_t first, std::uint32_t rows) {
  assert(first + rows <= room().patches.rows());
  const auto cast = [&] {
    const auto& [source, room, tracer] = state_->opened;
    const TransportOptions& options = state_->options.transport;
    if (!state_->caster) state_->caster.emplace(room, tracer, castOptionsOf(options));
    LightPart part{first, {}, {}, {}};
    for (std::uint32_t p = first; p < first + rows; ++p) part.rows.push_back(state_->caster->row(p));
    SiteVisibility visibility;
    part.direct = directLightOfRows(room, tracer, siteLuminaires(room), directOptionsOf(options), first, rows,
                                    options.exchange ? &visibility : nullptr);
    part.visible = std::move(visibility.steps);
    return encodeLightPart(part);
  };
  return atDoor(cast, kNoMemory);
}

Result<Done> SceneParts::add(std::span<const std::uint8_t> bytes) {
  const auto add = [&] {
    const auto& [source, room, tracer] = state_->opened;
    const bool isVisible = state_->options.transport.exchange;
    const LightPart part =
        orThrow(decodeLightPart(bytes, room.patches.clusterCount, room.sites.size(), isVisible));
    const std::uint32_t all = room.patches.rows();
    if (part.first > all || part.rows.size() > all - part.first) throw CommandError(kElsewhere);
    CastLight& light = state_->light;
    if (light.factors.rows == 0) {
      if (!state_->caster) state_->caster.emplace(room, tracer, castOptionsOf(state_->options.transport));
      light.factors = state_->caster->withoutRows();
      light.direct.resize(std::size_t{all} * room.sites.size());
      if (isVisible)
        light.visibility = {all, static_cast<std::uint32_t>(room.sites.size()),
                            std::vector<std::uint8_t>(light.direct.size())};
      state_->missing = all;
    }
    for (std::uint32_t i = 0; i < part.rows.size(); ++i) setRow(light.factors, part.first + i, part.rows[i]);
    for (std::size_t j = 0; j < room.sites.size(); ++j) {
      putRows(part.direct, j, part.rows.size(), light.direct, j * all + part.first);
      if (isVisible) putRows(part.visible, j, part.rows.size(), light.visibility.steps, j * all + part.first);
    }
    *state_->missing -= static_cast<std::uint32_t>(part.rows.size());
    return Done{};
  };
  return atDoor(add, kNoMemory);
}

Result<std::uint32_t> SceneParts::prepare() {
  const auto prepare = [&] {
    if (state_->missing != 0) throw CommandError(kMissing);
    const auto& [source, room, tracer] = state_->opened;
    if (state_->caster) state_->caster->complete(state_->light.factors);
    state_->caster.reset();
    state_->solver =
        std::make_unique<Interreflection>(room, tracer, state_->light, state_->options.transport);
    state_->solved = state_->solver->unsolved();
    return state_->unsolved = state_->solver->blocks();
  };
  return atDoor(prepare, kNoMemory);
}

Result<std::vector<std::uint8_t>> SceneParts::solve(std::uint32_t block) {
  assert(state_->solver && block < state_->solver->blocks());
  return atDoor([&] { return encodeSolvedPart({block, state_->solver->solve(block)}); }, kNoMemory);
}

Result<Done> SceneParts::join(std::span<const std::uint8_t> bytes) {
  assert(state_->solver);
  const auto join = [&] {
    SolvedPart part = orThrow(decodeSolvedPart(bytes));
    if (!state_->solver->isOf(part.block, part.solved)) throw CommandError(kElsewhere);
    state_->solver->put(part.block, std::move(part.solved), state_->solved);
    --state_->unsolved;
    return Done{};
  };
  return atDoor(join, kNoMemory);
}

Result<MadeScene> SceneParts::assemble() {
  const auto assemble = [&] {
    if (!state_->solver || state_->unsolved != 0) throw CommandError(kMissing);
    const auto& [source, room, tracer] = state_->opened;
    state_->solver.reset();
    Transport transport = completeTransport(room, std::exchange(state_->light, {}),
                                            std::exchange(state_->solved, {}), state_->options.transport);
    MadeScene made = fileOf(state_->name, source, room, std::move(transport), state_->options, state_->host);
    state_->factors = std::move(transport.factors);
    return made;
  };
  return atDoor(assemble, kNoMemory);
}

Result<std::vector<float>> SceneParts::light(const std::vector<Luminaire>& luminaires) {
  const auto light = [&] {
    if (state_->factors.rows == 0) throw CommandError(kMissing);
    const auto& [source, room, tracer] = state_->opened;
    if (!state_->lowRank)
      state_->lowRank.emplace(orThrow(LowRankRadiosity::factorize(state_->factors, room.patches)));
    const ForwardOptions options = forwardOptionsOf(state_->options.transport);
    return reflectedColumns(room.patches, state_->factors, *state_->lowRank,
                            forwardDirectLight(room, tracer, luminaires, options), options);
  };
  return atDoor(light, kNoMemory);
}

}  // namespace fiatlux
