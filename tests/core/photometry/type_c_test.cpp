// Distributions known in closed form, written as types A and B, must come out as type C.
#include "core/photometry/type_c.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/base/vec3.h"
#include "core/photometry/intensity.h"
#include "core/photometry/photometric_values.h"
#include "tests/core/photometry/photometric_files.h"

namespace fiatlux {
namespace {

using samples::angles;
using samples::cosine;
using samples::IesFile;
using samples::read;
using samples::sine;
using ::testing::HasSubstr;

/// cd along a unit direction: x to the side (C 0), y upwards (C 90), z along the beam.
using Field = std::function<double(const Vec3&)>;

Vec3 ofTypeA(double h, double v) { return {cosine(v) * sine(h), sine(v), cosine(v) * cosine(h)}; }
Vec3 ofTypeB(double h, double v) { return {sine(h), cosine(h) * sine(v), cosine(h) * cosine(v)}; }

Photometry beam(int type, std::vector<double> horizontal, std::vector<double> vertical, const Field& field) {
  IesFile file;
  file.type = type;
  file.c = std::move(horizontal), file.gamma = std::move(vertical);
  file.candela = [&](double h, double v) {
    return std::max(0.0, field(type == 3 ? ofTypeA(h, v) : ofTypeB(h, v)));
  };
  return read(file.text()).value();
}

void expectField(const Photometry& p, const Field& field, double tolerance) {
  for (double c = 0; c < 360; c += 13)
    for (double gamma = 0; gamma < 90; gamma += 7) {
      const Vec3 d{sine(gamma) * cosine(c), sine(gamma) * sine(c), cosine(gamma)};
      EXPECT_NEAR(intensity(p, d), field(d), tolerance) << c << " " << gamma;
    }
}

TEST(TypeC, AxialBeamsComeOutAxial) {
  const Field field = [](const Vec3& d) { return 1000 * std::pow(std::max(0.0, d.z), 8); };
  for (const int type : {2, 3}) {
    const Photometry p = beam(type, angles(-90, 90, 2.5), angles(-90, 90, 2.5), field);
    EXPECT_STREQ(nameOf(p.symmetry), "none");
    expectField(p, field, 4);
    EXPECT_NEAR(integratedFlux(p), 2 * std::numbers::pi * 1000 / 9, 2) << type;
  }
}

TEST(TypeC, SidesStayWhereTheyAre) {
  const Field field = [](const Vec3& d) { return 100 * d.z * d.z * (2 + d.x + 0.5 * d.y + 0.8 * d.x * d.y); };
  for (const int type : {2, 3})
    expectField(beam(type, angles(-90, 90, 2.5), angles(-90, 90, 2.5), field), field, 0.5);
}

TEST(TypeC, ListsFromZeroAreMirrored) {
  const Field sideways = [](const Vec3& d) { return 100 * d.z * (1.5 + d.x * d.x + d.y); };
  const Field both = [](const Vec3& d) { return 100 * d.z * (1.5 + d.x * d.x - 0.5 * d.y * d.y); };
  for (const int type : {2, 3}) {
    const Photometry half = beam(type, angles(0, 90, 2.5), angles(-90, 90, 2.5), sideways);
    EXPECT_STREQ(nameOf(half.symmetry), "C90-C270");
    expectField(half, sideways, 0.5);
    const Photometry quarter = beam(type, angles(0, 90, 2.5), angles(0, 90, 2.5), both);
    EXPECT_STREQ(nameOf(quarter.symmetry), "quadrant");
    expectField(quarter, both, 0.5);
    EXPECT_STREQ(nameOf(beam(type, angles(-90, 90, 5), angles(0, 90, 5), both).symmetry), "C0-C180");
  }
}

TEST(TypeC, ANarrowTableIsDarkOutside) {
  const Photometry p = beam(2, angles(-20, 20, 1), angles(-20, 20, 1), [](const Vec3&) { return 500; });
  EXPECT_NEAR(intensity(p, {0, 0, 1}), 500, 1e-9);
  EXPECT_EQ(intensity(p, {1, 0, 1}), 0);
  EXPECT_EQ(p.gamma.back(), 90);
}

TEST(TypeC, TheOpeningFacesTheBeam) {
  IesFile file;
  file.type = 2;
  file.c = angles(0, 90, 10);
  file.width = 0.5, file.length = 0.1, file.height = 0.3;  // to the side, along the beam, upwards
  const Photometry p = read(file.text()).value();
  EXPECT_EQ(p.luminous.width, 0.5);
  EXPECT_EQ(p.luminous.length, 0.3);
  EXPECT_EQ(p.luminous.height, 0.1);
}

TEST(TypeC, OnePlaneIsNotEnough) {
  IesFile file;
  file.type = 3;
  EXPECT_THAT(samples::refusal(file.text()), HasSubstr("two horizontal angles or more"));
}

}  // namespace
}  // namespace fiatlux
