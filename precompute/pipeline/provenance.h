// What a scene file says of its own making: the room's identity, and the account that `fiatlux info` shows.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "precompute/pipeline/pipeline.h"

namespace fiatlux {

/// Changes whenever the same room and options would give other light: part of a room's identity.
inline constexpr int kMethodVersion = 11;

/// 16 hex digits of the source, the options that change the light, and the method.
std::string identityOf(const SceneOptions& options, const Room& room);

/// Share of the rays of all surfaces that were lost, by area; measuring planes apart.
double lostShare(const Room& room, const Transport& transport);

struct Account {
  const std::string& source;  // name of the model's file
  const std::string& plan;    // of the room, JSON; empty where there is none
  const SceneOptions& options;
  const Room& room;
  const SceneReport& report;
  const std::vector<std::uint32_t>& ranks;   // of the covariances, per surface
  const std::vector<StageSeconds>& seconds;  // up to now
};

/// The account as JSON text.
std::string provenanceOf(const Account& account);

}  // namespace fiatlux
