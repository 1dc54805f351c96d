#include "core/photometry/eulumdat_file.h"

#include <algorithm>
#include <cmath>

#include "core/photometry/color_temperature.h"
#include "core/photometry/photometric_values.h"
#include "core/photometry/planes.h"

namespace fiatlux {
namespace {

constexpr double kMillimetre = 0.001;  // m
constexpr std::size_t kDirectRatios = 10;
constexpr std::uint32_t kMaxSets = 100;

/// A line's number, with the comma that most of Europe writes.
std::optional<double> numberOfLine(std::string_view line) {
  std::string text(trimmed(line));
  std::replace(text.begin(), text.end(), ',', '.');
  return numberOf(text);
}

/// Lines one after the other. The first failure is kept; after it every call returns 0.
class LineReader {
 public:
  explicit LineReader(const PhotometricText& text) : lines_(text.lines) {}
  std::string_view text(const char* what) {
    if (failure_) return {};
    if (at_ < lines_.size()) return lines_[at_++];
    failure_ =
        errorAt(std::max<std::size_t>(1, at_), std::string("the file ends where ") + what +
                                                   " should stand; a line is missing or it was cut short, "
                                                   "fetch it again");
    return {};
  }
  double number(const char* what) {
    const std::string_view line = text(what);
    const std::optional<double> value = failure_ ? 0 : numberOfLine(line);
    if (!value)
      fail(quoted(line) + " stands where " + what + " should, and is no number; is a line missing above?");
    return value.value_or(0);
  }
  /// A blank line is 0.
  double numberOrBlank(const char* what) {
    if (!failure_ && at_ < lines_.size() && trimmed(lines_[at_]).empty()) return ++at_, 0;
    return number(what);
  }
  int whole(const char* what, int least, int most) {
    const double value = number(what);
    if (!failure_ && !(value >= least && value <= most && value == std::floor(value)))
      fail(std::string(what) + " is " + shortNumber(value) + ", but must be a whole number from " +
           std::to_string(least) + " to " + std::to_string(most) + "; is a line missing above?");
    return failure_ ? least : static_cast<int>(value);
  }
  void skip(std::size_t count, const char* what) {
    for (std::size_t i = 0; i < count && !failure_; ++i) (void)text(what);
  }
  /// Keeps `what` as the failure, at the line read last, unless there is one already.
  void fail(const std::string& what) {
    if (!failure_) failure_ = errorAt(at_, what);
  }
  std::size_t line() const { return at_; }
  bool numberFollows() const { return at_ < lines_.size() && numberOfLine(lines_[at_]); }
  const std::optional<Error>& failure() const { return failure_; }

 private:
  const std::vector<std::string>& lines_;
  std::size_t at_ = 0;
  std::optional<Error> failure_;
};

struct Head {
  int symmetry = 0;
  std::size_t planes = 0, gammas = 0;
  double downwardShare = 0, outputRatio = 0, conversion = 1, lampFlux = 0;  // %, %, -, lm
  bool absolute = false;
};

/// Lines 13 to 21.
void readSizes(LineReader& reader, Photometry& photometry) {
  (void)reader.numberOrBlank("the luminaire's length");
  (void)reader.numberOrBlank("the luminaire's width");
  (void)reader.numberOrBlank("the luminaire's height");
  LuminousArea& area = photometry.luminous;
  for (double* size : {&area.length, &area.width}) {
    *size = kMillimetre * reader.numberOrBlank("a length of the luminous area");
    if (*size < 0)
      reader.fail("a negative length of the luminous area; write millimetres, width 0 for round");
  }
  for (double& side : area.sides) {
    side = kMillimetre * reader.numberOrBlank("a height of the luminous area");
    if (side < 0) reader.fail("a negative height of the luminous area; write millimetres");
    area.height = std::max(area.height, side);
  }
  if (area.width > 0 || area.length == 0) return;
  area.round = true;
  area.shape = LuminousShape::kUprightCylinder;
  area.width = area.length;
}

/// Line 26 and the sets of lamps after it.
void readLamps(LineReader& reader, Head& head, Photometry& photometry) {
  const int sets = reader.whole("the number of sets of lamps", 1, static_cast<int>(kMaxSets));
  for (int set = 0; set < sets && !reader.failure(); ++set) {
    const double lamps = reader.number("a number of lamps");
    if (lamps == 0) reader.fail("0 lamps; write how many, or a negative number for absolute photometry");
    head.absolute = head.absolute || lamps < 0;
    (void)reader.text("a type of lamp");
    const double flux = reader.number("a flux of lamps");
    if (flux < 0) reader.fail(shortNumber(flux) + " lm; write the flux of this set's lamps");
    head.lampFlux += flux;
    const std::string_view color = reader.text("a colour temperature");
    if (!photometry.cct) photometry.cct = colorTemperatureOf(color);
    (void)reader.text("a colour rendering index");
    const double watts = reader.numberOrBlank("the watts of a set of lamps");
    if (watts < 0) reader.fail(shortNumber(watts) + " W; write the watts with ballast, or 0");
    photometry.watts += watts;
  }
  if (!reader.failure() && !(head.lampFlux > 0))
    reader.fail("no set of lamps has a flux; write the flux of each in lm");
}

Head readHead(LineReader& reader, Photometry& photometry) {
  Head head;
  photometry.maker = shortText(reader.text("the maker"));
  (void)reader.numberOrBlank("the type indicator (1, 2 or 3)");
  head.symmetry = reader.whole("the symmetry indicator", 0, 4);
  head.planes = static_cast<std::size_t>(reader.whole("the number of C planes", 1, kMaxPlanes));
  (void)reader.numberOrBlank("the distance of C planes");
  head.gammas = static_cast<std::size_t>(reader.whole("the number of intensities in a plane", 2, kMaxGammas));
  (void)reader.numberOrBlank("the distance of intensities");
  (void)reader.text("the number of the measurement");
  const std::string_view name = reader.text("the luminaire's name");
  const std::string_view number = reader.text("the luminaire's number");
  photometry.name = shortText(trimmed(name).empty() ? number : name);
  (void)reader.text("the file's name");
  (void)reader.text("the date");
  readSizes(reader, photometry);
  head.downwardShare = reader.numberOrBlank("the downward flux fraction");
  head.outputRatio = reader.numberOrBlank("the light output ratio");
  head.conversion = reader.numberOrBlank("the conversion factor");
  if (head.conversion < 0)
    reader.fail("a conversion factor of " + shortNumber(head.conversion) + "; write 1");
  if (head.conversion == 0) head.conversion = 1;
  if (const double tilt = reader.numberOrBlank("the tilt during measurement"); tilt != 0 && !reader.failure())
    photometry.warnings.push_back("line " + std::to_string(reader.line()) + ": measured at a tilt of " +
                                  shortNumber(tilt) + " degrees; taken as if it hung level");
  readLamps(reader, head, photometry);
  return head;
}

std::vector<double> readAngles(LineReader& reader, std::size_t count, const char* what, double most) {
  std::vector<double> angles;
  for (std::size_t i = 0; i < count && !reader.failure(); ++i) {
    const double angle = reader.number(what);
    if (angle < 0 || angle > most)
      reader.fail(std::string(what) + " of " + shortNumber(angle) + " is outside 0 to " + shortNumber(most) +
                  "; do the counts of lines 4 and 6 agree with the lists?");
    else if (i > 0 && angle <= angles.back())
      reader.fail(std::string(what) + " of " + shortNumber(angle) + " after " + shortNumber(angles.back()) +
                  ": they must ascend; do the counts of lines 4 and 6 agree with the lists?");
    angles.push_back(angle);
  }
  return angles;
}

/// Sets symmetry and c: those of all `planes` whose intensities follow, in the order in which they follow.
void choosePlanes(LineReader& reader, const Head& head, const std::vector<double>& planes,
                  Photometry& photometry) {
  using enum PhotometricSymmetry;
  if (reader.failure()) return;
  photometry.symmetry =
      std::array{kNone, kAxial, kC0C180, kC90C270, kQuadrant}[static_cast<std::size_t>(head.symmetry)];
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

void readCandela(LineReader& reader, double factor, Photometry& photometry) {
  const std::size_t count = photometry.c.size() * photometry.gamma.size();
  for (std::size_t i = 0; i < count && !reader.failure(); ++i) {
    const double value = factor * reader.number("an intensity");
    if (value < 0) reader.fail(shortNumber(value) + " cd: intensities cannot be negative; correct the value");
    if (value > kMaxCandela)
      reader.fail(shortNumber(value) + " cd is more than 1e7; correct the value or the lamps' flux");
    photometry.candela.push_back(value);
  }
  if (photometry.symmetry != PhotometricSymmetry::kC90C270 || reader.failure()) return;
  // Planes were read from 270 down: turn their order round.
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
  reader.skip(kDirectRatios, "a direct ratio");
  const std::vector<double> planes = readAngles(reader, head.planes, "a C plane", 360);
  choosePlanes(reader, head, planes, photometry);
  photometry.gamma = readAngles(reader, head.gammas, "an angle gamma", 180);
  if (reader.failure()) return *reader.failure();
  readCandela(reader, head.conversion * head.lampFlux / 1000, photometry);
  if (reader.failure()) return *reader.failure();
  if (reader.numberFollows())
    photometry.warnings.push_back(
        "line " + std::to_string(reader.line() + 1) +
        ": numbers follow after the last intensity; do lines 3, 4 and 6 agree with the lists?");
  closeRound(photometry);
  const bool stated = head.outputRatio > 0 && !head.absolute;
  photometry.flux = head.lampFlux * (stated ? head.outputRatio / 100 : 1);
  warnOfRatios(head, photometry);
  return photometry;
}

}  // namespace fiatlux
