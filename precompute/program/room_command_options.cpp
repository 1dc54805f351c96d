#include "precompute/program/room_command_options.h"

#include <cstdlib>

#include "precompute/gltf/reflectance.h"
#include "precompute/program/option_checks.h"

namespace fiatlux {

namespace {

constexpr double kMost = 1e6;  // m, GB: beyond any room, far from what a number can hold

/// NAME=VALUE, a name that may hold '=' itself.
void addReflectanceOption(CLI::App& command, RoomOptions& room) {
  const auto add = [&room](const std::vector<std::string>& given) {
    room.reflectances.clear();
    for (const std::string& text : given) {
      const std::size_t end = text.rfind('=');
      const std::string value = end == std::string::npos ? "" : text.substr(end + 1);
      if (end == 0 || !numberFrom(0, kMostReflectance)(value).empty())
        throw CLI::ValidationError("--reflectance",
                                   "'" + text + "' is no MATERIAL=VALUE with a value from 0 to 0.95");
      room.reflectances.push_back({text.substr(0, end), std::strtod(value.c_str(), nullptr)});
    }
  };
  command
      .add_option_function<std::vector<std::string>>(
          "--reflectance", add, "MATERIAL=VALUE: what a material reflects, 0 to 0.95 (repeatable)")
      ->allow_extra_args(false)
      ->type_name("TEXT");
}

void addPlaceOptions(CLI::App& command, PlaceOptions& place) {
  using Lid = PlaceOptions::Lid;
  CLI::Option* inside = command
                            .add_option_function<std::vector<double>>(
                                "--inside",
                                [&place](const std::vector<double>& p) {
                                  place.inside = Vec3{p[0], p[1], p[2]};
                                },
                                "X,Y,Z in metres, a point in a building's room: only that room is lit")
                            ->expected(3)
                            ->delimiter(',')
                            ->check(numberFrom(-kMost, kMost));
  command
      .add_option("--doors", place.doors, "With --inside: rooms behind so many open doors belong to it, too")
      ->needs(inside)
      ->check(wholeFrom(0, 100))
      ->capture_default_str();
  command
      .add_option_function<std::string>(
          "--lid",
          [&place](const std::string& kind) {
            place.lid = kind == "white" ? Lid::kWhite : kind == "dark" ? Lid::kDark : Lid::kNone;
          },
          "With --inside: what closes its openings (default: none)")
      ->needs(inside)
      ->check(CLI::IsMember({"none", "dark", "white"}))
      ->type_name("none|dark|white");
}

}  // namespace

void addModelOptions(CLI::App& command, std::string& source, RoomOptions& room, bool& verbose) {
  command.add_option("room", source, "The room (.glb, or .gltf with its files)")->required();
  command
      .add_option("--mount", room.mounts,
                  "Node, surface or pattern ('Ceiling*') where luminaires may hang (repeatable)")
      ->allow_extra_args(false);
  command
      .add_option("--ceiling", room.ceiling,
                  "Luminaires hang in a plane so many metres above the largest floor")
      ->check(numberFrom(0.1, kMost));
  command.add_option("--measure", room.measures, "Node that is a measuring plane (repeatable)")
      ->allow_extra_args(false);
  command
      .add_option("--scale", room.scale,
                  "Metres of one unit of the file (default: 1, or a guess where that is absurd)")
      ->check(numberFrom(1e-6, kMost));
  command
      .add_option_function<std::string>(
          "--up", [&room](const std::string& axis) { room.up = axis == "z" ? UpAxis::kZ : UpAxis::kY; },
          "Axis of the file that is up (default: y, but where a room would lie on its back)")
      ->check(CLI::IsMember({"y", "z"}))
      ->type_name("y|z");
  addReflectanceOption(command, room);
  addPlaceOptions(command, room.place);
  command
      .add_option("--plane", room.plane,
                  "A measuring plane so many metres over the floor below the luminaires")
      ->check(numberFrom(0.01, kMost));
  command.add_option("--plane-rim", room.planeRim, "How far that plane stays away from the floor's edges, m")
      ->check(numberFrom(0, kMost))
      ->capture_default_str();
  command.add_flag("--double-sided", room.doubleSided, "Faces of every material have two sides");
  command.add_flag("--verbose", verbose, "Tell all remarks on the model, not the first five alone");
}

void addRoomOptions(CLI::App& command, std::string& source, RoomOptions& room, RayOptions rays,
                    bool& verbose) {
  addModelOptions(command, source, room, verbose);
  command
      .add_option("--patch", room.patch,
                  "Edge of a patch, m (default: about 25 000 patches of 0.1 m or more)")
      ->check(numberFrom(1e-4, kMost));
  command.add_option("--site-spacing", room.siteSpacing, "Distance between sites, m")
      ->check(numberFrom(1e-3, kMost));
  command.add_option("--site-size", room.siteSize, "Side of a luminaire's square, m (default: the spacing)")
      ->check(numberFrom(1e-3, kMost));
  command.add_option("--drop", room.drop, "How far below their mounts luminaires hang (pendants), m")
      ->check(numberFrom(0, kMost));
  command.add_option("--memory", room.memory, "GB that may be used")
      ->check(numberFrom(0.01, kMost))
      ->capture_default_str();
  addRayOptions(command, rays);
}

void addRayOptions(CLI::App& command, RayOptions rays) {
  command.add_option("--rays", rays.rays, "Rays from every patch; above 1024 shadow rays grow, too")
      ->check(wholeFrom(1, 65536))
      ->capture_default_str();
  command.add_option("--seed", rays.seed, "Of the rays")->check(aSeed())->capture_default_str();
  command.add_option("--threads", rays.threads, "0: all cores")
      ->check(wholeFrom(0, 1024))
      ->capture_default_str();
}

}  // namespace fiatlux
