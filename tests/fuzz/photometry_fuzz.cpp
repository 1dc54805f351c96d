// Hostile bytes as a photometric file: a table that keeps every promise of its header, or one readable line.
// Numbers and lines are taken out, doubled and replaced by extreme ones, for random bytes seldom leave a
// number behind.
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <functional>
#include <iterator>
#include <string>

#include "core/base/random.h"
#include "core/photometry/intensity.h"
#include "core/photometry/luminous_area.h"
#include "core/photometry/photometric_values.h"
#include "core/photometry/photometry.h"
#include "core/photometry/unified_glare.h"
#include "tests/fuzz/one_line.h"

extern "C" std::size_t LLVMFuzzerMutate(std::uint8_t* data, std::size_t size, std::size_t largest);

namespace {

using fiatlux::Photometry;
using fiatlux::Random;

void require(bool good, const char* what) {
  if (good) return;
  std::fprintf(stderr, "a photometric file that was let in %s\n", what);
  std::abort();
}

bool ascending(const std::vector<double>& angles, double least, double most) {
  return angles.front() >= least && angles.back() <= most &&
         std::adjacent_find(angles.begin(), angles.end(), std::greater_equal<>()) == angles.end();
}

void requireTable(const Photometry& p) {
  using enum fiatlux::PhotometricSymmetry;
  require(p.gamma.size() >= 2 && p.gamma.size() <= fiatlux::kMaxGammas, "has no gammas or too many");
  require(p.c.size() >= 1 && p.c.size() <= fiatlux::kMaxPlanes + 1, "has no planes or too many");
  require(p.candela.size() == p.c.size() * p.gamma.size(), "has a table of another size");
  require(ascending(p.gamma, 0, 180) && ascending(p.c, 0, 360), "has angles out of order");
  const double first = p.symmetry == kC90C270 ? 90 : 0;
  const double last = p.symmetry == kAxial      ? 0
                      : p.symmetry == kQuadrant ? 90
                      : p.symmetry == kC0C180   ? 180
                      : p.symmetry == kC90C270  ? 270
                                                : 360;
  require(p.c.front() == first && p.c.back() == last, "has planes of another symmetry");
  for (const double candela : p.candela)
    require(candela >= 0 && candela <= fiatlux::kMaxCandela, "has wrong intensities");
}

/// What the card and the light ask of a table.
void use(const Photometry& p, Random& random) {
  const double most = fiatlux::maxCandela(p), flux = fiatlux::integratedFlux(p);
  require(flux > 0 && flux <= 4.001 * 3.1415927 * most, "has wrong flux");
  require(std::isfinite(p.flux) && p.flux > 0 && std::isfinite(p.watts) && p.watts >= 0, "states wrong flux");
  const double up = fiatlux::upwardShare(p);
  require(up >= 0 && up <= 1, "has a wrong upward share");
  for (const double share : {0.1, 0.5}) {
    const double angle = fiatlux::openingAngle(p, share);
    require(angle >= 0 && angle <= 360, "opens wrongly");
  }
  for (int i = 0; i < 20; ++i) {
    const auto component = [&] { return 2 * random.unit() - 1; };
    const fiatlux::Vec3 d = fiatlux::normalized({component(), component(), component()});
    const double candela = fiatlux::intensity(p, d), area = fiatlux::projectedArea(p.luminous, p.longAxis, d);
    require(candela >= 0 && candela <= most * (1 + 1e-12), "has a wrong intensity between its angles");
    require(area >= 0 && std::isfinite(area), "has a wrong luminous area");
  }
  if (random.below(16) > 0) return;  // slow
  const std::optional<double> ugr = fiatlux::ugr4h8h(p);
  require(!ugr || std::isfinite(*ugr), "has a wrong UGR");
}

bool ofNumber(char c) {
  return (c >= '0' && c <= '9') || c == '-' || c == '+' || c == '.' || c == 'e' || c == 'E';
}

/// The number or the line around a random place.
std::pair<std::size_t, std::size_t> partAround(const std::string& text, Random& random, bool line) {
  const auto within = [&](char c) { return line ? c != '\n' : ofNumber(c); };
  std::size_t begin = random.below(static_cast<std::uint32_t>(text.size()));
  while (begin > 0 && within(text[begin - 1])) --begin;
  std::size_t end = begin;
  while (end < text.size() && within(text[end])) ++end;
  return {begin, std::min(text.size(), end + 1)};
}

void mutate(std::string& text, Random& random) {
  static const char* const kNumbers[] = {"0",   "-1",  "1",   "2",   "3",    "90",    "180",
                                         "360", "0.5", "1e7", "1e9", "1e-9", "1e308", "1e-308",
                                         "NaN", "361", "721", "-90", "1,5",  "0.0001"};
  const std::uint32_t way = random.below(6);
  const auto [begin, end] = partAround(text, random, way >= 3);
  const std::string part = text.substr(begin, end - begin);
  if (way < 2)
    text.replace(begin, std::max<std::size_t>(1, end - begin) - 1,
                 kNumbers[random.below(std::size(kNumbers))]);
  else if (way == 2 || way == 3)
    text.erase(begin, end - begin);
  else if (way == 4)
    text.insert(begin, part);
  else
    text.insert(std::min(text.size(), partAround(text, random, true).first), part);
}

}  // namespace

extern "C" std::size_t LLVMFuzzerCustomMutator(std::uint8_t* data, std::size_t size, std::size_t largest,
                                               unsigned seed) {
  Random random(seed);
  if (size == 0 || random.below(8) == 0) return LLVMFuzzerMutate(data, size, largest);
  std::string text(reinterpret_cast<const char*>(data), size);
  for (std::uint32_t i = 0; i <= random.below(3) && !text.empty(); ++i) mutate(text, random);
  if (text.empty() || text.size() > largest) return LLVMFuzzerMutate(data, size, largest);
  std::memcpy(data, text.data(), text.size());
  return text.size();
}

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const fiatlux::Result<Photometry> photometry = fiatlux::readPhotometry({data, size});
  if (!photometry) return fiatlux::fuzz::requireOneLine(photometry.error().message), 0;
  requireTable(*photometry);
  Random random(static_cast<std::uint32_t>(size));
  use(*photometry, random);
  return 0;
}
