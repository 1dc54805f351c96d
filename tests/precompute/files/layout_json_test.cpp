// layout.json in both forms, with paint (paint_json too), and what is refused.
#include "precompute/files/layout_json.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "tests/core/photometry/photometric_files.h"
#include "tests/core/synthetic_scene.h"

namespace fiatlux {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::SizeIs;

std::string errorOf(const std::string& text) {
  const Result<LayoutFile> file = parseLayout(text);
  return file ? "no error" : file.error().message;
}

TEST(LayoutJson, SitesAndPositionsBecomeSites) {
  const Scene scene = syntheticScene(40, 5);  // sites 2 m apart along x, 3 m up, z = 1
  const LayoutFile file = parseLayout(R"({"dimming": 0.5, "luminaires": [
      {"site": 3, "flux": 3000}, {"position": [2.8, 3, 1.1], "flux": 1000}]})")
                              .value();
  std::vector<std::string> notes;
  const Layout layout = layoutOnSites(file, scene, notes).value();
  EXPECT_EQ(layout.dimming, 0.5);
  EXPECT_THAT(layout.sites, ElementsAre(3u, 1u));
  EXPECT_THAT(layout.flux, ElementsAre(3000.0, 1000.0));
  EXPECT_THAT(notes, SizeIs(0));
}

TEST(LayoutJson, PaintIsOfSurfacesThatAreThere) {
  const Scene scene = syntheticScene(40, 5);
  const std::string rest = R"("luminaires": [{"site": 3, "flux": 3000}]})";
  const LayoutFile file =
      parseLayout(R"({"paint": [{"surface": "floor", "reflectance": 0.4}], )" + rest).value();
  const auto onLeaves = paintOnLeaves(file.paint, scene.surfaces);
  ASSERT_TRUE(onLeaves) << onLeaves.error().message;
  EXPECT_EQ(*onLeaves, (std::vector<SurfacePaint>{{0, 0.4}}));
  Scene painted = scene;
  setReflectance(*onLeaves, painted.patches, painted.surfaces);
  EXPECT_EQ(painted.surfaces[0].reflectance, 0.4);
  EXPECT_EQ(painted.patches.reflectance[0], 0.4f);
  EXPECT_THAT(paintOnLeaves({{"flor", 0.4}}, scene.surfaces).error().message, HasSubstr("\"floor\""));
  EXPECT_FALSE(paintOnLeaves({{"plane", 0.4}}, scene.surfaces));
  std::vector<float> light(scene.patches.rows());
  EXPECT_THAT(paintScene(file.paint, painted, light).error().message, HasSubstr("make it again"));
  EXPECT_THAT(errorOf(R"({"paint": [{"surface": "floor", "reflectance": 1}], )" + rest), HasSubstr("0.9"));
  EXPECT_THAT(errorOf(R"({"paint": [{"reflectance": 0.5}], )" + rest), HasSubstr("surface"));
}

TEST(LayoutJson, NotesTellWhatWasIgnored) {
  const Scene scene = syntheticScene(40, 5);
  const LayoutFile file = parseLayout(R"({"luminaires": [
      {"position": [2.4, 3, 1], "flux": 1, "size": [1, 1]}, {"site": 1, "flux": 1}]})")
                              .value();
  std::vector<std::string> notes;
  ASSERT_TRUE(layoutOnSites(file, scene, notes));
  EXPECT_THAT(notes, ElementsAre(HasSubstr("m away"), HasSubstr("size"), HasSubstr("holds another")));
}

TEST(LayoutJson, WhatIsWrittenIsReadBack) {
  const Scene scene = syntheticScene(40, 5);
  const Layout layout{{4, 0}, {800, 1200}, 0.7};
  std::vector<std::string> notes;
  const LayoutFile file = parseLayout(layoutJson(layout, scene).dump()).value();
  const Layout back = layoutOnSites(file, scene, notes).value();
  EXPECT_EQ(back.sites, layout.sites);
  EXPECT_EQ(back.flux, layout.flux);
  EXPECT_EQ(back.dimming, layout.dimming);
  EXPECT_THAT(notes, SizeIs(0));
}

TEST(LayoutJson, FreeLuminaires) {
  const LayoutFile file = parseLayout(R"({"dimming": 0.5, "luminaires": [
      {"position": [1, 2, 3], "normal": [0, -2, 0], "size": [0.5, 0.25], "flux": 1000},
      {"position": [0, 0, 0], "distribution": "isotropic", "flux": 10},
      {"position": [0, 0, 0], "normal": [1, 0, 0], "axis": [1, 1, 0], "size": [1, 2], "flux": 10}]})")
                              .value();
  const std::vector<Luminaire> luminaires = freeLuminaires(file, {}).value();
  ASSERT_THAT(luminaires, SizeIs(3));
  EXPECT_EQ(luminaires[0].flux, 500);
  EXPECT_EQ(luminaires[0].normal.y, -1);
  EXPECT_EQ(luminaires[0].axis.x, 1);
  EXPECT_EQ(luminaires[0].height, 0.25);
  EXPECT_EQ(luminaires[1].distribution, Luminaire::Distribution::kIsotropic);
  EXPECT_EQ(luminaires[1].width, 0);
  EXPECT_NEAR(luminaires[2].axis.y, 1, 1e-12);
}

TEST(LayoutJson, LuminairesOnTheSitesOfARoom) {
  const std::vector<Site> sites = {{{1, 3, 1}, {0, -1, 0}, {1, 0, 0}, 0.5},
                                   {{2, 3, 1}, {0, -1, 0}, {1, 0, 0}, 0.5}};
  const auto read = [&](const std::string& luminaire, const std::vector<Site>& on) {
    return freeLuminaires(parseLayout(R"({"dimming": 0.5, "luminaires": [)" + luminaire + "]}").value(), on);
  };
  const Luminaire hung = read(R"({"site": 1, "flux": 100})", sites).value()[0];
  EXPECT_EQ(hung.position.x, 2);
  EXPECT_EQ(hung.width, 0.5);
  EXPECT_EQ(hung.flux, 50);
  // What `evaluate` writes: the same square, not a point at its place.
  EXPECT_EQ(read(R"({"site": 1, "position": [2, 3, 1], "flux": 100})", sites).value()[0].width, 0.5);
  EXPECT_EQ(read(R"({"site": 1, "position": [2, 3, 1], "size": [2, 1], "flux": 1})", sites).value()[0].width,
            2);
  EXPECT_THAT(read(R"({"site": 1, "position": [1, 3, 1], "flux": 1})", sites).error().message,
              HasSubstr("luminaires[0]: site 1 of this room is not at"));
  EXPECT_THAT(read(R"({"site": 2, "flux": 1})", sites).error().message, HasSubstr("sites 0 to 1"));
  EXPECT_THAT(read(R"({"site": 2, "flux": 1})", {}).error().message, HasSubstr("--mount"));
  EXPECT_THAT(read(R"({"site": 0, "size": [1, 1], "flux": 1})", sites).value()[0].width, 0.5);
}

/// A reader that knows "spot.ies" only.
Result<std::vector<std::uint8_t>> spotFile(const std::string& name) {
  if (name != "spot.ies") return Error{"does not exist"};
  samples::IesFile file;
  file.candela = samples::cosinePower(1000, 20);
  const std::string text = file.text();
  return std::vector<std::uint8_t>(text.begin(), text.end());
}

TEST(LayoutJson, LuminairesOfPhotometricFiles) {
  const Scene scene = syntheticScene(40, 5);
  const auto file = parseLayout(R"({"dimming": 0.5, "luminaires": [
      {"site": 1, "photometry": "spot.ies", "aim": [5, 0, 1]},
      {"site": 2, "photometry": "spot.ies", "flux": 700, "turn": 90, "size": [0.2, 0.1]},
      {"position": [1, 2, 1], "photometry": "spot.ies", "normal": [1, 0, 0]}]})",
                                spotFile);
  ASSERT_TRUE(file) << file.error().message;
  ASSERT_TRUE(file->luminaires[0].photometric);
  EXPECT_GT(file->luminaires[0].flux, 100);
  const auto luminaires = freeLuminaires(*file, scene.sites);
  ASSERT_TRUE(luminaires) << luminaires.error().message;
  const Luminaire &aimed = luminaires->at(0), &turned = luminaires->at(1), &free = luminaires->at(2);
  EXPECT_GT(aimed.normal.x, 0.5);
  EXPECT_NEAR(aimed.intensity({0, 0, 1}), 500, 1e-6);
  EXPECT_NEAR(turned.flux, 350, 1e-9);
  EXPECT_NEAR(dot(turned.axis, scene.sites[2].axis), 0, 1e-9);
  EXPECT_EQ(turned.width, 0.2);
  EXPECT_EQ(turned.height, 0.1);
  EXPECT_EQ(free.position.y, 2);
  EXPECT_EQ(free.normal.x, 1);
  EXPECT_EQ(free.distribution, Luminaire::Distribution::kPhotometric);
}

TEST(LayoutJson, PhotometryIsRefusedWithItsPlace) {
  const auto error = [](const std::string& keys) {
    const auto file = parseLayout("{\"luminaires\": [{\"site\": 0, " + keys + "}]}", spotFile);
    return file ? "no error" : file.error().message;
  };
  EXPECT_THAT(error(R"("photometry": "spot.ies", "distribution": "lambertian")"),
              HasSubstr("the photometric file says it"));
  EXPECT_THAT(error(R"("photometry": "other.ies")"), HasSubstr("the file does not exist"));
  EXPECT_THAT(error(R"("photometry": 7)"), HasSubstr("expected a text"));
  EXPECT_THAT(error(R"("flux": 100, "turn": 90)"), HasSubstr("of luminaires with a \"photometry\""));
  EXPECT_THAT(error(R"("photometry": "spot.ies", "aim": [0, 0, 0], "normal": [0, 0, 1])"),
              HasSubstr("not both"));
  EXPECT_THAT(errorOf(R"({"luminaires": [{"site": 0, "photometry": "spot.ies"}]})"), HasSubstr("no folder"));
}

TEST(LayoutJson, AnAxisAlongTheBeamIsRefusedWhereverItPoints) {
  const Scene scene = syntheticScene(40, 5);
  const auto errors = [&](const std::string& keys) {
    const auto file =
        parseLayout(R"({"luminaires": [{"site": 1, "photometry": "spot.ies", )" + keys + "}]}", spotFile);
    std::vector<std::string> notes;
    const auto onSites = layoutOnSites(*file, scene, notes);
    const auto free = freeLuminaires(*file, scene.sites);
    EXPECT_EQ(bool(onSites), bool(free));  // in `evaluate` and `light` alike
    return onSites ? "no error" : onSites.error().message;
  };
  EXPECT_THAT(errors(R"("axis": [0, 1, 0])"), HasSubstr("luminaires[0]: \"axis\" must not be parallel"));
  EXPECT_THAT(errors(R"("normal": [1, 0, 0], "axis": [-2, 0, 0])"), HasSubstr("must not be parallel"));
  EXPECT_EQ(errors(R"("normal": [1, 0, 0], "axis": [1, 0, 1])"), "no error");
}

TEST(LayoutJson, BadTextIsRefusedWithItsPlace) {
  EXPECT_THAT(errorOf(""), HasSubstr("not valid JSON"));
  EXPECT_THAT(errorOf("[]"), HasSubstr("expected an object"));
  EXPECT_THAT(errorOf("{}"), HasSubstr("no \"luminaires\""));
  EXPECT_THAT(errorOf(R"({"lumnaires": []})"),
              HasSubstr("unknown key \"lumnaires\"; the closest is \"luminaires\""));
  EXPECT_THAT(
      errorOf("{\"luminaires\": [\n{\"site\": 1, \"flux\": 1},\n{\"site\": 1, \"flux\": 1, \"colour\": 2}]}"),
      HasSubstr("luminaires[1]: unknown key \"colour\""));
  EXPECT_THAT(
      errorOf("{\"luminaires\": [\n{\"site\": 1, \"flux\": 1},\n{\"site\": 1, \"flux\": 1, \"colour\": 2}]}"),
      HasSubstr("(line 3)"));
  EXPECT_THAT(errorOf(R"({"luminaires": [3]})"), HasSubstr("luminaires[0]"));
  EXPECT_THAT(errorOf(R"({"luminaires": [{"flux": 1}]})"), HasSubstr("neither"));
  EXPECT_THAT(errorOf(R"({"luminaires": [{"site": 1.5, "flux": 1}]})"), HasSubstr("whole number"));
  EXPECT_THAT(errorOf(R"({"luminaires": [{"site": -1, "flux": 1}]})"), HasSubstr("whole number"));
  EXPECT_THAT(errorOf(R"({"luminaires": [{"site": 1, "flux": -5}]})"), HasSubstr("out of range"));
  EXPECT_THAT(errorOf(R"({"luminaires": [{"site": 1, "flux": "5"}]})"), HasSubstr("expected a number"));
  EXPECT_THAT(errorOf(R"({"luminaires": [{"position": [1, 2], "flux": 1}]})"), HasSubstr("[x, y, z]"));
  EXPECT_THAT(errorOf(R"({"luminaires": [{"position": [1, 2, 1e999], "flux": 1}]})"),
              HasSubstr("not valid JSON"));
  EXPECT_THAT(errorOf(R"({"luminaires": [{"position": [1, 2, 3], "normal": [0, 0, 0], "flux": 1}]})"),
              HasSubstr("zero"));
  EXPECT_THAT(errorOf(R"({"luminaires": [{"position": [1, 2, 3], "size": [0, 1], "flux": 1}]})"),
              HasSubstr("size"));
  EXPECT_THAT(errorOf(R"({"dimming": -1, "luminaires": []})"), HasSubstr("dimming"));
  EXPECT_THAT(errorOf(std::string(30000, '[')), HasSubstr("deep"));
}

}  // namespace
}  // namespace fiatlux
