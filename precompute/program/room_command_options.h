// The options that every command has that makes a room of a glTF and casts rays in it.
#pragma once

#include <cstdint>
#include <string>

#include "precompute/geometry/room_options.h"

namespace CLI {
class App;
}

namespace fiatlux {

/// Where a command keeps what is said about its rays.
struct RayOptions {
  std::uint32_t& rays;
  std::uint64_t& seed;
  unsigned& threads;
};

/// Adds the room's file and what says how it is understood: unit, mounts, measuring planes. What is referred
/// to must outlive `command`.
void addModelOptions(CLI::App& command, std::string& source, RoomOptions& room, bool& verbose);

/// And all that says how it becomes patches, sites and rays.
void addRoomOptions(CLI::App& command, std::string& source, RoomOptions& room, RayOptions rays,
                    bool& verbose);

/// --rays, --seed and --threads alone.
void addRayOptions(CLI::App& command, RayOptions rays);

}  // namespace fiatlux
