// EULUMDAT as makers write it.
#include "core/photometry/eulumdat_file.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>

#include "core/photometry/intensity.h"
#include "core/photometry/photometric_values.h"
#include "tests/core/photometry/photometric_files.h"

namespace fiatlux {
namespace {

using samples::angles;
using samples::cosine;
using samples::LdtFile;
using samples::read;
using samples::refusal;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

std::string textOfLines(const std::vector<std::string>& lines) {
  return samples::IesFile::joined(lines, "\n");
}

TEST(EulumdatFile, ReadsAWholeFile) {
  LdtFile file;
  file.lamps = {{2, 2000, 30}, {1, 500, 12}};
  file.conversion = 2;
  file.ratio = 200;
  const Result<Photometry> p = read(file.text());
  ASSERT_TRUE(p) << p.error().message;
  EXPECT_EQ(p->name, "Sample");
  EXPECT_EQ(p->maker, "Fiat Lux");
  EXPECT_EQ(p->cct, 4000);
  EXPECT_STREQ(nameOf(p->format), "EULUMDAT");
  EXPECT_STREQ(nameOf(p->symmetry), "axial");
  EXPECT_EQ(p->watts, 42);
  EXPECT_NEAR(maxCandela(*p), 1000 / std::numbers::pi * 2.5 * 2, 1e-6);
  EXPECT_NEAR(p->flux, 5000, 1e-9);
  EXPECT_NEAR(p->luminous.length, 1.2, 1e-12);
  EXPECT_NEAR(p->luminous.width, 0.3, 1e-12);
  EXPECT_FALSE(p->luminous.round);
  EXPECT_EQ(p->longAxis, PhotometricAxis::kC90);
  EXPECT_THAT(p->warnings, IsEmpty());
}

TEST(EulumdatFile, TakesDecimalCommasAndBlankLines) {
  LdtFile file;
  const Result<Photometry> expected = read(file.text());
  std::vector<std::string> lines = file.lines();
  for (std::string& line : lines) std::replace(line.begin(), line.end(), '.', ',');
  lines[4] = lines[6] = lines[12] = lines[14] = "";  // distances and the body's sizes
  const Result<Photometry> p = read(textOfLines(lines));
  ASSERT_TRUE(p) << p.error().message;
  EXPECT_EQ(p->candela, expected->candela);
}

TEST(EulumdatFile, AUnitMayFollowTheWattsOfItsLamps) {
  for (const char* watts : {"30 W", "30W", " 30,0 w "}) {
    std::vector<std::string> lines = LdtFile().lines();
    lines[31] = watts;
    const Result<Photometry> p = read(textOfLines(lines));
    ASSERT_TRUE(p) << p.error().message;
    EXPECT_EQ(p->watts, 30) << watts;
  }
  for (const char* watts : {"W", "30 lm", "2x30 W"}) {
    std::vector<std::string> lines = LdtFile().lines();
    lines[31] = watts;
    EXPECT_THAT(refusal(textOfLines(lines)), HasSubstr("line 32: ")) << watts;
  }
}

TEST(EulumdatFile, ANameThatIsBlankGivesItsPlaceToTheNumber) {
  LdtFile file;
  file.name = "";
  EXPECT_EQ(read(file.text())->name, "FL-1");
}

TEST(EulumdatFile, ANegativeCountIsAbsolute) {
  LdtFile file;
  file.lamps = {{-1, 1000, 30}};
  file.ratio = 0;
  const Result<Photometry> p = read(file.text());
  ASSERT_TRUE(p);
  EXPECT_EQ(p->flux, 1000);
  EXPECT_NEAR(integratedFlux(*p), 1000, 5);
}

TEST(EulumdatFile, NoWidthIsRoundAndSidesHaveTheirOwnHeights) {
  LdtFile file;
  file.luminous = {400, 0, 30, 40, 50, 60};
  const Result<Photometry> p = read(file.text());
  ASSERT_TRUE(p);
  EXPECT_TRUE(p->luminous.round);
  EXPECT_NEAR(p->luminous.width, 0.4, 1e-12);
  EXPECT_NEAR(p->luminous.height, 0.06, 1e-12);
  EXPECT_NEAR(p->luminous.sides[1], 0.04, 1e-12);
}

TEST(EulumdatFile, RatiosWarnBeyondTwoPerCent) {
  LdtFile file;
  file.ratio = 101.5, file.downward = 98.5;
  EXPECT_THAT(read(file.text())->warnings, IsEmpty());
  file.ratio = 60, file.downward = 90;
  EXPECT_THAT(read(file.text())->warnings, ElementsAre(HasSubstr("line 23"), HasSubstr("line 22")));
}

TEST(EulumdatFile, ColoursAreKelvinOrCodes) {
  LdtFile file;
  const std::pair<const char*, std::optional<double>> colors[] = {
      {"3000", 3000.0}, {"3000K", 3000.0}, {"ww / 2700 K", 2700.0}, {"840", 4000.0}, {"", {}},
      {"white", {}},    {"12", {}}};
  for (const auto& [color, kelvin] : colors) {
    file.color = color;
    EXPECT_EQ(read(file.text())->cct, kelvin) << color;
  }
}

TEST(EulumdatFile, EverySymmetryOfOneDistribution) {
  // Mirrored in both planes, so that every indicator but 1 may say it.
  LdtFile file;
  file.gamma = angles(0, 180, 7.5);
  file.c = angles(0, 345, 15);
  file.perKilolumen = [](double c, double gamma) {
    return 100 * (2 + cosine(2 * c)) * (1.5 + cosine(gamma));
  };
  file.symmetry = 0;
  const Result<Photometry> whole = read(file.text());
  ASSERT_TRUE(whole) << whole.error().message;
  EXPECT_EQ(whole->c.size(), 25u);
  for (const int symmetry : {2, 3, 4}) {
    file.symmetry = symmetry;
    const Result<Photometry> p = read(file.text());
    ASSERT_TRUE(p) << symmetry << p.error().message;
    for (double c = 0; c < 360; c += 7)
      for (double gamma = 0; gamma <= 180; gamma += 4.5)
        EXPECT_NEAR(intensityAt(*p, c, gamma), intensityAt(*whole, c, gamma), 1e-6) << symmetry << " " << c;
    EXPECT_NEAR(integratedFlux(*p), integratedFlux(*whole), 1e-6 * integratedFlux(*whole));
  }
}

TEST(EulumdatFile, TheMirrorOfTheCrosswisePlane) {
  // Alike at C and 180 - C, not at C and -C: only indicators 0 and 3 may say it.
  LdtFile file;
  file.c = angles(0, 330, 30);
  file.perKilolumen = [](double c, double gamma) {
    return (200 + 100 * samples::sine(c)) * (1.2 + cosine(gamma));
  };
  file.symmetry = 0;
  const Result<Photometry> whole = read(file.text());
  file.symmetry = 3;
  const Result<Photometry> p = read(file.text());
  ASSERT_TRUE(whole && p) << p.error().message;
  EXPECT_STREQ(nameOf(p->symmetry), "C90-C270");
  EXPECT_THAT(p->c, ElementsAre(90, 120, 150, 180, 210, 240, 270));
  for (double c = -90; c < 360; c += 11)
    EXPECT_NEAR(intensityAt(*p, c, 30), intensityAt(*whole, c, 30), 1e-6) << c;
}

TEST(EulumdatFile, EveryFaultNamesItsLine) {
  const std::vector<std::string> sound = LdtFile{}.lines();
  const auto with = [&](std::size_t line, const char* text) {
    std::vector<std::string> lines = sound;
    lines[line - 1] = text;
    return refusal(textOfLines(lines));
  };
  EXPECT_THAT(with(3, "7"), HasSubstr("line 3: the symmetry indicator is 7"));
  EXPECT_THAT(with(4, "1000"), HasSubstr("line 4: the number of C planes is 1000"));
  EXPECT_THAT(with(6, "500"), HasSubstr("line 6: the number of intensities"));
  EXPECT_THAT(with(6, "x"), HasSubstr("line 6: \"x\" stands where"));
  EXPECT_THAT(with(17, "-3"), HasSubstr("line 17: a length of the luminous area is -3"));
  EXPECT_THAT(with(24, "-1"), HasSubstr("line 24: the conversion factor is -1"));
  EXPECT_THAT(with(26, "0"), HasSubstr("line 26: the number of sets"));
  EXPECT_THAT(with(27, "0"), HasSubstr("line 27: 0 lamps"));
  EXPECT_THAT(with(29, "0"), HasSubstr("no set of lamps has a flux"));
  EXPECT_THAT(with(45, "0"), HasSubstr("line 45: the angle gamma of 0 follows 0"));
  EXPECT_THAT(with(82, "NaN"), HasSubstr("line 82: \"NaN\" stands where an intensity"));
  EXPECT_THAT(with(82, "-4"), HasSubstr("line 82: -4 cd"));
  EXPECT_THAT(with(82, "1e9"), HasSubstr("line 82: 1e+09 cd"));
}

TEST(EulumdatFile, MissingLinesAreSeen) {
  LdtFile file;
  file.symmetry = 4;
  file.c = angles(0, 345, 15);
  const std::vector<std::string> sound = file.lines();
  ASSERT_EQ(refusal(textOfLines(sound)), "");
  for (std::size_t line = 2; line < sound.size(); ++line) {
    std::vector<std::string> lines = sound;
    lines.erase(lines.begin() + static_cast<std::ptrdiff_t>(line) - 1);
    const std::string said = refusal(textOfLines(lines));
    EXPECT_NE(said, "") << line;
    EXPECT_EQ(said.find('\n'), std::string::npos);
  }
  for (std::size_t keep = 8; keep < sound.size(); ++keep)
    EXPECT_THAT(refusal(textOfLines({sound.begin(), sound.begin() + static_cast<std::ptrdiff_t>(keep)})),
                HasSubstr("line " + std::to_string(keep) + ": the file ends"));
}

TEST(EulumdatFile, PlanesMustBeThoseOfTheSymmetry) {
  LdtFile file;
  file.symmetry = 4;
  file.c = angles(0, 350, 50);
  EXPECT_THAT(refusal(file.text()), HasSubstr("symmetry 4 (line 3) needs C plane"));
  file.c = angles(0, 350, 10);
  file.symmetry = 2;
  file.c.pop_back();
  EXPECT_THAT(refusal(file.text()), HasSubstr("2 divides, not 35"));
}

}  // namespace
}  // namespace fiatlux
