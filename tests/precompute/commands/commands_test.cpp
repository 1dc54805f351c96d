// The command (precompute_command, info, evaluate with its photometric_layout and planes_json, solve with its
// asked_search, light with its light_report, experiments) as a person meets it: results that are right,
// failures of one clear line with status 2, and what an interrupt leaves.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "precompute/files/scene_io.h"
#include "tests/core/photometry/photometric_files.h"
#include "tests/precompute/commands/command_run.h"

namespace fiatlux {
namespace {

using nlohmann::json;
using ::testing::HasSubstr;
using ::testing::Not;

/// A box room and its scene file, made once.
class Commands : public ::testing::Test {
 protected:
  static void SetUpTestSuite() {
    folder_ = new TemporaryFolder;
    writeBoxRoom(*folder_, "box");
    made_ = runFiatlux(*folder_, "precompute box.gltf -o box.flux --patch 0.25 --rays 512");
    writeTextFile(*folder_ / "layout.json",
                  R"({"luminaires": [{"site": 4, "flux": 1000}, {"site": 7, "flux": 500}]})");
  }
  static void TearDownTestSuite() { delete folder_; }

  /// One clear line at the end of standard error, status 2, and no new file.
  static std::string failure(const std::string& arguments) {
    const std::size_t files = folder_->files();
    const CommandRun run = runFiatlux(*folder_, arguments);
    EXPECT_EQ(run.status, 2) << arguments << "\n" << run.err;
    EXPECT_EQ(run.out, "") << arguments;
    EXPECT_LE(std::count(run.err.begin(), run.err.end(), '\n'), 4) << run.err;
    EXPECT_EQ(folder_->files(), files) << arguments;
    return run.err;
  }

  static TemporaryFolder* folder_;
  static CommandRun made_;
};
TemporaryFolder* Commands::folder_ = nullptr;
CommandRun Commands::made_;

TEST_F(Commands, PrecomputeMakesASceneFile) {
  EXPECT_EQ(made_.status, 0) << made_.err;
  EXPECT_THAT(made_.out, HasSubstr("1056 patches"));
}

TEST_F(Commands, InfoTellsWhatIsInIt) {
  const CommandRun run = runFiatlux(*folder_, "info box.flux --json");
  ASSERT_EQ(run.status, 0) << run.err;
  const json info = json::parse(run.out);
  EXPECT_EQ(info["patches"], 1056);
  EXPECT_EQ(info["sites"], 12);
  EXPECT_EQ(info["receivers"], 0);
  EXPECT_EQ(info["identity"].get<std::string>().size(), 16u);
  ASSERT_EQ(info["surfaces"].size(), 6u);
  ASSERT_TRUE(info["fewPatches"].is_array());
  for (const json& surface : info["surfaces"]) {
    const bool told = std::count(info["fewPatches"].begin(), info["fewPatches"].end(), surface["name"]) == 1;
    EXPECT_EQ(told, surface["patches"].get<int>() < 100) << surface;
  }
  EXPECT_EQ(info["surfaces"][0]["name"], "floor");
  EXPECT_NEAR(info["surfaces"][0]["area"].get<double>(), 12, 1e-9);
  EXPECT_NEAR(info["surfaces"][0]["reflectance"].get<double>(), 0.5, 1e-6);
  EXPECT_NEAR(info["surfaces"][0]["lost"].get<double>(), 0, 1e-3);
  EXPECT_LT(info["errors"]["sigma"].get<double>(), 1e-4);
  EXPECT_LT(info["errors"]["mean"].get<double>(), 1e-4);
  EXPECT_LT(info["errors"]["patchRmsMedian"].get<double>(), 0.005);
  EXPECT_TRUE(info["seconds"].contains("form factors"));
  EXPECT_GT(info["exchange"]["groups"], 20);
  EXPECT_GT(info["exchange"]["visibilityBytes"], 0);
  EXPECT_GT(info["exchange"]["exchangeBytes"], 1000);
  EXPECT_LT(info["exchangeErrors"]["spot"]["meanMedian"], 0.01);
  double bytes = 0;
  for (const json& section : info["sections"]) bytes += section["bytes"].get<double>();
  EXPECT_GT(bytes, 1000);
  EXPECT_THAT(runFiatlux(*folder_, "info box.flux").out, HasSubstr("1056 patches"));
  EXPECT_THAT(runFiatlux(*folder_, "info box.flux").out, HasSubstr("groups, visibility"));
}

TEST_F(Commands, EvaluateKeepsTheEnergyBalance) {
  const CommandRun run =
      runFiatlux(*folder_, "evaluate box.flux --layout layout.json --json --patches patches.csv");
  ASSERT_EQ(run.status, 0) << run.err;
  const json result = json::parse(run.out);
  // A closed room of one reflectance: sum of A (1 - rho) E = flux.
  double absorbed = 0;
  for (const json& s : result["surfaces"])
    absorbed += s["area"].get<double>() * (1 - s["reflectance"].get<double>()) * s["mean"].get<double>();
  EXPECT_NEAR(absorbed, 1500, 0.005 * 1500);
  EXPECT_NEAR(result["all"]["mean"].get<double>(), 1500 / (0.5 * 66), 0.005 * 1500 / 33);
  EXPECT_EQ(result["power"], 1500);
  const json& floor = result["surfaces"][0];
  EXPECT_NEAR(floor["exitance"]["mean"].get<double>(), 0.5 * floor["mean"].get<double>(), 1e-3);
  EXPECT_LE(floor["min"], floor["mean"]);
  EXPECT_GE(floor["max"], floor["mean"]);
  EXPECT_EQ(result["layout"]["luminaires"][0]["site"], 4);
  // The patches say the same.
  const std::string csv = textOfFile(*folder_ / "patches.csv");
  EXPECT_EQ(csv.substr(0, csv.find('\n')), "surface,x,y,z,nx,ny,nz,area,reflectance,illuminance,exitance");
  EXPECT_EQ(std::count(csv.begin(), csv.end(), '\n'), 1057);
}

TEST_F(Commands, LightSaysWhatEvaluateSays) {
  writeTextFile(*folder_ / "points.csv", "x,y,z,nx,ny,nz\n2,0,1.5,0,1,0\n");
  const std::string line =
      "light box.gltf --layout layout.json --patch 0.25 --rays 512 --points points.csv --grid";
  const CommandRun run = runFiatlux(*folder_, line + " --json --patches lit.csv");
  ASSERT_EQ(run.status, 0) << run.err;
  const json lit = json::parse(run.out);
  const json evaluated =
      json::parse(runFiatlux(*folder_, "evaluate box.flux --layout layout.json --json").out);
  for (std::size_t s = 0; s < 6; ++s) {
    const double mean = evaluated["surfaces"][s]["mean"];
    EXPECT_NEAR(lit["surfaces"][s]["mean"].get<double>(), mean, 0.01 * mean) << lit["surfaces"][s]["name"];
  }
  EXPECT_NEAR(lit["energy"]["absorbed"].get<double>(), 1500, 0.005 * 1500);
  ASSERT_EQ(lit["points"].size(), 1u);
  EXPECT_GT(lit["points"][0]["total"], lit["points"][0]["direct"]);
  ASSERT_EQ(lit["grids"].size(), evaluated["grids"].size());
  for (std::size_t g = 0; g < lit["grids"].size(); ++g) {
    const json &rays = lit["grids"][g], &patches = evaluated["grids"][g];
    for (const char* same : {"surface", "points", "spacing", "rim"}) EXPECT_EQ(rays[same], patches[same]);
    EXPECT_NEAR(patches["mean"].get<double>(), rays["mean"], 0.01 * rays["mean"].get<double>());
    EXPECT_NEAR(patches["min"].get<double>(), rays["min"], 0.05 * rays["min"].get<double>());
  }
  EXPECT_EQ(lit["grids"][0]["surface"], "floor");
  const std::string csv = textOfFile(*folder_ / "lit.csv");
  EXPECT_EQ(std::count(csv.begin(), csv.end(), '\n'), 1057);

  const std::string table = runFiatlux(*folder_, line).out;
  for (const char* part : {"floor", "energy: 1500 lm emitted", "grid on floor", "direct,total"})
    EXPECT_THAT(table, HasSubstr(part));
}

TEST_F(Commands, DirectLightIsToldApart) {
  writeTextFile(*folder_ / "direct.json", R"({"quantity": "direct", "luminaires": [
      {"site": 4, "flux": 1000}, {"site": 7, "flux": 500}]})");
  const CommandRun light =
      runFiatlux(*folder_, "light box.gltf --layout direct.json --patch 0.25 --rays 16 --json");
  const CommandRun evaluate = runFiatlux(*folder_, "evaluate box.flux --layout direct.json --json");
  ASSERT_EQ(light.status + evaluate.status, 0) << light.err << evaluate.err;
  const json lit = json::parse(light.out), evaluated = json::parse(evaluate.out);
  EXPECT_TRUE(lit["directOnly"].get<bool>() && evaluated["directOnly"].get<bool>());
  for (std::size_t s = 0; s < 6; ++s) {
    const json &truth = lit["surfaces"][s], &got = evaluated["surfaces"][s];
    EXPECT_NEAR(got["mean"].get<double>(), truth["mean"].get<double>(),
                0.01 * (truth["mean"].get<double>() + 1));
    EXPECT_NEAR(got["min"].get<double>(), truth["min"].get<double>(),
                0.05 * (truth["mean"].get<double>() + 1));
  }
  const CommandRun flag = runFiatlux(*folder_, "evaluate box.flux --layout layout.json --direct-only --json");
  EXPECT_EQ(json::parse(flag.out)["surfaces"], evaluated["surfaces"]);

  // The search counts it where it is asked for, beside all light.
  writeTextFile(*folder_ / "emergency.json", R"({"luminaires": {"count": 2, "flux": 750}, "constraints": [
      {"statistic": "mean", "surface": "floor", "min": 1000, "quantity": "direct"},
      {"statistic": "mean", "surface": "floor", "min": 1000}]})");
  const json run =
      json::parse(runFiatlux(*folder_, "solve box.flux --intentions emergency.json --evaluations 500 --json")
                      .out)["runs"][0];
  ASSERT_EQ(run["violations"].size(), 2u);
  EXPECT_EQ(run["violations"][0]["quantity"], "direct");
  EXPECT_LT(run["violations"][0]["value"], run["violations"][1]["value"]);
  writeTextFile(*folder_ / "found.json", run["layout"].dump());
  const json found =
      json::parse(runFiatlux(*folder_, "evaluate box.flux --layout found.json --direct-only --json").out);
  const double mean = found["surfaces"][0]["mean"];
  EXPECT_NEAR(run["violations"][0]["value"].get<double>(), mean, 0.01 * mean);
}

TEST_F(Commands, FacesOnAPlaneAreLitInEvaluateAndSolveAsInLight) {
  writeBoxRoom(*folder_, "office", true, true);
  samples::IesFile spot;
  spot.candela = samples::cosinePower(3000, 4);
  spot.width = spot.length = 0.3;
  writeTextFile(*folder_ / "spot.ies", spot.text());
  const std::string options = "--patch 0.25 --rays 512 --site-size 0.5 --measure plane";
  const CommandRun made = runFiatlux(*folder_, "precompute office.gltf -o office.flux " + options);
  ASSERT_EQ(made.status, 0) << made.err;
  writeTextFile(*folder_ / "faces.json", R"({"dimming": 0.5, "luminaires": [{"site": 4, "flux": 1000},
      {"site": 1, "photometry": "spot.ies"}], "planes": [{"surface": "plane", "directions": [[2, 0, 0], [-1, 0, 1]]}]})");
  const CommandRun light = runFiatlux(*folder_, "light office.gltf --layout faces.json --json " + options);
  ASSERT_EQ(light.status, 0) << light.err;
  const CommandRun evaluate = runFiatlux(*folder_, "evaluate office.flux --layout faces.json --json");
  ASSERT_EQ(evaluate.status, 0) << evaluate.err;
  const json truth = json::parse(light.out)["planes"][0], got = json::parse(evaluate.out)["planes"][0];
  EXPECT_EQ(got["surface"], "plane");
  EXPECT_EQ(got["points"], truth["points"]);
  const auto expectSame = [](const json& value, const json& expected) {
    EXPECT_NEAR(value["mean"].get<double>() / expected["mean"].get<double>(), 1, 0.02) << expected << value;
    EXPECT_NEAR(value["min"].get<double>() / expected["min"].get<double>(), 1, 0.04) << expected << value;
  };
  for (const char* what : {"horizontal", "cylindrical", "modelling"}) expectSame(got[what], truth[what]);
  ASSERT_EQ(got["vertical"].size(), 2u);
  EXPECT_EQ(got["vertical"][0]["direction"], json({1, 0, 0}));
  for (int i : {0, 1}) expectSame(got["vertical"][i], truth["vertical"][i]);

  // The search reads of squares what evaluate reads of its layout.
  writeTextFile(*folder_ / "wishes.json", R"({"luminaires": {"count": 2, "flux": 1500}, "constraints": [
      {"statistic": "cylindrical", "surface": "plane", "min": 1000, "of": "minimum"},
      {"statistic": "modelling", "surface": "plane", "min": 5},
      {"statistic": "vertical", "surface": "plane", "min": 1000, "direction": [0, 0, 1]}]})");
  const CommandRun solve =
      runFiatlux(*folder_, "solve office.flux --intentions wishes.json --evaluations 300 --json");
  ASSERT_EQ(solve.status, 0) << solve.err;
  const json run = json::parse(solve.out)["runs"][0];
  ASSERT_EQ(run["violations"].size(), 3u);
  json layout = run["layout"];
  layout["planes"] = {{{"surface", "plane"}, {"directions", {{0, 0, 1}}}}};
  writeTextFile(*folder_ / "found.json", layout.dump());
  const json found =
      json::parse(runFiatlux(*folder_, "evaluate office.flux --layout found.json --json").out)["planes"][0];
  const double values[] = {found["cylindrical"]["min"], found["modelling"]["mean"],
                           found["vertical"][0]["mean"]};
  for (std::size_t c = 0; c < 3; ++c)
    EXPECT_NEAR(run["violations"][c]["value"].get<double>() / values[c], 1, 1e-3) << run["violations"][c];
  EXPECT_EQ(run["violations"][0]["of"], "minimum");
  EXPECT_THAT(runFiatlux(*folder_, "solve office.flux --intentions wishes.json --evaluations 300").out,
              HasSubstr("least cylindrical of plane"));
  writeTextFile(*folder_ / "bad.json", R"({"luminaires": [{"site": 4, "flux": 9}], "planes": ["floor"]})");
  EXPECT_THAT(failure("evaluate office.flux --layout bad.json"), HasSubstr("is no measuring plane"));
}

TEST_F(Commands, PhotometricFilesShineInEvaluateAsInLight) {
  samples::IesFile spot;
  spot.candela = samples::cosinePower(3000, 4);
  writeTextFile(*folder_ / "spot.ies", spot.text());
  writeTextFile(*folder_ / "spots.json", R"({"dimming": 0.5, "luminaires": [
      {"site": 1, "photometry": "spot.ies", "size": [0.1, 0.1], "aim": [2, 0, 2]},
      {"site": 7, "photometry": "spot.ies", "size": [0.6, 0.2], "turn": 90, "flux": 2000},
      {"site": 4, "flux": 1000}],
      "observers": [{"name": "door", "position": [0.3, 1.2, 1], "direction": [3, 0, 0.5]},
                    {"position": [3.5, 1.7, 2.5], "direction": [-1, 0, -0.4]}]})");
  // As fine for its size as the sample rooms are, so that groups of 4 x 4 patches are small beside the room.
  const std::string fine = "--patch 0.125 --rays 256 --site-size 0.5";
  ASSERT_EQ(runFiatlux(*folder_, "precompute box.gltf -o fine.flux " + fine).status, 0);
  const CommandRun light = runFiatlux(*folder_, "light box.gltf --layout spots.json --json " + fine);
  ASSERT_EQ(light.status, 0) << light.err;
  const CommandRun evaluate = runFiatlux(*folder_, "evaluate fine.flux --layout spots.json --json");
  ASSERT_EQ(evaluate.status, 0) << evaluate.err;
  const json lit = json::parse(light.out), evaluated = json::parse(evaluate.out);
  ASSERT_EQ(evaluated["surfaces"].size(), 6u);
  for (std::size_t s = 0; s < 6; ++s) {
    const json &truth = lit["surfaces"][s], &got = evaluated["surfaces"][s];
    EXPECT_NEAR(got["mean"].get<double>() / truth["mean"].get<double>(), 1, 0.01) << truth;
    EXPECT_NEAR(got["sigma"].get<double>() / truth["sigma"].get<double>(), 1, 0.06) << truth;
  }
  ASSERT_EQ(evaluated["observers"].size(), 2u);
  EXPECT_EQ(evaluated["observers"][0]["name"], "door");
  EXPECT_EQ(lit["observers"][1]["name"], "observer 2");
  for (std::size_t o = 0; o < 2; ++o) {
    const json &truth = lit["observers"][o], &got = evaluated["observers"][o];
    EXPECT_NEAR(got["ugr"].get<double>(), truth["ugr"].get<double>(), 0.1) << truth << got;
    for (const char* key : {"background", "vertical", "cylindrical"})
      EXPECT_NEAR(got[key].get<double>() / truth[key].get<double>(), 1, 0.02) << key << truth;
  }
  EXPECT_THAT(runFiatlux(*folder_, "evaluate fine.flux --layout spots.json").out, HasSubstr("door: UGR"));
}

TEST_F(Commands, PhotometricFilesAreRefusedWithACure) {
  writeTextFile(*folder_ / "lamp.ies", samples::IesFile{}.text());
  writeTextFile(*folder_ / "lamp.json", R"({"luminaires": [{"site": 1, "photometry": "lamp.ies"}]})");
  ASSERT_EQ(
      runFiatlux(*folder_, "precompute box.gltf -o plain.flux --patch 0.5 --rays 64 --no-exchange").status,
      0);
  EXPECT_FALSE(json::parse(runFiatlux(*folder_, "info plain.flux --json").out).contains("exchange"));
  EXPECT_THAT(failure("evaluate plain.flux --layout lamp.json"), HasSubstr("without --no-exchange"));
  for (const char* name : {"../lamp.ies", "/etc/passwd"}) {
    writeTextFile(*folder_ / "bad.json",
                  R"({"luminaires": [{"site": 1, "photometry": ")" + std::string(name) + "\"}]}");
    const std::string error = failure("evaluate box.flux --layout bad.json");
    EXPECT_TRUE(error.find("outside the layout's folder") != std::string::npos ||
                error.find("does not exist") != std::string::npos)
        << error;
  }
  writeTextFile(*folder_ / "cut.ies", samples::IesFile{}.text().substr(0, 120));
  writeTextFile(*folder_ / "bad.json", R"({"luminaires": [{"site": 1, "photometry": "cut.ies"}]})");
  EXPECT_THAT(failure("light box.gltf --layout bad.json"), HasSubstr("line "));
}

TEST_F(Commands, SolveFindsPlacesAndTypesThatEvaluateReadsBack) {
  samples::IesFile spot, flood;
  spot.candela = samples::cosinePower(3000, 20);
  spot.width = spot.length = flood.width = flood.length = 0.1;
  std::filesystem::create_directory(*folder_ / "lamps");
  writeTextFile(*folder_ / "lamps/spot.ies", spot.text());
  writeTextFile(*folder_ / "flood.ies", flood.text());
  writeTextFile(*folder_ / "types.json", R"({"luminaires": {"count": 3, "types": [
      {"photometry": "lamps/spot.ies", "count": [1, 2], "turns": [0, 90], "aims": ["wall 1", [2, 0, 1]]},
      {"photometry": "flood.ies", "flux": 800, "watts": 7}], "fixed": [{"luminaire": 2, "photometry": "flood.ies"}]},
      "goals": [{"surface": "wall 1", "statistic": "mean", "sense": "max"}],
      "constraints": [{"statistic": "power", "max": 70}]})");
  const CommandRun run =
      runFiatlux(*folder_, "solve box.flux --intentions types.json --json --evaluations 5000 -o typed.json");
  ASSERT_EQ(run.status, 0) << run.err;
  const json solved = json::parse(run.out)["runs"][0],
             layout = json::parse(textOfFile(*folder_ / "typed.json"));
  EXPECT_EQ(solved["layout"], layout);
  ASSERT_EQ(layout["luminaires"].size(), 3u);
  EXPECT_EQ(layout["luminaires"][1]["photometry"], "flood.ies");
  EXPECT_EQ(layout["luminaires"][1]["flux"], 800);
  EXPECT_EQ(layout["luminaires"][0]["photometry"], "lamps/spot.ies");
  EXPECT_TRUE(layout["luminaires"][0].contains("aim"));
  const CommandRun evaluate = runFiatlux(*folder_, "evaluate box.flux --layout typed.json --json");
  ASSERT_EQ(evaluate.status, 0) << evaluate.err;
  const json evaluated = json::parse(evaluate.out);
  for (std::size_t s = 0; s < 6; ++s) {
    const double mean = evaluated["surfaces"][s]["mean"];
    EXPECT_NEAR(solved["surfaces"][s]["mean"].get<double>(), mean, 5e-3 * mean)
        << evaluated["surfaces"][s]["name"];
  }
  const CommandRun text = runFiatlux(*folder_, "solve box.flux --intentions types.json --evaluations 5000");
  EXPECT_THAT(text.out, HasSubstr("power 67 W (at most 70): met"));
  EXPECT_THAT(text.out, HasSubstr("lamps/spot.ies"));
}

TEST_F(Commands, SolveSeesTheRoomAsItIsPainted) {
  samples::IesFile lamp;
  lamp.width = lamp.length = 0.1;
  writeTextFile(*folder_ / "lamp.ies", lamp.text());
  for (const char* luminaires : {R"("flux": 900)", R"("types": [{"photometry": "lamp.ies", "flux": 900}])"}) {
    writeTextFile(*folder_ / "dark.json", std::string(R"({"luminaires": {"count": 2, )") + luminaires +
                                              R"(}, "paint": [{"surface": "floor", "reflectance": 0.15}],
        "goals": [{"surface": "floor", "statistic": "sigma", "sense": "min"}]})");
    const CommandRun run = runFiatlux(
        *folder_, "solve box.flux --intentions dark.json --json --evaluations 500 -o painted.json");
    ASSERT_EQ(run.status, 0) << run.err;
    const json solved = json::parse(run.out)["runs"][0];
    const CommandRun evaluate = runFiatlux(*folder_, "evaluate box.flux --layout painted.json --json");
    ASSERT_EQ(evaluate.status, 0) << evaluate.err;
    const json evaluated = json::parse(evaluate.out);
    double absorbed = 0;
    for (std::size_t s = 0; s < 6; ++s) {
      const json &surface = evaluated["surfaces"][s], &found = solved["surfaces"][s];
      const double mean = surface["mean"];
      EXPECT_NEAR(found["mean"].get<double>(), mean, 5e-3 * mean) << surface["name"];
      EXPECT_NEAR(found["reflectance"].get<double>(), surface["reflectance"].get<double>(), 1e-3);
      absorbed += surface["area"].get<double>() * (1 - surface["reflectance"].get<double>()) * mean;
    }
    EXPECT_NEAR(evaluated["surfaces"][0]["reflectance"].get<double>(), 0.15, 1e-6);
    EXPECT_NEAR(absorbed, 1800, 0.02 * 1800);
  }
  writeTextFile(*folder_ / "dark.json", R"({"paint": [{"surface": "sail", "reflectance": 0.15}]})");
  EXPECT_THAT(failure("solve box.flux --intentions dark.json"), HasSubstr("is called \"sail\""));
}

TEST_F(Commands, TypesAreRefusedWithACure) {
  std::filesystem::create_directory(*folder_ / "lamps");
  writeTextFile(*folder_ / "lamp.ies", samples::IesFile{}.text());
  const auto refusal = [](const std::string& luminaires, const std::string& more = "") {
    writeTextFile(*folder_ / "bad.json", "{\"luminaires\": {" + luminaires + "}" + more + "}");
    return failure("solve box.flux --intentions bad.json");
  };
  const std::string lamp = R"("types": [{"photometry": "lamp.ies"}])";
  EXPECT_THAT(refusal("\"flux\": 1000, " + lamp), HasSubstr("leave one of the two out"));
  EXPECT_THAT(refusal(R"("types": [{"photometry": "/etc/passwd"}])"),
              HasSubstr("outside the intentions file's folder"));
  EXPECT_THAT(refusal(R"("types": [{"photometry": "none.ies"}])"), HasSubstr("does not exist"));
  EXPECT_THAT(refusal(R"("types": [{"photometry": "lamp.ies", "count": [4, 2]}])"),
              HasSubstr("the least first"));
  EXPECT_THAT(refusal(R"("types": [{"photometry": "lamp.ies", "aims": ["flor"]}])"), HasSubstr("\"floor\""));
  EXPECT_THAT(refusal(R"("types": [{"photometry": "lamp.ies", "maxAimingAngle": 45}])"),
              HasSubstr("it is of luminaires with \"aims\""));
  EXPECT_THAT(refusal(R"("types": [{"photometry": "lamp.ies", "aims": ["wall 1"], "maxAimingAngle": 200}])"),
              HasSubstr("maxAimingAngle"));
  EXPECT_THAT(refusal(R"("types": [{"photometry": "lamp.ies", "aims": ["wall 1"], "maxAimingAngle": 0}])"),
              HasSubstr("allow a larger aiming angle"));
  EXPECT_THAT(refusal(R"("count": 3, "types": [{"photometry": "lamp.ies", "count": 2}])"),
              HasSubstr("the types allow 2 together, but the count is 3"));
  EXPECT_THAT(refusal("\"fixed\": [{\"luminaire\": 1, \"photometry\": \"x.ies\"}], " + lamp),
              HasSubstr("known are lamp.ies"));
  samples::IesFile dark;
  dark.watts = 0;
  writeTextFile(*folder_ / "dark.ies", dark.text());
  EXPECT_THAT(refusal(R"("types": [{"photometry": "dark.ies"}])",
                      R"(, "goals": [{"statistic": "power", "sense": "min"}])"),
              HasSubstr("states no watts; give \"watts\""));
  samples::IesFile wide;
  wide.width = wide.length = 9;
  writeTextFile(*folder_ / "wide.ies", wide.text());
  EXPECT_THAT(refusal(R"("types": [{"photometry": "wide.ies"}])"), HasSubstr("fits anywhere in this room"));
  writeTextFile(*folder_ / "good.json", "{\"luminaires\": {\"count\": 1, " + lamp + "}}");
  EXPECT_THAT(failure("solve box.flux --intentions good.json -o lamps/l.json"),
              HasSubstr("must lie beside it"));
}

TEST_F(Commands, ExperimentsWriteAReportWithItsPlots) {
  const CommandRun run = runFiatlux(
      *folder_, "experiments --scene box.flux --wall 'wall 1' --runs 1 --evaluations 200 -o report");
  ASSERT_EQ(run.status, 0) << run.err;
  const std::string report = textOfFile(*folder_ / "report/experiments.md");
  EXPECT_THAT(report, HasSubstr("on box.flux (1056 patches"));
  EXPECT_THAT(report, HasSubstr("](experiments/phi-of-alpha.svg)"));
  EXPECT_EQ(textOfFile(*folder_ / "report/experiments/phi-of-alpha.svg").rfind("<svg", 0), 0u);
  EXPECT_THAT(textOfFile(*folder_ / "report/experiments/runs.csv"), HasSubstr("\n5.1 min sigma,1,"));
  EXPECT_THAT(failure("experiments --scene box.flux -o other"),
              HasSubstr("no surface is called \"yellow wall\""));
}

TEST_F(Commands, TheSameOptionsGiveTheSameIdentityAndOthersAnother) {
  const auto identity = [](const char* options) {
    runFiatlux(*folder_, std::string("precompute box.gltf -o other.flux --patch 0.5 --rays 64 ") + options);
    const json info = json::parse(runFiatlux(*folder_, "info other.flux --json").out);
    return info["identity"].get<std::string>();
  };
  const std::string one = identity("--threads 1");
  EXPECT_EQ(identity("--threads 2 --memory 3"), one);
  EXPECT_NE(identity("--seed 2"), one);
  EXPECT_NE(identity("--refine 1"), one);
  EXPECT_NE(identity("--paper"), one);
}

TEST_F(Commands, AnOpeningComesBeforeTheLightAndChangesNothingElse) {
  writeTextFile(*folder_ / "wish.json", R"({"luminaires": {"count": 2, "flux": 900},
      "goals": [{"surface": "floor", "statistic": "sigma", "sense": "min"}]})");
  const std::string precompute = "precompute box.gltf -o opening.flux --patch 0.5 --rays 64 --opening ";
  ASSERT_EQ(runFiatlux(*folder_, precompute + "wish.json").status, 0);
  const json info = json::parse(runFiatlux(*folder_, "info opening.flux --json").out);
  std::vector<std::string> names;
  for (const json& section : info["sections"]) names.push_back(section["name"]);
  const auto at = [&](const char* name) {
    return std::find(names.begin(), names.end(), name) - names.begin();
  };
  EXPECT_LT(at("openingLight"), at("room"));
  EXPECT_LT(at("room"), at("responses"));
  EXPECT_LT(at("provenance"), at("responses"));
  EXPECT_THAT(failure(precompute + "none.json"), HasSubstr("none.json"));
  writeTextFile(*folder_ / "lamp.ies", samples::IesFile().text());
  const std::string types = R"({"luminaires": {"count": 2, "types": [{"photometry": "lamp.ies"}]},
      "goals": [{"surface": "floor", "statistic": "mean", "sense": "max"}]})";
  writeTextFile(*folder_ / "types.json", types);
  EXPECT_EQ(runFiatlux(*folder_, precompute + "types.json").status, 0);
  EXPECT_EQ(runFiatlux(*folder_, precompute + "'" + types + "'").status, 0);
  writeTextFile(*folder_ / "wish.json", R"({"luminaires": {"count": 2, "flux": 900},
      "goals": [{"surface": "flour", "statistic": "sigma", "sense": "min"}]})");
  EXPECT_THAT(failure(precompute + "wish.json"), HasSubstr("floor"));
}

TEST_F(Commands, PaperCarriesItsMatrices) {
  ASSERT_EQ(runFiatlux(*folder_, "precompute box.gltf -o paper.flux --patch 0.25 --rays 64 --paper").status,
            0);
  const json info = json::parse(runFiatlux(*folder_, "info paper.flux --json").out);
  std::vector<std::string> names;
  for (const json& section : info["sections"]) names.push_back(section["name"]);
  for (const char* name : {"Y", "V", "clusterMean", "clusterCovariance.5"})
    EXPECT_THAT(names, ::testing::Contains(std::string(name)));
  EXPECT_EQ(runFiatlux(*folder_, "evaluate paper.flux --layout layout.json").status, 0);
}

TEST_F(Commands, ProvenanceNeverReplacesWhatWasReadOffTheFile) {
  const std::string text = textOfFile(*folder_ / "box.flux");
  const std::vector<std::uint8_t> file(text.begin(), text.end());
  const SceneTable table = readSceneTable(file).value();
  const std::string lie = R"({"patches": "many", "sections": 3, "identity": [], "program": "another"})";
  std::vector<PlainSection> provenance;
  provenance.push_back(plainSection("provenance", ElementType::kUint8, Encoding::kPlain,
                                    static_cast<std::uint32_t>(lie.size()), 1, {lie.begin(), lie.end()}));
  std::vector<StoredSection> sections = storeSections(provenance, zlibDeflate);
  for (const SceneSection& section : table.sections) {
    const std::span<const std::uint8_t> bytes = storedBytes(file, section);
    if (section.name != "provenance") sections.push_back({section, {bytes.begin(), bytes.end()}});
  }
  const std::vector<std::uint8_t> lying = assembleSceneFile(table.identity, table.counts, sections);
  writeTextFile(*folder_ / "lying.flux", {lying.begin(), lying.end()});

  const json info = json::parse(runFiatlux(*folder_, "info lying.flux --json").out);
  EXPECT_EQ(info["patches"], table.counts.patches);
  EXPECT_EQ(info["sections"].size(), table.sections.size());
  EXPECT_EQ(info["identity"], table.identity);
  EXPECT_EQ(info["program"], "another");
  EXPECT_EQ(info["seconds"], json::object());
  EXPECT_EQ(runFiatlux(*folder_, "info lying.flux").status, 0);
}

TEST_F(Commands, BadRoomsAreRefused) {
  writeTextFile(*folder_ / "text.glb", "this is no room\n");
  EXPECT_THAT(failure("precompute text.glb -o new.flux"), HasSubstr("text.glb"));
  std::string glb = "glTF";
  glb += std::string("\x02\0\0\0\xff\xff\0\0", 8) + "{\"asset\"";
  writeTextFile(*folder_ / "cut.glb", glb);
  EXPECT_THAT(failure("precompute cut.glb -o new.flux"), HasSubstr("cut.glb"));
  std::filesystem::copy_file(*folder_ / "box.gltf", *folder_ / "alone.gltf");
  std::string alone = textOfFile(*folder_ / "alone.gltf");
  alone.replace(alone.find("box.bin"), 7, "gone.bin");
  writeTextFile(*folder_ / "alone.gltf", alone);
  EXPECT_THAT(failure("precompute alone.gltf -o new.flux"), HasSubstr("gone.bin"));
  writeTextFile(*folder_ / "empty.gltf", R"({"asset":{"version":"2.0"},"scenes":[{"nodes":[]}],"scene":0})");
  EXPECT_THAT(failure("precompute empty.gltf -o new.flux"), HasSubstr("empty.gltf"));
  EXPECT_THAT(failure("precompute gone.glb -o new.flux"), HasSubstr("gone.glb"));
  EXPECT_THAT(failure("precompute box.gltf -o ./box.gltf"), HasSubstr("the room itself"));
  EXPECT_EQ(textOfFile(*folder_ / "box.gltf").front(), '{');  // still there
  EXPECT_THAT(failure("precompute box.gltf -o new.flux --mount shelf"), HasSubstr("shelf"));
  EXPECT_THAT(failure("precompute box.gltf -o new.flux --site-spacing 9"), HasSubstr("site"));
  EXPECT_THAT(failure("precompute box.gltf -o new.flux --patch 0.01 --memory 0.1"), HasSubstr("GB"));
}

TEST_F(Commands, BadUsageIsStatusTwo) {
  EXPECT_THAT(failure("precompute box.gltf --rays many"), HasSubstr("rays"));
  EXPECT_THAT(failure("precompute box.gltf --patch -1"), HasSubstr("patch"));
  EXPECT_THAT(failure("evaluate box.flux"), HasSubstr("layout"));
  failure("");
  failure("paint box.flux");
}

TEST_F(Commands, DamagedSceneFilesAreRefused) {
  const std::string file = textOfFile(*folder_ / "box.flux");
  ASSERT_GT(file.size(), 1000u);
  writeTextFile(*folder_ / "bad.flux", file.substr(0, file.size() / 2));
  EXPECT_THAT(failure("info bad.flux"), HasSubstr("bad.flux: the file has"));
  std::string flipped = file;
  flipped[file.size() / 2] ^= 4;
  writeTextFile(*folder_ / "bad.flux", flipped);
  EXPECT_THAT(failure("info bad.flux"), HasSubstr("checksum differs"));
  EXPECT_THAT(failure("evaluate bad.flux --layout layout.json"), HasSubstr("checksum differs"));
  std::string future = file;
  future[8] = 9;
  writeTextFile(*folder_ / "bad.flux", future);
  EXPECT_THAT(failure("info bad.flux"), HasSubstr("version 9"));
  writeTextFile(*folder_ / "bad.flux", "<!doctype html>");
  EXPECT_THAT(failure("info bad.flux"), HasSubstr("not a Fiat Lux scene file"));
  EXPECT_THAT(failure("info gone.flux"), HasSubstr("no such file"));
}

TEST_F(Commands, BadLayoutsAreRefused) {
  const auto refused = [&](const char* layout) {
    writeTextFile(*folder_ / "bad.json", layout);
    return failure("evaluate box.flux --layout bad.json --json");
  };
  writeTextFile(*folder_ / "bad.json", "");
  EXPECT_THAT(refused("{"), HasSubstr("bad.json: not valid JSON"));
  EXPECT_THAT(refused(R"({"luminaires": [{"site": 12, "flux": 1}]})"), HasSubstr("sites 0 to 11"));
  EXPECT_THAT(refused(R"({"luminaires": [{"site": 1}]})"), HasSubstr("flux"));
  EXPECT_THAT(refused(R"({"luminaires": [{"site": 1, "flux": 1, "name": "x"}]})"),
              HasSubstr("bad.json: luminaires[0]: unknown key \"name\""));
  EXPECT_THAT(failure("evaluate box.flux --layout gone.json"), HasSubstr("gone.json"));
}

TEST_F(Commands, AForeignFileAsLayoutIsRefusedAtOnce) {
  std::string foreign = "[";
  while (foreign.size() < (4u << 20)) foreign += R"({"type": "Feature", "at": [1.5, 2.5]},)";
  foreign.back() = ']';
  writeTextFile(*folder_ / "foreign.json", foreign);
  EXPECT_THAT(failure("evaluate box.flux --layout foreign.json"), HasSubstr("it is larger than 2 MB"));
  // Just small enough to be read.
  writeTextFile(*folder_ / "foreign.json", foreign.substr(0, foreign.find("},", (2u << 20) - 100) + 1) + "]");
  const CommandRun run =
      runShell(*folder_, "ulimit -t 1; \"$FIATLUX\" evaluate box.flux --layout foreign.json");
  EXPECT_EQ(run.status, 2) << "refused within a second of the processor";
  EXPECT_THAT(run.err, HasSubstr("expected an object, found a list"));
}

TEST_F(Commands, NotesKeepStatusZero) {
  writeTextFile(*folder_ / "free.json",
                R"({"luminaires": [{"position": [2, 1, 1.5], "normal": [0, -1, 0], "flux": 9}]})");
  const CommandRun run = runFiatlux(*folder_, "evaluate box.flux --layout free.json --json");
  EXPECT_EQ(run.status, 0);
  EXPECT_TRUE(json::accept(run.out));
  EXPECT_THAT(run.err, HasSubstr("warning: "));
  EXPECT_THAT(run.err, HasSubstr("nearest site"));
  EXPECT_THAT(run.err, HasSubstr("ignored here, on a site: normal"));
}

TEST_F(Commands, NotesAreFew) {
  std::string same = R"({"site": 4, "flux": 1})";
  for (int i = 0; i < 30; ++i) same += R"(, {"site": 4, "flux": 1})";
  writeTextFile(*folder_ / "same.json", R"({"luminaires": [)" + same + "]}");
  const CommandRun run = runFiatlux(*folder_, "evaluate box.flux --layout same.json");
  EXPECT_EQ(run.status, 0);
  EXPECT_EQ(std::count(run.err.begin(), run.err.end(), '\n'), 11) << run.err;
  EXPECT_THAT(run.err, HasSubstr("20 more like these"));
}

TEST_F(Commands, AFullDiskLeavesNothing) {
  EXPECT_THAT(failure("precompute box.gltf -o /dev/full --patch 0.5 --rays 16"), HasSubstr("full"));
  EXPECT_THAT(failure("precompute box.gltf -o nowhere/new.flux"), HasSubstr("no such folder"));
  // A limit on the size of files breaks off the writing in the middle, as a disk that fills up does.
  const std::string before = textOfFile(*folder_ / "box.flux");
  const std::size_t files = folder_->files();
  const CommandRun run = runShell(
      *folder_, "ulimit -f 8; \"$FIATLUX\" precompute box.gltf -o box.flux --patch 0.25 --rays 16 2>&1");
  EXPECT_EQ(run.status, 2);
  EXPECT_THAT(run.out, HasSubstr("box.flux: cannot be written: it is larger than a file may be here"));
  EXPECT_EQ(folder_->files(), files);
  EXPECT_EQ(textOfFile(*folder_ / "box.flux"), before);
}

TEST_F(Commands, InterruptLeavesNothing) {
  const std::size_t files = folder_->files();
  const CommandRun run = runShell(*folder_,
                                  "timeout --preserve-status -s INT 1 \"$FIATLUX\" precompute box.gltf -o "
                                  "late.flux --patch 0.05 --rays 8192");
  EXPECT_EQ(run.status, 2);
  EXPECT_THAT(run.err, HasSubstr("stopped; nothing was written"));
  EXPECT_EQ(folder_->files(), files);
}

TEST_F(Commands, AnIgnoredHangUpStaysIgnored) {
  const CommandRun run = runShell(*folder_,
                                  "trap '' HUP; \"$FIATLUX\" precompute box.gltf -o kept.flux --patch 0.25 "
                                  "--rays 4096 & sleep 0.2; kill -HUP $!; wait $!");
  EXPECT_EQ(run.status, 0) << run.err;
  EXPECT_TRUE(std::filesystem::exists(*folder_ / "kept.flux"));
}

TEST_F(Commands, SurfacesAreListedBeforeAnythingIsComputed) {
  writeBoxRoom(*folder_, "plain", false);
  const CommandRun run = runFiatlux(*folder_, "surfaces plain.gltf --json");
  ASSERT_EQ(run.status, 0) << run.err;
  const json list = json::parse(run.out);
  ASSERT_EQ(list["surfaces"].size(), 6u);
  for (const json& surface : list["surfaces"]) {
    const std::string name = surface["name"];
    EXPECT_EQ(surface["use"], name == "ceiling" ? "mount" : name == "floor" ? "floor" : "") << name;
  }
  EXPECT_THAT(list["warnings"][0].get<std::string>(), HasSubstr("proposed to hang on 'ceiling'"));
  EXPECT_THAT(runFiatlux(*folder_, "surfaces plain.gltf").out, HasSubstr("mount"));
  std::filesystem::remove(*folder_ / "plain.gltf"), std::filesystem::remove(*folder_ / "plain.bin");
}

TEST_F(Commands, AResultOfNoUseHasAStatusOfItsOwn) {
  writeBoxRoom(*folder_, "plain", false);
  // Luminaires above the roof.
  const CommandRun run = runFiatlux(
      *folder_, "precompute plain.gltf -o plain.flux --ceiling 3.5 --patch 1 --rays 16 --no-exchange");
  EXPECT_EQ(run.status, 3) << run.err;
  EXPECT_THAT(run.err, HasSubstr("of little use: nearly all light is lost"));
  for (const char* name : {"plain.gltf", "plain.bin", "plain.flux"}) std::filesystem::remove(*folder_ / name);
}

}  // namespace
}  // namespace fiatlux
