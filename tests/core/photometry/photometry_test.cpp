// What holds whichever format a table comes in; and files that are none (photometric_format).
#include "core/photometry/photometry.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/photometry/intensity.h"
#include "core/photometry/photometric_values.h"
#include "tests/core/photometry/photometric_files.h"

namespace fiatlux {
namespace {

using samples::angles;
using samples::cosine;
using samples::IesFile;
using samples::LdtFile;
using samples::read;
using samples::refusal;
using samples::sine;
using ::testing::AllOf;
using ::testing::HasSubstr;

/// Mirrored in both planes, far from axial.
double fourfold(double c, double gamma) { return 200 * (2 + cosine(2 * c)) * (1.5 + cosine(gamma)); }

TEST(Photometry, EverySymmetryOfOneDistributionIsOneTable) {
  IesFile file;
  file.gamma = angles(0, 180, 7.5);
  file.candela = fourfold;
  const std::pair<std::vector<double>, const char*> ranges[] = {{angles(0, 360, 15), "none"},
                                                                {angles(0, 90, 15), "quadrant"},
                                                                {angles(0, 180, 15), "C0-C180"},
                                                                {angles(90, 270, 15), "C90-C270"}};
  std::vector<Photometry> tables;
  for (const auto& [planes, name] : ranges) {
    file.c = planes;
    const Result<Photometry> p = read(file.text());
    ASSERT_TRUE(p) << p.error().message;
    EXPECT_STREQ(nameOf(p->symmetry), name);
    tables.push_back(*p);
  }
  LdtFile ldt;
  ldt.gamma = file.gamma, ldt.c = angles(0, 345, 15), ldt.symmetry = 4;
  ldt.perKilolumen = fourfold;
  tables.push_back(read(ldt.text()).value());
  for (const Photometry& table : tables) {
    EXPECT_NEAR(integratedFlux(table), integratedFlux(tables[0]), 1e-6 * integratedFlux(tables[0]));
    for (double c = -180; c < 540; c += 3.7)
      for (double gamma = 0; gamma <= 180; gamma += 2.9)
        ASSERT_NEAR(intensityAt(table, c, gamma), intensityAt(tables[0], c, gamma), 1e-6)
            << c << " " << gamma;
  }
}

TEST(Photometry, AQuarterTurnSwapsC0AndC90) {
  const auto lopsided = [](double c, double gamma) {
    return 100 * (3 + cosine(c) + 0.5 * sine(c) + 0.7 * cosine(2 * c)) * (1.1 + cosine(gamma));
  };
  IesFile file;
  file.c = angles(0, 360, 10);
  file.candela = lopsided;
  const Photometry straight = read(file.text()).value();
  file.candela = [&](double c, double gamma) { return lopsided(c - 90, gamma); };
  const Photometry turned = read(file.text()).value();
  // A direction in the room, seen from both: the turned luminaire holds at C + 90 what the other holds at C.
  for (double gamma = 9; gamma <= 90; gamma += 9) {
    const double r = sine(gamma), z = cosine(gamma);
    EXPECT_NEAR(intensity(turned, {0, r, z}), intensity(straight, {r, 0, z}), 1e-6);
    EXPECT_NEAR(intensity(turned, {-r, 0, z}), intensity(straight, {0, r, z}), 1e-6);
  }
  EXPECT_GT(std::abs(intensity(turned, {0, 1, 1}) - intensity(straight, {0, 1, 1})), 10);
}

TEST(Photometry, FeetAreMetres) {
  IesFile file;
  file.width = 0.3048, file.length = 1.2192, file.height = -0.6096;
  const Photometry metres = read(file.text()).value();
  file.unit = 1;
  file.width = 1, file.length = 4, file.height = -2;
  const Photometry feet = read(file.text()).value();
  EXPECT_NEAR(feet.luminous.width, metres.luminous.width, 1e-12);
  EXPECT_NEAR(feet.luminous.length, metres.luminous.length, 1e-12);
  EXPECT_NEAR(feet.luminous.height, metres.luminous.height, 1e-12);
  EXPECT_EQ(feet.luminous.shape, metres.luminous.shape);
}

TEST(Photometry, OneLuminaireInBothFormatsLiesThroughC90OrC0) {
  // 1.2 m long, 0.3 m wide, brighter across than along.
  IesFile ies;
  ies.c = angles(0, 90, 45);
  ies.candela = [](double c, double gamma) { return (200 + 100 * sine(c)) * cosine(gamma); };
  LdtFile ldt;
  ldt.c = angles(0, 315, 45), ldt.symmetry = 4;
  ldt.gamma = ies.gamma;
  ldt.perKilolumen = [&](double c, double gamma) { return ies.candela(90 - c, gamma); };
  const Photometry a = read(ies.text()).value(), b = read(ldt.text()).value();
  EXPECT_EQ(a.luminous.length, b.luminous.length);
  EXPECT_EQ(a.longAxis, PhotometricAxis::kC0);
  EXPECT_EQ(b.longAxis, PhotometricAxis::kC90);
  EXPECT_NEAR(intensity(a, {0, 1, 1}), intensity(b, {1, 0, 1}), 1e-9);
  EXPECT_NEAR(intensity(a, {1, 0, 1}), intensity(b, {0, 1, 1}), 1e-9);
}

TEST(Photometry, TheLargestTableIsRead) {
  IesFile file;
  file.gamma = angles(0, 180, 0.5), file.c = angles(0, 360, 0.5);
  file.candela = [](double, double) { return 7; };
  const Result<Photometry> p = read(file.text());
  ASSERT_TRUE(p) << p.error().message;
  EXPECT_EQ(p->candela.size(), 361u * 721u);
  EXPECT_NEAR(integratedFlux(*p), 4 * std::numbers::pi * 7, 1e-6);
}

TEST(Photometry, ZerosAfterTheTextAreThePaddingOfItsLastBlock) {
  const std::string text = IesFile().text();
  for (const std::string& end :
       {std::string("\x1a"), std::string(3, '\0'), "\x1a" + std::string(100, '\0')}) {
    const Result<Photometry> p = read(text + end);
    ASSERT_TRUE(p) << p.error().message;
    EXPECT_EQ(p->candela, read(text)->candela);
  }
  EXPECT_THAT(refusal(text + std::string("\0x", 2)), HasSubstr("binary"));
  EXPECT_THAT(refusal(std::string(4, '\0')), HasSubstr("binary"));
}

// A zip's central entry, as far as it is looked at.
std::string centralEntry(const std::string& name) {
  std::string entry = std::string("PK\x01\x02") + std::string(24, '\0');
  entry += static_cast<char>(name.size());
  entry += std::string(17, '\0');
  return entry + name;
}

TEST(Photometry, OtherFilesAreToldWhatToDoInstead) {
  const auto says = [](const std::string& bytes, auto matcher) {
    const std::string said = refusal(bytes);
    EXPECT_THAT(said, matcher);
    EXPECT_EQ(said.find('\n'), std::string::npos);
  };
  using std::string;
  says("", HasSubstr("empty"));
  says("\x89PNG\r\n\x1a\n", HasSubstr("PNG picture"));
  says("\xff\xd8\xff\xe0", HasSubstr("JPEG picture"));
  says(string("BM\0\0", 4), HasSubstr("BMP picture"));
  says("%PDF-1.4", HasSubstr("PDF"));
  says("\xff\xfeI\0E\0", HasSubstr("UTF-16"));
  says("\x1f\x8b\b", HasSubstr("gzip"));
  says("PK\x03\x04" + centralEntry("product.xml") + centralEntry("ldc/A b.LDT") + centralEntry("geo/x.l3d"),
       AllOf(HasSubstr("GLDF container"), HasSubstr("take out ldc/A b.LDT")));
  says("PK\x03\x04" + centralEntry("product.xml"), HasSubstr("GLDF container without an .ldt or .ies"));
  says("PK\x03\x04" + centralEntry("a.ies") + centralEntry("b.ies"),
       HasSubstr("zip container; unzip it and take out a.ies, b.ies"));
  says("<?xml version=\"1.0\"?><Root><File contentType=\"ldc/eulumdat\">lamp.ldt</File></Root>",
       HasSubstr("GLDF product; take the file that it names: lamp.ldt"));
  says("\xef\xbb\xbf <?xml version=\"1.0\"?><IESTM33-22><Version>1.0</Version></IESTM33-22>",
       HasSubstr("TM-33"));
  says("<?xml version=\"1.0\"?><a/>", HasSubstr("XML and names no"));
  says("<!DOCTYPE html><html><a href=\"x.ies\"></a></html>", HasSubstr("web page"));
  says(string("ULD\0\1\2", 6), HasSubstr("DIALux's own format"));
  says(string("\1ROLF\0\2", 7), HasSubstr("Relux's own format"));
  says(string("\1\2\0\3", 4), HasSubstr("export EULUMDAT"));
  says("hello\nworld\n", HasSubstr("neither LM-63"));
  says("name\n1\n1\n", HasSubstr("neither LM-63"));
  says("IESNA:LM-63-2002\n" + string(kMaxPhotometricBytes, ' '), HasSubstr("more than the 4 MB"));
}

}  // namespace
}  // namespace fiatlux
