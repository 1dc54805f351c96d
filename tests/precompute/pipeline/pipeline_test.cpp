// From a model's bytes to a scene file's, with nothing but what a host lends (scene_build, provenance).
#include "precompute/pipeline/pipeline.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "precompute/pipeline/provenance.h"
#include "tests/precompute/pipeline/box_model.h"

namespace fiatlux {
namespace {

using testing::boxModel;
using testing::boxRoom;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using testing::plainHost;
using testing::quickOptions;
using testing::TestGltf;

/// Writes down what it is told; every stage takes two seconds. Stops at the stage that is named.
struct Listener : Progress {
  std::vector<std::string> stages;
  std::string last;
  void begin(const std::string& stage) override { stages.push_back(stage); }
  void update(double fraction) override {
    EXPECT_GE(fraction, 0);
    EXPECT_LE(fraction, 1);
  }
  bool stopped() override { return !last.empty() && !stages.empty() && stages.back() == last; }
  std::vector<StageSeconds> seconds() override {
    std::vector<StageSeconds> seconds;
    for (const std::string& stage : stages) seconds.push_back({stage, 2});
    return seconds;
  }
};

nlohmann::json provenanceOf(const std::vector<std::uint8_t>& file) {
  const auto table = readSceneTable(file);
  const auto bytes = inflateSection(file, *table->find("provenance"));
  return nlohmann::json::parse(bytes->begin(), bytes->end());
}

TEST(Pipeline, MakesASceneThatReadsBack) {
  const auto made = makeScene(boxModel(), quickOptions(), plainHost());
  ASSERT_TRUE(made) << made.error().message;
  const auto scene = readScene(made->file);
  ASSERT_TRUE(scene) << scene.error().message;
  EXPECT_EQ(scene->identity, made->report.identity);
  EXPECT_EQ(scene->patches.count, made->report.patches);
  EXPECT_EQ(scene->patches.clusterCount, made->report.clusters);
  EXPECT_EQ(scene->sites.size(), made->report.sites);
  EXPECT_EQ(scene->surfaces.size(), made->report.surfaces);
  EXPECT_EQ(made->report.sites, 20u);
  EXPECT_EQ(made->report.lost, 0);
  EXPECT_LT(made->report.errors.mean, 1e-5);
  EXPECT_THAT(made->warnings, IsEmpty());
}

TEST(Pipeline, TheSameOnAnyNumberOfThreadsAndWithoutAListener) {
  const auto alone = makeScene(boxModel(), quickOptions(), plainHost());
  Host host = plainHost();
  Listener listener;
  host.threads = 3;
  host.progress = &listener;
  const auto watched = makeScene(boxModel(), quickOptions(), host);
  ASSERT_TRUE(alone && watched);
  EXPECT_EQ(readScene(alone->file)->responses.illuminance, readScene(watched->file)->responses.illuminance);
  EXPECT_EQ(alone->report.identity, watched->report.identity);
}

TEST(Pipeline, ThePlanOfAMadeRoomIsCarriedAlong) {
  const auto planAfter = [](const std::string& plan) {
    testing::TestGltf gltf = testing::boxRoom({4, 3, 5}, 1);
    const std::string extras = R"({"fiatlux":{"plan":)" + plan + "}}";
    gltf.glb.json["scenes"][0]["extras"] = nlohmann::ordered_json::parse(extras);
    const auto made = makeScene({"box.glb", gltf.glb.bytes()}, quickOptions(), plainHost());
    if (!made) return made.error().message;
    const nlohmann::json account = provenanceOf(made->file);
    return account.contains("plan") ? account["plan"].dump() : std::string();
  };
  EXPECT_EQ(planAfter(R"([2,"Studio",2800,[0,0,4000,0]])"), R"([2,"Studio",2800,[0,0,4000,0]])");
  EXPECT_EQ(planAfter(R"("text")"), "");
  EXPECT_EQ(planAfter("[\"" + std::string(1 << 16, 'x') + "\"]"), "");
}

TEST(Pipeline, ItsAccountTellsTheSourceTheOptionsAndTheSecondsOfTheHost) {
  Host host = plainHost();
  Listener listener;
  host.progress = &listener;
  const auto made = makeScene(boxModel(), quickOptions(), host);
  ASSERT_TRUE(made) << made.error().message;
  EXPECT_THAT(listener.stages,
              ElementsAre("reading", "patches", "form factors", "direct light", "low-rank radiosity",
                          "interreflection", "statistics", "display mesh", "scene file"));
  const nlohmann::json account = provenanceOf(made->file);
  EXPECT_EQ(account["source"]["file"], "box.glb");
  EXPECT_EQ(account["options"]["rays"], 32);
  EXPECT_EQ(account["seconds"]["form factors"], 2);
  EXPECT_EQ(account["seconds"]["before the file"], 18);
  EXPECT_EQ(account["fewPatches"].size(), 6u);
  ASSERT_GE(account["residuals"].size(), 2u);
  EXPECT_LE(account["residuals"].back(), kSettled);

  const auto unclocked = makeScene(boxModel(), quickOptions(), plainHost());
  ASSERT_TRUE(unclocked);
  EXPECT_EQ(provenanceOf(unclocked->file)["seconds"], nlohmann::json::object());
}

TEST(Pipeline, WhatAPersonSaidOfTheModelIsRememberedAndMakesAnotherRoom) {
  const auto plain = openRoom(boxModel(), quickOptions().room, plainHost());
  SceneOptions options = quickOptions();
  options.room.reflectances = {{"grey", 0.2}};
  options.room.plane = 0.75;
  const auto made = makeScene(boxModel(), options, plainHost());
  ASSERT_TRUE(made) << made.error().message;
  const nlohmann::json chosen = provenanceOf(made->file)["options"];
  EXPECT_EQ(chosen["reflectance"], nlohmann::json({{"grey", 0.2}}));
  EXPECT_EQ(chosen["plane"], 0.75);
  EXPECT_EQ(chosen["planeRim"], 0.5);
  EXPECT_EQ(chosen["up"], "y");
  EXPECT_NE(made->report.identity, identityOf(quickOptions(), plain->room));
  EXPECT_EQ(made->report.surfaces, plain->room.surfaces.size() + 1);
}

TEST(Pipeline, WarningsAreToldAsSoonAsTheRoomIsKnown) {
  TestGltf gltf = boxRoom({4, 3, 5}, 1);
  gltf.glb.json["scenes"][0]["nodes"].erase(3);  // a wall is missing
  Host host = plainHost();
  Listener listener;
  host.progress = &listener;
  std::vector<std::string> told;
  host.warn = [&](const std::vector<std::string>& warnings) {
    told = warnings;
    EXPECT_EQ(listener.stages.back(), "patches");
  };
  const auto made = makeScene({"open.glb", gltf.glb.bytes()}, quickOptions(), host);
  ASSERT_TRUE(made) << made.error().message;
  ASSERT_FALSE(told.empty());
  EXPECT_THAT(told.back(), HasSubstr("the room is open"));
  EXPECT_EQ(made->warnings, told);
  EXPECT_GT(made->report.lost, 0.01);
}

TEST(Pipeline, EndsWhereItsListenerStops) {
  for (const char* stage : {"reading", "form factors", "direct light", "statistics"}) {
    Host host = plainHost();
    Listener listener;
    listener.last = stage;
    host.progress = &listener;
    const auto made = makeScene(boxModel(), quickOptions(), host);
    ASSERT_FALSE(made) << stage;
    EXPECT_EQ(made.error().message, "stopped");
    EXPECT_EQ(listener.stages.back(), stage);
  }
}

TEST(Pipeline, SiblingsComeFromTheHost) {
  TestGltf gltf = boxRoom({4, 3, 5}, 1);
  const std::vector<std::uint8_t> glb = gltf.glb.bytes();
  const std::size_t text = glb[12] | glb[13] << 8 | glb[14] << 16;
  const std::vector<std::uint8_t> bin(glb.begin() + 20 + static_cast<std::ptrdiff_t>(text) + 8, glb.end());
  gltf.glb.json["buffers"][0]["uri"] = "box.bin";
  const std::string json = gltf.glb.json.dump();
  const ModelFile model{"box.gltf", {json.begin(), json.end()}};
  const auto alone = makeScene(model, quickOptions(), plainHost());
  ASSERT_FALSE(alone);
  EXPECT_THAT(alone.error().message, HasSubstr("stands alone"));
  Host host = plainHost();
  host.resolve = [&](const std::string& name) -> Result<std::optional<std::vector<std::uint8_t>>> {
    EXPECT_EQ(name, "box.bin");
    return std::optional(bin);
  };
  const auto made = makeScene(model, quickOptions(), host);
  ASSERT_TRUE(made) << made.error().message;
  EXPECT_EQ(made->report.sites, 20u);
}

}  // namespace
}  // namespace fiatlux
