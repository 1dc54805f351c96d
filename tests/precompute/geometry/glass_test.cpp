// Names that say glass, in common languages, and what is said of them where the file paints them like walls.
#include "precompute/geometry/glass.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/precompute/geometry/trap_rooms.h"

namespace fiatlux {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

TEST(Glass, IsAWordOfTheName) {
  for (const char* name :
       {"glass", "Glas", "Fensterglas", "verre", "Verre clair", "vidrio", "vetro", "MI_Glass_01",
        "WindowGlass", "Glastür", "Plexiglas", "Verglasung", "clear glass.001", "Vitre"})
    EXPECT_TRUE(saysGlass(name)) << name;
  for (const char* name : {"glasses shelf", "fiberglass", "Fibreglass", "Glasur", "Glaswolle", "glass wool",
                           "Glasgow", "couverture", "glass_frame", "WindowGlassFrame", "oak", ""})
    EXPECT_FALSE(saysGlass(name)) << name;
}

/// What is said of a room with a pane of such a material.
std::string remarksOn(const std::string& material, double grey,
                      nlohmann::ordered_json more = nlohmann::ordered_json::object()) {
  testing::TrapRoom room = testing::singleMesh();
  testing::TestMesh pane;
  pane.quad({3, 1, 1}, {1, 0, 0}, {0, 1, 0});

  room.gltf.node("pane", room.gltf.mesh(pane, room.gltf.material(material, grey, more)));
  const auto built = room.gltf.build();
  return built ? testing::allWarnings(built->warnings) : built.error().message;
}

TEST(Glass, IsMentionedWhereItStopsLight) {
  EXPECT_THAT(remarksOn("Verre clair", 0.8), HasSubstr("material 'Verre clair': called glass but opaque"));
  EXPECT_THAT(remarksOn("glass", 0.8, {{"alphaMode", "BLEND"}}), Not(HasSubstr("called glass")));
  EXPECT_THAT(remarksOn("glass", 0.05), Not(HasSubstr("called glass")));  // a window at night
  EXPECT_THAT(remarksOn("oak", 0.8), Not(HasSubstr("called glass")));
}

TEST(Glass, LetsLightThroughThatTransmits) {
  const nlohmann::ordered_json clear = {
      {"extensions", {{"KHR_materials_transmission", {{"transmissionFactor", 1}}}}}};
  EXPECT_THAT(remarksOn("glass", 0.8, clear), HasSubstr("material 'glass' is transparent"));
  const nlohmann::ordered_json dull = {
      {"extensions", {{"KHR_materials_transmission", {{"transmissionFactor", 0.1}}}}}};
  EXPECT_THAT(remarksOn("glass", 0.8, dull), HasSubstr("called glass but opaque"));
}

}  // namespace
}  // namespace fiatlux
