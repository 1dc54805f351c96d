// A building of many small nodes (small_parts): each room has a floor, walls and a ceiling that can be named.
#include "precompute/geometry/small_parts.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <map>

#include "precompute/geometry/build_room.h"
#include "tests/precompute/geometry/trap_rooms.h"

namespace fiatlux {
namespace {

using testing::kStorey;
using testing::TrapRoom;

constexpr double kTile = 0.5, kPost = 0.25, kSlabThick = 0.1;  // m
constexpr double kSmallRoom = 4, kLargeRoom = 6, kRoomDeep = 5;

/// Tiles above and below a room, posts around it, a box on its floor.
void addRoom(TrapRoom& made, double x, double y, double wide) {
  for (int i = 0; i * kTile < wide; ++i)
    for (int j = 0; j * kTile < kRoomDeep; ++j)
      for (const double at : {y - kSlabThick, y + kStorey})
        made.block("tile", {x + i * kTile, at, j * kTile}, {kTile, kSlabThick, kTile});
  for (int i = 0; i * kPost < wide; ++i)
    for (const double z : {-kSlabThick, kRoomDeep})
      made.block("post", {x + i * kPost, y, z}, {kPost, kStorey, kSlabThick});
  for (int j = 0; j * kPost < kRoomDeep; ++j)
    for (const double at : {x - kSlabThick, x + wide})
      made.block("post", {at, y, j * kPost}, {kSlabThick, kStorey, kPost});
  made.block("box", {x + 1, y, 1}, {0.5, 0.4, 0.5});
}

std::map<std::string, double> areasOf(TrapRoom& made) {
  RoomOptions options;
  options.patch = 0.5;
  const auto room = buildRoom(*made.gltf.read(), options);
  std::map<std::string, double> areas;
  if (!room) ADD_FAILURE() << room.error().message;
  if (room)
    for (const Surface& surface : room->surfaces) areas[surface.name] = surface.area;
  return areas;
}

TEST(SmallParts, HaveRoomsThatCanBeNamed) {
  TrapRoom made;
  addRoom(made, 0, 0, kLargeRoom);
  addRoom(made, kLargeRoom + 2 * kSlabThick, 0, kSmallRoom);
  addRoom(made, 0, kStorey + 3 * kSlabThick, kLargeRoom);
  std::map<std::string, double> areas = areasOf(made);
  const double foot = 0.25;  // m2, of the box
  EXPECT_NEAR(areas["storey 1/room 1/floor"], kLargeRoom * kRoomDeep - foot, 0.5);
  EXPECT_NEAR(areas["storey 1/room 1/ceiling"], kLargeRoom * kRoomDeep, 0.5);
  EXPECT_NEAR(areas["storey 1/room 1/walls"], 2 * (kLargeRoom + kRoomDeep) * kStorey, 1);
  EXPECT_NEAR(areas["storey 1/room 1/things"], 1.05, 0.1);
  EXPECT_NEAR(areas["storey 1/room 2/floor"], kSmallRoom * kRoomDeep - foot, 0.5);
  EXPECT_NEAR(areas["storey 2/room 1/ceiling"], kLargeRoom * kRoomDeep, 0.5);
}

TEST(SmallParts, OfOneRoomNeedNoNumber) {
  TrapRoom made;
  addRoom(made, 0, 0, 2 * kLargeRoom);
  std::map<std::string, double> areas = areasOf(made);
  EXPECT_NEAR(areas["room/ceiling"], 2 * kLargeRoom * kRoomDeep, 0.5);
}

}  // namespace
}  // namespace fiatlux
