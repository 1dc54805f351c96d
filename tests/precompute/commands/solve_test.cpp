// solve and alpha from files to files: one JSON document on standard output, layouts written whole, errors in
// one line.
#include <gtest/gtest.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <sstream>

#include "core/scene/scene_sections.h"
#include "precompute/base/error.h"
#include "precompute/commands/commands.h"
#include "precompute/files/files_on_disk.h"
#include "precompute/files/scene_io.h"
#include "tests/core/corridor_scene.h"

namespace fiatlux {
namespace {

using Json = nlohmann::json;

class SearchCommands : public ::testing::Test {
 protected:
  void SetUp() override {
    folder_ = std::filesystem::path(::testing::TempDir()) /
              ("fiatlux-" + std::string(::testing::UnitTest::GetInstance()->current_test_info()->name()));
    std::filesystem::create_directories(folder_);
    const Scene& scene = fiatlux::testing::smallRoom();
    auto sections = encodeScene(scene);
    ASSERT_TRUE(sections) << sections.error().message;
    ASSERT_TRUE(replaceFile(path("room.flux"), assembleSceneFile(scene.identity, countsOf(scene),
                                                                 storeSections(*sections, zlibDeflate))));
  }
  void TearDown() override { std::filesystem::remove_all(folder_); }

  std::string path(const std::string& name) const { return (folder_ / name).string(); }
  void write(const std::string& name, const std::string& text) { std::ofstream(path(name)) << text; }
  std::string read(const std::string& name) {
    std::ostringstream text;
    text << std::ifstream(path(name)).rdbuf();
    return text.str();
  }

  /// Standard output of a command line.
  std::string run(std::vector<std::string> arguments) {
    CLI::App app;
    addSolveCommand(app);
    addAlphaCommand(app);
    addEvaluateCommand(app);
    std::reverse(arguments.begin(), arguments.end());
    ::testing::internal::CaptureStdout();
    try {
      app.parse(arguments);
    } catch (...) {
      ::testing::internal::GetCapturedStdout();
      throw;
    }
    return ::testing::internal::GetCapturedStdout();
  }

  std::filesystem::path folder_;
};

TEST_F(SearchCommands, SolveWritesItsBestLayoutAndOneJsonDocument) {
  write("i.json", R"({"luminaires": {"count": 3, "flux": 1000},
    "goals": [{"surface": "yellow wall", "statistic": "mean", "sense": "max"}],
    "constraints": [{"surface": "floor", "statistic": "mean", "min": 1e6}]})");
  const Json report = Json::parse(run({"solve", path("room.flux"), "--intentions", path("i.json"), "--runs",
                                       "2", "--json", "-o", path("l.json")}));
  ASSERT_EQ(report["runs"].size(), 2u);
  const Json& first = report["runs"][0];
  EXPECT_EQ(first["layout"]["luminaires"].size(), 3u);
  EXPECT_EQ(first["surfaces"].size(), 4u);
  EXPECT_NEAR(first["goal"].get<double>(), first["surfaces"][2]["mean"].get<double>(),
              1e-6 * first["goal"].get<double>());
  EXPECT_EQ(first["violations"].size(), 1u);
  EXPECT_EQ(first["evaluations"], 25000);
  const Json layout = Json::parse(read("l.json"));
  EXPECT_EQ(layout["luminaires"].size(), 3u);
  EXPECT_EQ(layout["dimming"], 1);
}

TEST_F(SearchCommands, SolveListsSurfacesAsEvaluateDoes) {
  write("i.json", R"({"luminaires": {"count": 3, "flux": 1000, "dimming": [0.5, 0.5]},
    "goals": [{"surface": "floor", "statistic": "sigma", "sense": "min"}]})");
  const Json solved = Json::parse(
      run({"solve", path("room.flux"), "--intentions", path("i.json"), "--json", "-o", path("l.json")}));
  const Json evaluated =
      Json::parse(run({"evaluate", path("room.flux"), "--layout", path("l.json"), "--json"}));
  EXPECT_EQ(solved["runs"][0]["surfaces"], evaluated["surfaces"]);
  EXPECT_EQ(solved["runs"][0]["grids"], evaluated["grids"]);
  EXPECT_EQ(evaluated["grids"][0]["surface"], "floor");
  EXPECT_EQ(evaluated["grids"][0]["points"], 42);
}

TEST_F(SearchCommands, SolveAimsAtATarget) {
  write("i.json", R"({"luminaires": {"count": 3, "flux": 1000, "dimming": [0.05, 1]},
    "goals": [{"surface": "floor", "statistic": "mean", "sense": "near", "target": 20}]})");
  const Json report =
      Json::parse(run({"solve", path("room.flux"), "--intentions", path("i.json"), "--bound", "--json"}));
  EXPECT_NEAR(report["runs"][0]["surfaces"][0]["mean"].get<double>(), 20, 1e-3);
  EXPECT_NEAR(report["runs"][0]["goal"].get<double>(), 0, 1e-6);
  EXPECT_EQ(report["bound"]["within"], 0);
  EXPECT_NE(
      run({"solve", path("room.flux"), "--intentions", path("i.json")}).find("mean of floor near 20 lx: "),
      std::string::npos);
  write("alpha.json", R"({"goals": [{"surface": "floor", "statistic": "mean", "sense": "near", "target": 20}],
    "constraints": [{"surface": "floor", "statistic": "minimum", "min": 3}]})");
  EXPECT_THROW(run({"alpha", path("room.flux"), "--intentions", path("alpha.json")}), CommandError);
}

TEST_F(SearchCommands, AContrastAgainstDarknessIsInfinite) {
  Scene scene = fiatlux::testing::smallRoom();
  for (std::uint32_t j = 0; j < scene.responses.sites; ++j)
    for (std::uint32_t p = 0; p < scene.responses.rows; ++p)
      if (scene.patches.surface[p] >= 2)
        scene.responses.illuminance[std::size_t{j} * scene.responses.rows + p] = 0;
  fiatlux::testing::addStatistics(scene);
  auto sections = encodeScene(scene);
  ASSERT_TRUE(sections) << sections.error().message;
  const std::vector<std::uint8_t> file =
      assembleSceneFile(scene.identity, countsOf(scene), storeSections(*sections, zlibDeflate));
  ASSERT_TRUE(replaceFile(path("dark.flux"), file));
  write("i.json", R"({"luminaires": {"count": 2},
    "goals": [{"surface": "floor", "over": "walls", "statistic": "contrast", "sense": "max"}],
    "constraints": [{"surface": "floor", "over": "walls", "statistic": "contrast", "min": 3},
                    {"surface": "yellow wall", "over": "walls", "statistic": "contrast", "min": 3}]})");
  const std::vector<std::string> solve = {"solve", path("dark.flux"), "--intentions", path("i.json")};
  std::vector<std::string> asJson = solve;
  asJson.push_back("--json");
  const Json report = Json::parse(run(asJson))["runs"][0];
  EXPECT_TRUE(report["goal"].is_null());
  ASSERT_EQ(report["violations"].size(), 1u);
  EXPECT_EQ(report["violations"][0]["constraint"], 2);
  EXPECT_TRUE(report["violations"][0]["value"].is_null());
  const std::string text = run(solve);
  EXPECT_NE(text.find("contrast of floor infinite (at least 3): met"), std::string::npos) << text;
  EXPECT_NE(text.find("contrast of yellow wall undefined (at least 3): NOT met"), std::string::npos) << text;
}

TEST_F(SearchCommands, TheSameSeedGivesTheSameLayout) {
  write(
      "i.json",
      R"({"luminaires": {"count": 4}, "goals": [{"surface": "all", "statistic": "sigma", "sense": "min"}]})");
  run({"solve", path("room.flux"), "--intentions", path("i.json"), "--seed", "9", "-o", path("a.json")});
  run({"solve", path("room.flux"), "--intentions", path("i.json"), "--seed", "9", "-o", path("b.json")});
  EXPECT_EQ(read("a.json"), read("b.json"));
}

TEST_F(SearchCommands, AlphaListsItsIterations) {
  write(
      "i.json",
      R"({"luminaires": {"count": 3, "flux": 1000}, "goals": [{"surface": "floor", "statistic": "mean", "sense": "min"}],
    "constraints": [{"surface": "floor", "statistic": "minimum", "min": 30}]})");
  const Json report = Json::parse(
      run({"alpha", path("room.flux"), "--intentions", path("i.json"), "--evaluations", "2000", "--json"}));
  EXPECT_GE(report["iterations"].size(), 1u);
  EXPECT_FALSE(report["verdict"].get<std::string>().empty());
  for (const Json& iteration : report["iterations"]) {
    EXPECT_TRUE(iteration["region"] == "I" || iteration["region"] == "II" || iteration["region"] == "III");
  }
}

TEST_F(SearchCommands, ErrorsNameFileAndCureAndWriteNothing) {
  write("bad.json", R"({"goals": [{"surface": "yellow wal", "statistic": "sigma", "sense": "min"}]})");
  try {
    run({"solve", path("room.flux"), "--intentions", path("bad.json"), "-o", path("l.json")});
    FAIL() << "no error";
  } catch (const CommandError& error) {
    EXPECT_NE(std::string(error.what()).find("bad.json: goal 1.surface: no surface is called \"yellow wal\""),
              std::string::npos)
        << error.what();
  }
  EXPECT_FALSE(std::filesystem::exists(path("l.json")));
  EXPECT_THROW(run({"solve", path("none.flux"), "--intentions", path("bad.json")}), CommandError);
  EXPECT_THROW(run({"alpha", path("bad.json"), "--intentions", path("bad.json")}), CommandError);
  EXPECT_THROW(run({"solve", path("room.flux"), "--intentions", path("none.json")}), CommandError);
}

}  // namespace
}  // namespace fiatlux
