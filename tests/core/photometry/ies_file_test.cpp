// LM-63 in its vintages, as makers write it.
#include "core/photometry/ies_file.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/photometry/intensity.h"
#include "core/photometry/photometric_values.h"
#include "tests/core/photometry/photometric_files.h"

namespace fiatlux {
namespace {

using samples::angles;
using samples::cosinePower;
using samples::IesFile;
using samples::read;
using samples::refusal;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

TEST(IesFile, ReadsAWholeFileOfTheSecondVintage) {
  const Result<Photometry> p = read(
      "IESNA91\r\n[TEST] 17\r\n[MANUFAC] Lumen & Sons\r\n[LUMCAT] L-1\r\n[LUMINAIRE] Pendant,\r\n[MORE] "
      "white\r\n"
      "[LAMP] LED 3000K CRI90\r\nTILT=NONE\r\n"
      "2 500 2.0 3 3 1 1 1.0 2.0 0.5\r\n0.9 0.8 40\r\n"
      "0 45 90\r\n0 45\r\n90\r\n100 50 0\r\n90 40\r\n0 80, 30, 0\r\n");
  ASSERT_TRUE(p) << p.error().message;
  EXPECT_EQ(p->name, "Pendant, white");
  EXPECT_EQ(p->maker, "Lumen & Sons");
  EXPECT_EQ(p->cct, 3000);
  EXPECT_STREQ(nameOf(p->format), "LM-63-1991");
  EXPECT_STREQ(nameOf(p->symmetry), "quadrant");
  EXPECT_EQ(p->watts, 40);
  EXPECT_NEAR(p->flux, 2 * 500 * 0.72, 1e-9);
  EXPECT_THAT(p->gamma, ElementsAre(0, 45, 90));
  EXPECT_THAT(p->c, ElementsAre(0, 45, 90));
  EXPECT_NEAR(p->at(0, 0), 144, 1e-9);
  EXPECT_NEAR(p->at(1, 1), 57.6, 1e-9);
  EXPECT_NEAR(p->at(2, 0), 115.2, 1e-9);
  EXPECT_NEAR(p->luminous.width, 0.3048, 1e-12);
  EXPECT_NEAR(p->luminous.length, 0.6096, 1e-12);
  EXPECT_NEAR(p->luminous.height, 0.1524, 1e-12);
  EXPECT_EQ(p->longAxis, PhotometricAxis::kC0);
}

TEST(IesFile, CommasPartNumbersOrAreDecimalAsTheCountsSay) {
  const std::string head = "IESNA:LM-63-2002\r\nTILT=NONE\r\n";
  const auto file = [&](const std::string& numbers) { return read(head + numbers); };
  const std::string decimal = "1 1000 1,5 3 1 1 2 0,1 0,2 0\r\n1 1 12,5\r\n0 22,5 90\r\n0\r\n100 50,5 0\r\n";
  const Result<Photometry> p = file(decimal);
  ASSERT_TRUE(p) << p.error().message;
  EXPECT_THAT(p->gamma, ElementsAre(0, 22.5, 90));
  EXPECT_NEAR(p->at(0, 1), 75.75, 1e-9);
  EXPECT_EQ(p->watts, 12.5);
  EXPECT_NEAR(p->luminous.width, 0.1, 1e-12);
  const Result<Photometry> parted = file("1,1000,1,3,1,1,2,0,0,0\r\n1,1,12\r\n0,45,90\r\n0\r\n100,50,0\r\n");
  ASSERT_TRUE(parted) << parted.error().message;
  EXPECT_THAT(parted->gamma, ElementsAre(0, 45, 90));
  // Where neither fits, the fault is that of numbers that commas part.
  EXPECT_THAT(refusal(head + "1,1000,1,3,1,1,2,0,0,0\r\n1,1,12\r\n0,45,90\r\n0\r\n100,50\r\n"),
              HasSubstr("the file ends where an intensity should stand"));
}

TEST(IesFile, TheSecondFactorMultipliesBefore1995Only) {
  const std::pair<const char*, double> vintages[] = {{"", 900},
                                                     {"IESNA91", 900},
                                                     {"IESNA:LM-63-1995", 1000},
                                                     {"IESNA:LM-63-2002", 1000},
                                                     {"IES:LM-63-2019", 1000}};
  std::vector<std::string> names;
  for (const auto& [tag, peak] : vintages) {
    IesFile file;
    file.tag = tag;
    file.second = 0.9;
    const Result<Photometry> p = read(file.text());
    ASSERT_TRUE(p) << tag << p.error().message;
    EXPECT_NEAR(maxCandela(*p), peak, 1e-9) << tag;
    EXPECT_EQ(p->warnings.size(), std::string(tag).find("LM-63-1995") != std::string::npos ||
                                          std::string(tag).find("LM-63-2002") != std::string::npos
                                      ? 1u
                                      : 0u)
        << tag;
    names.push_back(nameOf(p->format));
  }
  EXPECT_THAT(names, ElementsAre("LM-63-1986", "LM-63-1991", "LM-63-1995", "LM-63-2002", "LM-63-2019"));
}

TEST(IesFile, TheKindOfFileOf2019IsNoFactor) {
  IesFile file;
  file.tag = "IES:LM-63-2019";
  file.second = 1.10001;
  const Result<Photometry> p = read(file.text());
  ASSERT_TRUE(p);
  EXPECT_EQ(maxCandela(*p), 1000);
  EXPECT_THAT(p->warnings, IsEmpty());
}

TEST(IesFile, CountsOf1986MayHavePoints) {
  const Result<Photometry> p = read(
      "Acme downlight\nTiltable\nTILT=NONE\n1.0 -1 1.0 3.0 1.0 1.0 2.0 0.1 0.1 0\n"
      "1 1 10\n0 45 90\n0\n10 5 0\n");
  ASSERT_TRUE(p) << p.error().message;
  EXPECT_EQ(p->name, "Acme downlight");
  EXPECT_EQ(p->format, PhotometricFormat::kLm63_1986);
}

TEST(IesFile, LinesWithoutKeywordsTellTheColour) {
  IesFile file;
  file.tag = "";
  file.words = {"Acme downlight 1500", "LED 3000K CRI90", "Report 4000 K-17"};
  EXPECT_EQ(read(file.text())->cct, 3000);
  file.words.push_back("[COLORTEMP] 2700");
  EXPECT_EQ(read(file.text())->cct, 2700);
  file.words = {"Acme downlight 3000", "12 W"};
  EXPECT_FALSE(read(file.text())->cct);
}

TEST(IesFile, AbsolutePhotometryStatesItsTable) {
  IesFile file;
  file.multiplier = 3;
  const Result<Photometry> p = read(file.text());
  ASSERT_TRUE(p);
  EXPECT_EQ(p->flux, integratedFlux(*p));
}

TEST(IesFile, EveryLineEndMarkAndAlphabet) {
  IesFile file;
  const Result<Photometry> expected = read(file.text());
  for (const char* end : {"\n", "\r", "\r\n"}) {
    file.end = end;
    for (const char* mark : {"", "\xef\xbb\xbf"}) {
      const Result<Photometry> p = read(mark + file.text());
      ASSERT_TRUE(p) << p.error().message;
      EXPECT_EQ(p->candela, expected->candela);
      EXPECT_EQ(p->name, "Sample");
    }
  }
  EXPECT_STREQ(nameOf(read("\r\n \r\n" + file.text())->format), "LM-63-2002");
  file.words = {"[MANUFAC] L\xfcster"};
  EXPECT_EQ(read(file.text())->maker, "L\xc3\xbcster");
}

TEST(IesFile, TiltIncludedIsReadPast) {
  IesFile file;
  file.tilt = "TILT=INCLUDE\n1\n3\n0 90\n180\n1.0 0.95 0.9";
  Result<Photometry> p = read(file.text());
  ASSERT_TRUE(p) << p.error().message;
  EXPECT_EQ(maxCandela(*p), 1000);
  EXPECT_THAT(p->warnings, ElementsAre(HasSubstr("TILT=INCLUDE")));
  file.tilt = "tilt = include\n3\n2\n0 90\n1 1";
  p = read(file.text());
  ASSERT_TRUE(p) << p.error().message;
  EXPECT_THAT(p->warnings, IsEmpty());
}

TEST(IesFile, TiltInAFileOfItsOwnIsRefused) {
  IesFile file;
  file.tilt = "TILT=../lamp.tlt";
  EXPECT_THAT(refusal(file.text()), HasSubstr("line 4: TILT names the file \"../lamp.tlt\""));
  file.tag = "IES:LM-63-2019";
  EXPECT_THAT(refusal(file.text()), HasSubstr("which LM-63-2019 forbids"));
}

TEST(IesFile, ALonePlaneIsThatOfZeroWhateverItsAngle) {
  for (const double angle : {0.0, 0.0001, 90.0}) {
    IesFile file;
    file.c = {angle};
    const Result<Photometry> p = read(file.text());
    ASSERT_TRUE(p) << p.error().message;
    EXPECT_EQ(p->symmetry, PhotometricSymmetry::kAxial);
    EXPECT_EQ(p->c, std::vector<double>{0});
  }
}

TEST(IesFile, TheRoundMayBeLeftOpen) {
  IesFile file;
  file.c = angles(0, 360, 30);
  file.candela = [](double c, double gamma) {
    return (100 + 50 * samples::cosine(c) + 20 * samples::sine(c)) * samples::cosine(gamma);
  };
  const Result<Photometry> whole = read(file.text());
  file.c.pop_back();
  const Result<Photometry> open = read(file.text());
  ASSERT_TRUE(whole && open);
  EXPECT_EQ(open->c, whole->c);
  for (std::size_t i = 0; i < whole->candela.size(); ++i)
    EXPECT_NEAR(open->candela[i], whole->candela[i], 1e-6);
}

TEST(IesFile, WarnsOfLampsThatCannotGiveTheTable) {
  IesFile file;
  file.lumens = 1000;
  file.candela = cosinePower(1000, 1);  // 3142 lm
  const Result<Photometry> p = read(file.text());
  ASSERT_TRUE(p);
  EXPECT_EQ(p->flux, 1000);
  EXPECT_THAT(p->warnings, ElementsAre(HasSubstr("lamps give 1000 lm, its table holds 3139.6")));
  file.candela = cosinePower(250, 1);  // a fixture that keeps a fifth of its lamps' light
  EXPECT_THAT(read(file.text())->warnings, IsEmpty());
}

TEST(IesFile, WarnsOfATableThatEndsEarly) {
  IesFile file;
  file.gamma = angles(0, 75, 5);
  EXPECT_THAT(read(file.text())->warnings, ElementsAre(HasSubstr("from gamma 0 to 75 only")));
}

/// A file of 8 lines before its angles: the tag, two words, TILT, two lines of counts, gammas, planes.
TEST(IesFile, EveryFaultNamesItsLine) {
  const auto with = [](auto change) {
    IesFile file;
    file.c = angles(0, 90, 45);
    change(file);
    return refusal(file.text());
  };
  EXPECT_THAT(with([](IesFile& f) { f.lamps = 0; }), HasSubstr("line 5: the number of lamps is 0"));
  EXPECT_THAT(with([](IesFile& f) { f.lumens = -5; }), HasSubstr("line 5: the lumens per lamp"));
  EXPECT_THAT(with([](IesFile& f) { f.type = 4; }), HasSubstr("line 5: the photometric type"));
  EXPECT_THAT(with([](IesFile& f) { f.unit = 3; }), HasSubstr("line 5: the unit"));
  EXPECT_THAT(with([](IesFile& f) { f.multiplier = 0; }),
              HasSubstr("line 6: multiplier and ballast factors"));
  EXPECT_THAT(with([](IesFile& f) { f.watts = -1; }), HasSubstr("line 6: the input watts is -1"));
  EXPECT_THAT(with([](IesFile& f) {
                f.gamma = {0, 90, 45};
              }),
              HasSubstr("line 7: the vertical angle of 45 follows 90"));
  EXPECT_THAT(with([](IesFile& f) {
                f.gamma = {0, 45, 45};
              }),
              HasSubstr("line 7: the vertical angle of 45 follows 45"));
  EXPECT_THAT(with([](IesFile& f) { f.gamma = {0, 200}; }), HasSubstr("line 7: the vertical angle is 200"));
  EXPECT_THAT(with([](IesFile& f) {
                f.c = {0, 30, 60};
              }),
              HasSubstr("line 8: the horizontal angles go from 0 to 60"));
  EXPECT_THAT(with([](IesFile& f) {
                f.c = {0, 90, 180, 200};
              }),
              HasSubstr("line 8: the horizontal angles go"));
  EXPECT_THAT(with([](IesFile& f) { f.candela = [](double c, double) { return c == 45 ? -1 : 1; }; }),
              HasSubstr("line 10: -1 cd"));
  EXPECT_THAT(with([](IesFile& f) { f.candela = [](double c, double) { return c == 90 ? 1e9 : 1; }; }),
              HasSubstr("line 11: 1e+09 cd is more than 1e7"));
  EXPECT_THAT(with([](IesFile& f) { f.multiplier = 1e5; }), HasSubstr("line 9: 1e+08 cd is more than 1e7"));
  EXPECT_THAT(with([](IesFile& f) { f.candela = [](double, double) { return 0; }; }), HasSubstr("no light"));
  EXPECT_THAT(with([](IesFile& f) { f.gamma = angles(0, 90, 0.18); }),
              HasSubstr("line 5: the number of vertical"));
  EXPECT_THAT(with([](IesFile& f) { f.c = angles(0, 360, 0.36); }),
              HasSubstr("line 5: the number of horizontal"));
}

TEST(IesFile, EveryFaultIsOneLineWithItsPlace) {
  const std::vector<std::string> sound = IesFile{}.lines();
  const auto refused = [](std::vector<std::string> lines) { return refusal(IesFile::joined(lines, "\n")); };
  for (std::size_t keep = 1; keep < sound.size(); ++keep) {
    const std::string said = refused({sound.begin(), sound.begin() + static_cast<std::ptrdiff_t>(keep)});
    EXPECT_EQ(said.rfind("line " + std::to_string(keep) + ": the file ends", 0), 0u) << said;
    EXPECT_EQ(said.find('\n'), std::string::npos);
  }
  std::vector<std::string> lines = sound;
  lines.back() += " NaN";
  EXPECT_EQ(refused(lines), "");  // after the table: words, not numbers
  lines.back() = "NaN " + sound.back();
  EXPECT_THAT(refused(lines), HasSubstr("line 9: \"NaN\" stands where an intensity should"));
  lines = sound;
  lines[6] += " 95";  // one angle more than announced: it is taken for the plane, and 0 for a candela value
  EXPECT_NE(refused(lines), "");
  lines = sound;
  lines.back() += " 1";
  EXPECT_THAT(refused(lines), HasSubstr("line 9: more numbers follow than the counts of angles announce"));
  lines = sound;
  lines.erase(lines.begin() + 3);
  EXPECT_THAT(refused(lines), HasSubstr("line 4: the TILT= line is missing before these counts; insert"));
  lines.resize(3);
  EXPECT_THAT(refused(lines), HasSubstr("without a TILT= line; it was cut short"));
  // Nor is one without a tag taken for something else.
  EXPECT_THAT(refusal("Acme\r\n1 1000 1,5 3 1 1 2 0,1 0,2 0\r\n1 1 12,5\r\n0 22,5 90\r\n0\r\n9 5 0\r\n"),
              HasSubstr("line 2: the TILT= line is missing"));
}

}  // namespace
}  // namespace fiatlux
