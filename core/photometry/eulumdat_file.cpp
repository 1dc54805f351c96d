#include "core/photometry/eulumdat_file.h"

#include <algorithm>
#include <cmath>

#include "core/photometry/color_temperature.h"
#include "core/photometry/photometric_numbers.h"
#include "core/photometry/photometric_values.h"
#include "core/photometry/planes.h"

namespace fiatlux {
namespace {

constexpr double kMillimetre = 0.001;  // m
constexpr std::size_t kDirectRatios = 10, kMaxSets = 100;
constexpr double kMaxMillimetres = 1e6, kMaxPercent = 1000;

struct Head {
  std::size_t symmetry = 0, planes = 0, gammas = 0;
  double downwardShare = 0, outputRatio = 0, conversion = 1, lampFlux = 0;  // %, %, -, lm
  bool absolute = false;
};

/// Lines 13 to 21.
void readSizes(LineReader& reader, Photometry& photometry) {
  (void)reader.blankOrWithin("the luminaire's length", 0, kMaxMillimetres);
  (void)reader.blankOrWithin("the luminaire's width", 0, kMaxMillimetres);
  (void)reader.blankOrWithin("the luminaire's height", 0, kMaxMillimetres);
  LuminousArea& area = photometry.luminous;
  for (double* size : {&area.length, &area.width}) {
    *size = kMillimetre * reader.blankOrWithin("a length of the luminous area", 0, kMaxMillimetres);
  }
  for (double& side : area.sides) {
    side = kMillimetre * reader.blankOrWithin("a height of the luminous area", 0, kMaxMillimetres);
    area.height = std::max(area.height, side);
  }
  if (area.width > 0 || area.length == 0) return;
  area.round = true;
  area.shape = LuminousShape::kUprightCylinder;
  area.width = area.length;
}

/// Line 26 and the sets of lamps after it.
void readLamps(LineReader& reader, Head& head, Photometry& photometry) {
  const std::size_t sets = reader.count("the number of sets of lamps", 1, kMaxSets);
  for (std::size_t set = 0; set < sets && !reader.failure(); ++set) {
    const double lamps = reader.next("a number of lamps");
    if (lamps == 0) reader.fail("0 lamps; write how many, or a negative number for absolute photometry");
    head.absolute = head.absolute || lamps < 0;
    (void)reader.text("a type of lamp");
    head.lampFlux += reader.within("the flux of a set of lamps", 0, kMaxLumens);
    const std::string_view color = reader.text("a colour temperature");
    if (!photometry.cct) photometry.cct = colorTemperatureOf(color);
    (void)reader.text("a colour rendering index");
    photometry.watts += reader.blankOrWithin("the watts of a set of lamps", 0, kMaxWatts, "W");
  }
  if (!reader.failure() && !(head.lampFlux > 0))
    reader.fail("no set of lamps has a flux; write the flux of each in lm");
}

Head readHead(LineReader& reader, Photometry& photometry) {
  Head head;
  photometry.maker = shortText(reader.text("the maker"));
  (void)reader.blankOrWithin("the type indicator", 0, 3);
  head.symmetry = reader.count("the symmetry indicator", 0, 4);
  head.planes = reader.count("the number of C planes", 1, kMaxPlanes);
  (void)reader.blankOrWithin("the distance of C planes", 0, 360);
  head.gammas = reader.count("the number of intensities in a plane", 2, kMaxGammas);
  (void)reader.blankOrWithin("the distance of intensities", 0, 180);
  (void)reader.text("the number of the measurement");
  const std::string_view name = reader.text("the luminaire's name");
  const std::string_view number = reader.text("the luminaire's number");
  photometry.name = shortText(trimmed(name).empty() ? number : name);
  (void)reader.text("the file's name");
  (void)reader.text("the date");
  readSizes(reader, photometry);
  head.downwardShare = reader.blankOrWithin("the downward flux fraction", 0, kMaxPercent);
  head.outputRatio = reader.blankOrWithin("the light output ratio", 0, kMaxPercent);
  head.conversion = reader.blankOrWithin("the conversion factor", 0, kMaxFactor);
  if (head.conversion == 0) head.conversion = 1;
  const double tilt = reader.blankOrWithin("the tilt during measurement", -360, 360);
  if (tilt != 0 && !reader.failure())
    photometry.warnings.push_back("line " + std::to_string(reader.line()) + ": measured at a tilt of " +
                                  shortNumber(tilt) + " degrees; taken as if it hung level");
  readLamps(reader, head, photometry);
  return head;
}

/// Sets symmetry and c: those of all `planes` whose intensities follow, in the order in which they follow.
void choosePlanes(LineReader& reader, const Head& head, const std::vector<double>& planes,
                  Photometry& photometry) {
  using enum PhotometricSymmetry;
  if (reader.failure()) return;
  photometry.symmetry = std::array{kNone, kAxial, kC0C180, kC90C270, kQuadrant}[head.symmetry];
  const auto part = [&](std::size_t share) {
    if (head.planes % share != 0)
      reader.fail("symmetry " + std::to_string(head.symmetry) + " needs a number of C planes that " +
                  std::to_string(share) + " divides, not " + std::to_string(head.planes) +
                  " (lines 3 and 4)");
    return head.planes / share;
  };
  const auto expect = [&](std::size_t index, double angle) {
    if (!reader.failure() && (index >= planes.size() || planes[index] != angle))
      reader.fail("symmetry " + std::to_string(head.symmetry) + " (line 3) needs C plane " +
                  std::to_string(index + 1) + " to be " + shortNumber(angle) +
                  "; correct the symmetry or the list");
  };
  std::vector<double>& c = photometry.c;
  if (head.symmetry == 1) {
    c = {0};
  } else if (head.symmetry == 3) {
    // From C270 through C0 to C90; here told by their mirror images, from 270 down to 90.
    const std::size_t quarter = part(4);
    expect(0, 0), expect(quarter, 90), expect(3 * quarter, 270);
    for (std::size_t i = 3 * quarter; !reader.failure() && i <= head.planes + quarter; ++i)
      c.push_back(foldedPlane(kC90C270, planes[i % head.planes]));
  } else {
    const std::size_t last = head.symmetry == 0 ? head.planes - 1 : part(head.symmetry == 2 ? 2 : 4);
    expect(0, 0);
    if (head.symmetry != 0) expect(last, head.symmetry == 2 ? 180 : 90);
    if (!reader.failure()) c.assign(planes.begin(), planes.begin() + static_cast<std::ptrdiff_t>(last) + 1);
    if (head.symmetry == 0 && c.size() < 3) reader.fail("symmetry 0 (line 3) needs three C planes or more");
  }
}

/// Planes that were read from C270 down, in ascending order.
void turnPlanesRound(Photometry& photometry) {
  std::reverse(photometry.c.begin(), photometry.c.end());
  std::vector<double> ascending;
  for (std::size_t plane = photometry.c.size(); plane-- > 0;)
    for (std::size_t g = 0; g < photometry.gamma.size(); ++g) ascending.push_back(photometry.at(plane, g));
  photometry.candela = std::move(ascending);
}

void warnOfRatios(const Head& head, Photometry& photometry) {
  const double flux = integratedFlux(photometry), ratio = 100 * flux / head.lampFlux;
  const double downward = flux > 0 ? 100 * (1 - upwardShare(photometry)) : 0;
  if (head.outputRatio > 0 && std::abs(ratio - head.outputRatio) > 0.02 * head.outputRatio)
    photometry.warnings.push_back("line 23: the file says " + shortNumber(head.outputRatio) +
                                  " % of the lamps' flux (" + shortNumber(photometry.flux) +
                                  " lm), its table holds " + shortNumber(ratio) + " % (" + shortNumber(flux) +
                                  " lm)");
  if (head.downwardShare > 0 && std::abs(downward - head.downwardShare) > 2)
    photometry.warnings.push_back("line 22: the file says that " + shortNumber(head.downwardShare) +
                                  " % of the light goes down, its table " + shortNumber(downward) + " %");
}

}  // namespace

bool looksLikeEulumdat(const PhotometricText& text) {
  if (text.lines.size() < 8) return false;
  return std::count_if(text.lines.begin() + 1, text.lines.begin() + 7,
                       [](const std::string& line) { return numberOfLine(line).has_value(); }) >= 4;
}

Result<Photometry> readEulumdat(const PhotometricText& text) {
  Photometry photometry;
  photometry.format = PhotometricFormat::kEulumdat;
  photometry.longAxis = PhotometricAxis::kC90;
  LineReader reader(text);
  const Head head = readHead(reader, photometry);
  for (std::size_t i = 0; i < kDirectRatios; ++i) (void)reader.text("a direct ratio");
  const std::vector<double> planes = readAngles(reader, head.planes, "the C plane", 0, 360);
  choosePlanes(reader, head, planes, photometry);
  photometry.gamma = readAngles(reader, head.gammas, "the angle gamma", 0, 180);
  const std::size_t count = photometry.c.size() * photometry.gamma.size();
  photometry.candela = readCandela(reader, count, head.conversion * head.lampFlux / 1000);
  if (reader.failure()) return *reader.failure();
  if (reader.numberFollows())
    photometry.warnings.push_back(
        "line " + std::to_string(reader.line() + 1) +
        ": numbers follow after the last intensity; do lines 3, 4 and 6 agree with the lists?");
  if (photometry.symmetry == PhotometricSymmetry::kC90C270) turnPlanesRound(photometry);
  closeRound(photometry);
  const bool stated = head.outputRatio > 0 && !head.absolute;
  photometry.flux = head.lampFlux * (stated ? head.outputRatio / 100 : 1);
  warnOfRatios(head, photometry);
  return photometry;
}

}  // namespace fiatlux
