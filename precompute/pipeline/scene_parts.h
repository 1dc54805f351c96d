// The pipeline in parts, for machines that share no memory: the workers of the page.
#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "precompute/pipeline/pipeline.h"

namespace fiatlux {

/// Each machine opens the room and casts the rays of some rows. Those that are given all that was cast can
/// solve blocks of what follows of it; one that is given those, too, makes the file, the same that makeScene
/// makes, however rows and blocks were split. Not in paper mode. Errors as of makeScene.
class SceneParts {
 public:
  /// The host lends one thread; it is kept.
  static Result<SceneParts> open(ModelFile model, SceneOptions options, Host host);
  SceneParts(SceneParts&&) noexcept;
  SceneParts& operator=(SceneParts&&) noexcept;
  ~SceneParts();

  const Room& room() const;
  /// Bytes that a machine holds at its peak which does all of it.
  double bytes() const;
  /// Form factors and direct light of rows [first, first + rows), as bytes for `add`.
  Result<std::vector<std::uint8_t>> cast(std::uint32_t first, std::uint32_t rows);
  /// What `cast` has returned, here or elsewhere; each row once.
  Result<Done> add(std::span<const std::uint8_t> part);
  /// How many blocks there are to solve; once, when all rows are there.
  Result<std::uint32_t> prepare();
  /// Block 0, 1, ... as bytes for `join`; prepared.
  Result<std::vector<std::uint8_t>> solve(std::uint32_t block);
  /// What `solve` has returned, here or elsewhere; each block once, prepared.
  Result<Done> join(std::span<const std::uint8_t> part);
  /// Once, when all blocks are there. The form factors of all rows stay, for `light`.
  Result<MadeScene> assemble();
  /// The light of these luminaires, all interreflections included, as `fiatlux light` has it: column-major
  /// rows x luminaires, lx, each at its flux. Assembled.
  Result<std::vector<float>> light(const std::vector<Luminaire>& luminaires);

 private:
  struct State;
  explicit SceneParts(std::unique_ptr<State> state);
  std::unique_ptr<State> state_;
};

}  // namespace fiatlux
