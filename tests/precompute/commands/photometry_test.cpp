// fiatlux photometry as a person meets it: a card, its numbers as JSON, and one line where a file is none.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "tests/core/photometry/photometric_files.h"
#include "tests/precompute/commands/command_run.h"

namespace fiatlux {
namespace {

using nlohmann::json;
using ::testing::HasSubstr;

TEST(PhotometryCommand, PrintsEveryKeyOfTheCard) {
  const TemporaryFolder folder;
  samples::IesFile file;
  file.lumens = 3500, file.words = {"[LUMINAIRE] Tub\xfc", "[MANUFAC] Acme", "[LAMP] LED 3000K"};
  file.width = 0.3, file.length = 1.2;
  writeTextFile(folder / "a.ies", file.text());
  const CommandRun run = runFiatlux(folder, "photometry a.ies --json");
  ASSERT_EQ(run.status, 0) << run.err;
  const json card = json::parse(run.out);
  const auto ordered = nlohmann::ordered_json::parse(run.out);
  std::vector<std::string> keys;
  for (const auto& item : ordered.items()) keys.push_back(item.key());
  EXPECT_EQ(keys,
            (std::vector<std::string>{"name", "maker", "format", "flux", "integratedFlux", "watts",
                                      "efficacy", "cct", "luminous", "longAxis", "symmetry", "maxCandela",
                                      "beamAngle", "fieldAngle", "upwardShare", "ugr4h8h", "warnings"}));
  EXPECT_EQ(card["name"], "Tub\xc3\xbc");
  EXPECT_EQ(card["format"], "LM-63-2002");
  EXPECT_EQ(card["flux"], 3500);
  EXPECT_NEAR(card["integratedFlux"].get<double>(), 3139.6, 0.1);
  EXPECT_NEAR(card["efficacy"].get<double>(), 3139.6 / 30, 0.01);
  EXPECT_EQ(card["cct"], 3000);
  EXPECT_EQ(card["luminous"], json::parse(R"({"length": 1.2, "width": 0.3, "height": 0.0, "round": false})"));
  EXPECT_EQ(card["longAxis"], "C0");
  EXPECT_EQ(card["symmetry"], "axial");
  EXPECT_NEAR(card["beamAngle"].get<double>(), 120, 0.2);
  EXPECT_EQ(card["upwardShare"], 0);
  EXPECT_TRUE(card["warnings"].empty());
}

TEST(PhotometryCommand, WhatIsNotKnownIsNull) {
  const TemporaryFolder folder;
  samples::IesFile file;
  file.width = file.length = file.watts = 0;
  writeTextFile(folder / "a.ies", file.text());
  const json card = json::parse(runFiatlux(folder, "photometry a.ies --json").out);
  for (const char* key : {"efficacy", "cct", "ugr4h8h"}) EXPECT_TRUE(card[key].is_null()) << key;
}

TEST(PhotometryCommand, PrintsACardAndRefusesInOneLine) {
  const TemporaryFolder folder;
  writeTextFile(folder / "a.ldt", samples::LdtFile().text());
  const CommandRun card = runFiatlux(folder, "photometry a.ldt");
  EXPECT_EQ(card.status, 0) << card.err;
  EXPECT_THAT(card.out, HasSubstr("Sample"));
  EXPECT_THAT(card.out, HasSubstr("length along C90"));
  writeTextFile(folder / "b.ldt", samples::LdtFile().text().substr(0, 300));
  const CommandRun cut = runFiatlux(folder, "photometry b.ldt");
  EXPECT_EQ(cut.status, 2);
  EXPECT_EQ(cut.out, "");
  EXPECT_THAT(cut.err, HasSubstr("fiatlux: b.ldt: line "));
  EXPECT_EQ(std::count(cut.err.begin(), cut.err.end(), '\n'), 1);
}

}  // namespace
}  // namespace fiatlux
