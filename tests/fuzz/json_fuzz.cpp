// Hostile text as layout.json and as intentions.json: a value or one readable line, never more. What is
// accepted is also used: the layout is lit, the intentions are searched for, bounded and, where there is a
// guarantee, given an alpha, so that nothing which passes the checks may break what relies on them.
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <string>

#include "core/alpha/guarantees.h"
#include "core/bound/bound.h"
#include "core/session/session.h"
#include "precompute/files/intentions_json.h"
#include "precompute/files/layout_json.h"
#include "tests/core/synthetic_scene.h"
#include "tests/fuzz/json_mutation.h"
#include "tests/fuzz/one_line.h"

extern "C" std::size_t LLVMFuzzerMutate(std::uint8_t* data, std::size_t size, std::size_t largest);

namespace {

using fiatlux::fuzz::requireOneLine;

const std::vector<std::string> kWords = {
    "luminaires",   "site",       "flux",        "position",  "normal",        "size",       "axis",
    "distribution", "lambertian", "isotropic",   "dimming",   "count",         "pinned",     "excluded",
    "minDistance",  "goals",      "constraints", "quantity",  "illuminance",   "exitance",   "surface",
    "statistic",    "sense",      "weight",      "over",      "alpha",         "min",        "max",
    "mean",         "sigma",      "power",       "chebyshev", "minimum",       "maximum",    "uniformity",
    "contrast",     "near",       "target",      "floor",     "wall \xc3\xa9", "desk plane", "all"};

const fiatlux::Scene& room() {
  static const fiatlux::Scene scene = fiatlux::syntheticScene(8, 4);
  return scene;
}

void require(bool good) {
  if (!good) std::abort();
}

void tryLayout(const std::string& text) {
  const fiatlux::Result<fiatlux::LayoutFile> file = fiatlux::parseLayout(text);
  if (!file) return requireOneLine(file.error().message);
  std::vector<std::string> notes;
  const fiatlux::Result<fiatlux::Layout> layout = fiatlux::layoutOnSites(*file, room(), notes);
  for (const std::string& note : notes) requireOneLine(note);
  if (!layout) requireOneLine(layout.error().message);
  if (layout)
    for (const float light : fiatlux::illuminanceOf(room(), *layout)) require(light >= 0);
  for (const auto& sites : {std::vector<fiatlux::Site>{}, room().sites}) {
    const auto luminaires = fiatlux::freeLuminaires(*file, sites);
    if (!luminaires) requireOneLine(luminaires.error().message);
    if (luminaires)
      for (const fiatlux::Luminaire& one : *luminaires)
        require(one.flux >= 0 && std::fabs(fiatlux::length(one.normal) - 1) < 1e-9);
  }
}

void tryIntentions(const std::string& text) {
  const fiatlux::Result<fiatlux::Intentions> intentions = fiatlux::parseIntentions(room(), text);
  if (!intentions) return requireOneLine(intentions.error().message);
  static fiatlux::Session session;
  if (!session.scene()) session.adopt(room());
  require(bool(session.setIntentions(*intentions)) && bool(session.start(1, nullptr)));
  const fiatlux::SearchProgress found = session.advance(100);
  require(!std::isnan(found.evaluation.goal) && !std::isnan(found.evaluation.violation));
  const auto shown = session.incumbent();
  require(bool(shown));
  for (const fiatlux::SurfaceReading& reading : shown->surfaces)
    require(reading.mean >= 0 && reading.sigma >= 0);
  require(bool(session.startBound()));
  for (int slice = 0; slice < 3 && !session.bound()->done(); ++slice) session.bound()->advance(100);
  require(!std::isnan(session.bound()->goal()));
  if (!session.startAlpha(1)) return;
  session.alpha()->advance(300);
  if (session.alpha()->done()) requireOneLine(session.alpha()->verdict());
}

}  // namespace

extern "C" std::size_t LLVMFuzzerCustomMutator(std::uint8_t* data, std::size_t size, std::size_t largest,
                                               unsigned seed) {
  fiatlux::Random random(seed);
  std::string text;
  if (random.below(5) > 0) text = fiatlux::fuzz::mutated({data, data + size}, random, kWords);
  if (text.empty() || text.size() > largest) return LLVMFuzzerMutate(data, size, largest);
  std::memcpy(data, text.data(), text.size());
  return text.size();
}

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string text(data, data + size);
  tryLayout(text);
  tryIntentions(text);
  return 0;
}
