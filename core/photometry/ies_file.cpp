#include "core/photometry/ies_file.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/photometry/color_temperature.h"
#include "core/photometry/ies_opening.h"
#include "core/photometry/photometric_numbers.h"
#include "core/photometry/planes.h"
#include "core/photometry/type_c.h"

namespace fiatlux {
namespace {

using enum PhotometricFormat;
constexpr double kFoot = 0.3048, kMaxLength = 1000;  // m; m or feet of an opening

std::string upper(std::string_view text) {
  std::string result(text);
  for (char& c : result)
    if (c >= 'a' && c <= 'z') c = static_cast<char>(c - 'a' + 'A');
  return result;
}

/// TILT=..., with blanks about the sign perhaps; a label such as "Tiltable spot" is none.
bool isTilt(std::string_view line) {
  line = trimmed(line);
  return upper(line.substr(0, 4)) == "TILT" && trimmed(line.substr(4)).substr(0, 1) == "=";
}

/// The vintage that the first line names; none where it names none.
std::optional<PhotometricFormat> taggedFormat(std::string_view line) {
  const std::string tag = upper(trimmed(line));
  if (tag.rfind("IES", 0) != 0) return {};
  if (tag == "IESNA91" || tag.find("LM-63-1991") != tag.npos) return kLm63_1991;
  if (tag.find("LM-63-1995") != tag.npos || tag == "IESNA95") return kLm63_1995;
  if (tag.find("LM-63-2002") != tag.npos) return kLm63_2002;
  if (tag.find("LM-63-") != tag.npos) return tag.find("1986") != tag.npos ? kLm63_1986 : kLm63_2019;
  return tag == "IESNA86" ? std::optional(kLm63_1986) : std::nullopt;
}

/// Index of the first line that is not blank; 0 where all are.
std::size_t firstLineOf(const PhotometricText& text) {
  const auto line = std::find_if(text.lines.begin(), text.lines.end(),
                                 [](const std::string& line) { return !trimmed(line).empty(); });
  return line == text.lines.end() ? 0 : static_cast<std::size_t>(line - text.lines.begin());
}

/// What the lines above TILT say in words.
struct Words {
  std::string luminaire, catalogue, maker, firstLine;
  std::optional<double> cct;
};

void keepWord(Words& words, const std::string& keyword, std::string_view value, std::string*& last) {
  std::string* target = keyword == "LUMINAIRE" ? &words.luminaire
                        : keyword == "LUMCAT"  ? &words.catalogue
                        : keyword == "MANUFAC" ? &words.maker
                        : keyword == "MORE"    ? last
                                               : nullptr;
  last = target;
  if (target && !trimmed(value).empty())
    *target += std::string(target->empty() ? "" : " ").append(trimmed(value));
  const bool ofColor = keyword.find("CCT") != keyword.npos || keyword.find("COLORTEMP") != keyword.npos;
  if (!words.cct && ofColor) words.cct = colorTemperatureOf(value);
  if (!words.cct && (ofColor || keyword == "LAMP" || keyword == "LAMPCAT" || keyword == "LUMINAIRE"))
    words.cct = colorTemperatureIn(value);
}

/// Reads the [KEYWORD] lines from index `first` to TILT; of a file without them the first line of text, and
/// the colour that any line tells ("LED 3000K").
Words wordsAbove(const PhotometricText& text, std::size_t first, std::size_t tiltLine) {
  Words words;
  std::string* last = nullptr;
  std::optional<double> plainCct;
  for (std::size_t i = first; i + 1 < tiltLine; ++i) {
    const std::string_view line = trimmed(text.lines[i]);
    const std::size_t end = line.find(']');
    if (line.empty()) continue;
    if (line[0] == '[' && end != line.npos) {
      keepWord(words, upper(trimmed(line.substr(1, end - 1))), line.substr(end + 1), last);
      continue;
    }
    if (words.firstLine.empty()) words.firstLine = line;
    if (!plainCct) plainCct = colorTemperatureIn(line);
  }
  if (!words.cct) words.cct = plainCct;
  return words;
}

/// The lamp's lines after TILT=INCLUDE: read and checked, but they do not change a luminaire that hangs as
/// measured.
void readTilt(NumberReader& reader, Photometry& photometry) {
  (void)reader.count("the lamp's position (1, 2 or 3) of TILT=INCLUDE", 1, 3);
  const std::size_t pairs = reader.count("the number of tilt angles", 1, kMaxGammas);
  double least = 1, most = 1;
  for (std::size_t i = 0; i < pairs && !reader.failure(); ++i) (void)reader.next("a tilt angle");
  for (std::size_t i = 0; i < pairs && !reader.failure(); ++i) {
    const double factor = reader.next("a tilt factor");
    least = std::min(least, factor), most = std::max(most, factor);
  }
  if (least != most)
    photometry.warnings.push_back(
        "the lamp's flux changes with the luminaire's tilt (TILT=INCLUDE); it is taken as it hangs untilted");
}

struct Header {
  double lumens = 0, factor = 1;  // of a lamp; of the candela
  std::size_t lamps = 1, verticals = 0, horizontals = 0, type = 1;
  IesOpening opening;
};

/// The factor that the lamps' and the ballast's numbers put on flux and candela; also reads the watts.
double readBallast(NumberReader& reader, Photometry& photometry) {
  const double ballast = reader.within("the ballast factor", 0, kMaxFactor);
  const double second = reader.within("the number after the ballast factor", -kMaxFactor, kMaxFactor);
  if (photometry.format <= kLm63_1991) return reader.failure() ? 0 : ballast * second;
  if (photometry.format != kLm63_2019 && second != 1 && !reader.failure())
    photometry.warnings.push_back("line " + std::to_string(reader.line()) + ": the unused factor is " +
                                  shortNumber(second) + " instead of 1; it is not applied");
  return ballast;
}

Header readHeader(NumberReader& reader, Photometry& photometry) {
  Header header;
  header.lamps = reader.count("the number of lamps", 1, 10000);
  header.lumens = reader.within("the lumens per lamp (-1 for absolute photometry)", -1, kMaxLumens);
  if (header.lumens < 0 && header.lumens != -1)
    reader.fail("the lumens per lamp are negative; write -1 or a flux");
  header.factor = reader.within("the candela multiplier", 0, kMaxFactor);
  header.verticals = reader.count("the number of vertical angles", 2, kMaxGammas);
  header.horizontals = reader.count("the number of horizontal angles", 1, kMaxPlanes);
  header.type = reader.count("the photometric type (1 = C, 2 = B, 3 = A)", 1, 3);
  const bool feet = reader.count("the unit (1 = feet, 2 = metres)", 1, 2) == 1;
  header.opening.before2002 = photometry.format < kLm63_2002;
  for (double* size : {&header.opening.width, &header.opening.length, &header.opening.height})
    *size = reader.within("a length of the luminous opening", -kMaxLength, kMaxLength) * (feet ? kFoot : 1);
  const double lamp = readBallast(reader, photometry);
  photometry.watts = reader.within("the input watts", 0, kMaxWatts);
  header.factor *= lamp;
  if (!(header.factor > 0))
    reader.fail("multiplier and ballast factors make " + shortNumber(header.factor) +
                "; they must be above 0, export the file again");
  photometry.flux = header.lumens > 0 ? static_cast<double>(header.lamps) * header.lumens * lamp : 0;
  return header;
}

/// Intensities, the last numbers of the file.
std::vector<double> readTable(NumberReader& reader, std::size_t count, double factor) {
  std::vector<double> candela = readCandela(reader, count, factor);
  // note: where a list of angles is longer than announced, everything after it is read one place too early
  if (!reader.failure() && reader.numberFollows())
    reader.fail(
        "more numbers follow than the counts of angles announce; correct the counts or export the file "
        "again");
  return candela;
}

/// The symmetry that a list of horizontal angles of type C stands for.
PhotometricSymmetry symmetryOf(NumberReader& reader, const std::vector<double>& c) {
  using enum PhotometricSymmetry;
  if (reader.failure() || c.size() == 1) return kAxial;
  const double first = c.front(), last = c.back();
  if (first == 0 && last == 90) return kQuadrant;
  if (first == 0 && last == 180) return kC0C180;
  if (first == 90 && last == 270) return kC90C270;
  // note: many leave out 360, whose plane is that of 0
  const bool round = last == 360 || (360 - last <= 1.01 * (last - c[c.size() - 2]) && c.size() < kMaxPlanes);
  if (!(first == 0 && last > 180 && round))
    reader.fail("the horizontal angles go from " + shortNumber(first) + " to " + shortNumber(last) +
                "; they must be 0 alone, go from 0 to 90, 180 or 360, or from 90 to 270");
  return kNone;
}

void readTypeC(NumberReader& reader, const Header& header, Photometry& photometry) {
  photometry.gamma = readAngles(reader, header.verticals, "the vertical angle", 0, 180);
  photometry.c = readAngles(reader, header.horizontals, "the horizontal angle", 0, 360);
  photometry.symmetry = symmetryOf(reader, photometry.c);
  // A lone plane stands for all, whatever its angle.
  if (photometry.symmetry == PhotometricSymmetry::kAxial) photometry.c.assign(1, 0);
  photometry.candela = readTable(reader, photometry.gamma.size() * photometry.c.size(), header.factor);
  photometry.luminous = areaOf(header.opening);
}

void readBeam(NumberReader& reader, const Header& header, Photometry& photometry) {
  BeamTable table;
  table.typeA = header.type == 3;
  const double around = 180, within = 90;
  table.vertical = readAngles(reader, header.verticals, "the vertical angle", table.typeA ? -within : -around,
                              table.typeA ? within : around);
  table.horizontal = readAngles(reader, header.horizontals, "the horizontal angle",
                                table.typeA ? -around : -within, table.typeA ? around : within);
  if (header.horizontals < 2)
    reader.fail("types A and B need two horizontal angles or more; export as type C");
  table.candela = readTable(reader, table.vertical.size() * table.horizontal.size(), header.factor);
  if (reader.failure()) return;
  resampleAsTypeC(table, photometry);
  photometry.luminous = areaOfBeam(header.opening);
}

/// The line of TILT, from 1; 0 where there is none.
std::size_t tiltLineOf(const PhotometricText& text) {
  const auto line = std::find_if(text.lines.begin(), text.lines.end(), isTilt);
  return line == text.lines.end() ? 0 : static_cast<std::size_t>(line - text.lines.begin()) + 1;
}

/// Does the line hold the counts that follow TILT: ten numbers, of which some can be 1 to 3 only?
bool holdsCounts(const std::string& line, Comma comma) {
  const PhotometricText alone{{line}};
  StreamReader reader(alone, 1, comma);
  std::vector<double> values;
  while (reader.numberFollows()) values.push_back(reader.next("a count"));
  const auto whole = [&](std::size_t i, double least, double most) {
    return values[i] >= least && values[i] <= most && values[i] == std::floor(values[i]);
  };
  return values.size() >= 10 && values.size() <= 13 && whole(0, 1, 1e4) && whole(3, 2, kMaxGammas) &&
         whole(4, 1, kMaxPlanes) && whole(5, 1, 3) && whole(6, 1, 2);
}

/// What is wrong with a file that has no TILT line.
Error withoutTilt(const PhotometricText& text) {
  if (const std::size_t line = countsLineOf(text))
    return errorAt(line, "the TILT= line is missing before these counts; insert a line TILT=NONE above them");
  return errorAt(std::max<std::size_t>(1, text.lines.size()),
                 "the file ends without a TILT= line; it was cut short, fetch it again");
}

Result<Photometry> readNumbersBy(Comma comma, const PhotometricText& text) {
  Photometry photometry;
  const std::size_t first = firstLineOf(text);
  const std::optional<PhotometricFormat> tag = taggedFormat(text.lines[first]);
  photometry.format = tag.value_or(kLm63_1986);
  const std::size_t tiltLine = tiltLineOf(text);
  if (tiltLine == 0) return withoutTilt(text);
  const Words words = wordsAbove(text, first + (tag ? 1 : 0), tiltLine);
  photometry.name = shortText(!words.luminaire.empty()   ? words.luminaire
                              : !words.catalogue.empty() ? words.catalogue
                                                         : words.firstLine);
  photometry.maker = shortText(words.maker);
  photometry.cct = words.cct;
  StreamReader reader(text, tiltLine + 1, comma);
  const std::string_view tiltText = text.lines[tiltLine - 1];
  const std::string_view tilt = trimmed(tiltText.substr(tiltText.find('=') + 1));
  if (upper(tilt) == "INCLUDE")
    readTilt(reader, photometry);
  else if (upper(tilt) != "NONE")
    return errorAt(tiltLine, "TILT names the file " + quoted(tilt) + ", which is not read" +
                                 (photometry.format == kLm63_2019 ? " (and which LM-63-2019 forbids)" : "") +
                                 "; put its lines here after TILT=INCLUDE, or write TILT=NONE");
  const Header header = readHeader(reader, photometry);
  header.type == 1 ? readTypeC(reader, header, photometry) : readBeam(reader, header, photometry);
  if (reader.failure()) return *reader.failure();
  closeRound(photometry);
  photometry.longAxis = PhotometricAxis::kC0;
  return photometry;
}

}  // namespace

bool looksLikeIes(const PhotometricText& text) {
  return !text.lines.empty() && (taggedFormat(text.lines[firstLineOf(text)]) || tiltLineOf(text) > 0);
}

std::size_t countsLineOf(const PhotometricText& text) {
  const auto line = std::find_if(text.lines.begin(), text.lines.end(), [](const std::string& line) {
    return holdsCounts(line, Comma::kParts) || holdsCounts(line, Comma::kIsDecimal);
  });
  return line == text.lines.end() ? 0 : static_cast<std::size_t>(line - text.lines.begin()) + 1;
}

Result<Photometry> readIes(const PhotometricText& text) {
  Result<Photometry> read = readNumbersBy(Comma::kParts, text);
  if (read) return read;
  // A decimal comma parts a number in two, so that the counts do not fit: then it is one where they fit so.
  Result<Photometry> other = readNumbersBy(Comma::kIsDecimal, text);
  return other ? other : read;
}

}  // namespace fiatlux
