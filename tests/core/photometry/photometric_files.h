// Photometric files written out from a distribution, for the tests and the fuzzer's seeds.
#pragma once

#include <array>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <functional>
#include <numbers>
#include <span>
#include <string>
#include <vector>

#include "core/photometry/photometry.h"

namespace fiatlux::samples {

/// cd at C, gamma (degrees).
using Distribution = std::function<double(double c, double gamma)>;

inline double cosine(double degrees) { return std::cos(degrees * std::numbers::pi / 180); }
inline double sine(double degrees) { return std::sin(degrees * std::numbers::pi / 180); }

/// `peak` cos^n downwards, dark above.
inline Distribution cosinePower(double peak, double n) {
  return [=](double, double gamma) { return gamma < 90 ? peak * std::pow(cosine(gamma), n) : 0.0; };
}

/// first, first + step, ..., last.
inline std::vector<double> angles(double first, double last, double step) {
  std::vector<double> list;
  for (int i = 0; first + i * step <= last + 1e-9; ++i) list.push_back(first + i * step);
  return list;
}

inline std::string decimal(double value) {
  char text[40];
  std::snprintf(text, sizeof text, "%.10g", value);
  return text;
}

struct IesFile {
  std::string tag = "IESNA:LM-63-2002";  // empty: 1986
  std::vector<std::string> words = {"[MANUFAC] Fiat Lux", "[LUMINAIRE] Sample"};
  std::string tilt = "TILT=NONE";
  double lamps = 1, lumens = -1, multiplier = 1;
  int type = 1, unit = 2;
  double width = 0.3, length = 1.2, height = 0;
  double ballast = 1, second = 1, watts = 30;
  std::vector<double> gamma = angles(0, 90, 5), c = {0};
  Distribution candela = cosinePower(1000, 1);
  std::string end = "\r\n";

  std::vector<std::string> lines() const {
    std::vector<std::string> list;
    if (!tag.empty()) list.push_back(tag);
    list.insert(list.end(), words.begin(), words.end());
    list.push_back(tilt);
    list.push_back(
        row({lamps, lumens, multiplier, static_cast<double>(gamma.size()), static_cast<double>(c.size()),
             static_cast<double>(type), static_cast<double>(unit), width, length, height}));
    list.push_back(row({ballast, second, watts}));
    list.push_back(row(gamma));
    list.push_back(row(c));
    for (const double plane : c) {
      std::vector<double> values;
      for (const double g : gamma) values.push_back(candela(plane, g));
      list.push_back(row(values));
    }
    return list;
  }
  std::string text() const { return joined(lines(), end); }

  static std::string row(const std::vector<double>& values) {
    std::string line;
    for (const double value : values) line += (line.empty() ? "" : " ") + decimal(value);
    return line;
  }
  static std::string joined(const std::vector<std::string>& lines, const std::string& end) {
    std::string all;
    for (const std::string& line : lines) all += line + end;
    return all;
  }
};

struct LdtFile {
  std::string maker = "Fiat Lux", name = "Sample", number = "FL-1", color = "4000", end = "\r\n";
  int symmetry = 1;
  std::vector<double> gamma = angles(0, 180, 5), c = {0};    // all planes of lines 4 and following
  std::array<double, 6> luminous = {1200, 300, 0, 0, 0, 0};  // lines 16 to 21, mm
  double downward = 100, ratio = 100, conversion = 1, tilt = 0;
  struct Lamps {
    double count = 1, flux = 1000, watts = 30;
  };
  std::vector<Lamps> lamps = {{}};
  Distribution perKilolumen = cosinePower(1000 / std::numbers::pi, 1);

  /// The planes whose intensities are written, in their order.
  std::vector<double> written() const {
    const std::size_t n = c.size();
    std::size_t first = 0, count = n;
    if (symmetry == 1) count = 1;
    if (symmetry == 2) count = n / 2 + 1;
    if (symmetry == 3) first = 3 * n / 4, count = n / 2 + 1;
    if (symmetry == 4) count = n / 4 + 1;
    std::vector<double> planes;
    for (std::size_t i = 0; i < count; ++i) planes.push_back(c[(first + i) % n]);
    return planes;
  }

  std::vector<std::string> lines() const {
    std::vector<std::string> list = {maker,
                                     "1",
                                     decimal(symmetry),
                                     decimal(static_cast<double>(c.size())),
                                     "0",
                                     decimal(static_cast<double>(gamma.size())),
                                     "0",
                                     "",
                                     name,
                                     number,
                                     "sample.ldt",
                                     "",
                                     "1300",
                                     "320",
                                     "50"};
    for (const double size : luminous) list.push_back(decimal(size));
    for (const double value : {downward, ratio, conversion, tilt}) list.push_back(decimal(value));
    list.push_back(decimal(static_cast<double>(lamps.size())));
    for (const Lamps& set : lamps)
      list.insert(list.end(),
                  {decimal(set.count), "LED", decimal(set.flux), color, "80", decimal(set.watts)});
    for (int k = 0; k < 10; ++k) list.push_back("0.5");
    for (const double plane : c) list.push_back(decimal(plane));
    for (const double g : gamma) list.push_back(decimal(g));
    for (const double plane : written())
      for (const double g : gamma) list.push_back(decimal(perKilolumen(plane, g)));
    return list;
  }
  std::string text() const { return IesFile::joined(lines(), end); }
};

inline std::span<const std::uint8_t> bytesOf(const std::string& text) {
  return {reinterpret_cast<const std::uint8_t*>(text.data()), text.size()};
}

inline Result<Photometry> read(const std::string& text) { return readPhotometry(bytesOf(text)); }

/// What the reader says of a file that it must refuse; empty where it takes the file.
inline std::string refusal(const std::string& text) {
  const Result<Photometry> photometry = read(text);
  return photometry ? std::string() : photometry.error().message;
}

}  // namespace fiatlux::samples
