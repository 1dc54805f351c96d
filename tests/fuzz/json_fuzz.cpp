// Hostile text as layout.json and as intentions.json: a value or one readable line, never more. What is
// accepted is also used, as the commands do: the layout is lit, seen and painted, the intentions are searched
// for, bounded and, where there is a guarantee, given an alpha, so that nothing which passes the checks may
// break what relies on them.
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <string>
#include <utility>
#include <vector>

#include "core/alpha/guarantees.h"
#include "core/bound/bound.h"
#include "core/session/session.h"
#include "precompute/files/asked_search.h"
#include "precompute/files/intentions_json.h"
#include "precompute/files/layout_json.h"
#include "precompute/files/photometric_layout.h"
#include "tests/core/operator_scene.h"
#include "tests/core/photometry/photometric_files.h"
#include "tests/fuzz/json_mutation.h"
#include "tests/fuzz/one_line.h"

extern "C" std::size_t LLVMFuzzerMutate(std::uint8_t* data, std::size_t size, std::size_t largest);

namespace {

using fiatlux::fuzz::requireOneLine;

const std::vector<std::string> kWords = {
    "luminaires",  "site",         "flux",        "position",      "normal",        "size",
    "axis",        "distribution", "lambertian",  "isotropic",     "dimming",       "count",
    "pinned",      "excluded",     "minDistance", "goals",         "constraints",   "quantity",
    "illuminance", "exitance",     "surface",     "statistic",     "sense",         "weight",
    "over",        "alpha",        "min",         "max",           "mean",          "sigma",
    "power",       "chebyshev",    "minimum",     "maximum",       "uniformity",    "contrast",
    "near",        "target",       "floor",       "wall \xc3\xa9", "desk plane",    "all",
    "types",       "photometry",   "turns",       "aims",          "watts",         "fixed",
    "luminaire",   "spot.ies",     "panel.ldt",   "turn",          "aim",           "arrangement",
    "rule",        "symmetric",    "rows",        "field",         "free",          "found",
    "both",        "observers",    "observer",    "direction",     "directions",    "name",
    "room",        "ugr",          "cylindrical", "modelling",     "vertical",      "of",
    "direct",      "planes",       "paint",       "reflectance",   "maxAimingAngle"};

constexpr std::size_t kMostSeen = 3;  // observers and planes: more take time and find nothing

const fiatlux::Scene& room() {
  static const fiatlux::Scene scene = fiatlux::operatorScene(8, 4);
  return scene;
}

/// The photometric files that a document may name.
fiatlux::Result<std::vector<std::uint8_t>> fileNamed(const std::string& name) {
  static const std::string spot = fiatlux::samples::IesFile{}.text(),
                           panel = fiatlux::samples::LdtFile{}.text();
  if (name != "spot.ies" && name != "panel.ldt") return fiatlux::Error{"does not exist"};
  const std::string& text = name == "spot.ies" ? spot : panel;
  return std::vector<std::uint8_t>(text.begin(), text.end());
}

void require(bool good) {
  if (!good) std::abort();
}

/// A value, or nothing and an error of one line.
template <class T>
bool isThere(const fiatlux::Result<T>& result) {
  if (!result) requireOneLine(result.error().message);
  return bool(result);
}

/// What `fiatlux evaluate` does.
void evaluate(const fiatlux::LayoutFile& file) {
  fiatlux::Scene here = room();
  std::vector<std::string> notes;
  const fiatlux::Result<fiatlux::Layout> layout = fiatlux::layoutOnSites(file, here, notes);
  if (!isThere(layout)) return;
  const auto light = photometricIlluminance(file, *layout, here, notes);
  for (const std::string& note : notes) requireOneLine(note);
  if (!isThere(light)) return;
  for (const float lux : *light) require(lux >= 0);
  std::vector<float> painted = *light;
  (void)isThere(paintScene(file.paint, here, painted));
  const std::vector<fiatlux::Observer> observers = fiatlux::observersFor(file.observers, here.patches);
  if (observers.size() <= kMostSeen) (void)isThere(observerReadings(file, *layout, here, observers, *light));
  if (file.planes.size() <= kMostSeen) (void)isThere(planeReadings(file, *layout, here, *light));
}

void tryLayout(const std::string& text) {
  const fiatlux::Result<fiatlux::LayoutFile> file = fiatlux::parseLayout(text, fileNamed);
  if (!isThere(file)) return;
  evaluate(*file);
  for (const auto& sites : {std::vector<fiatlux::Site>{}, room().sites}) {
    const auto luminaires = fiatlux::freeLuminaires(*file, sites);
    if (!isThere(luminaires)) continue;
    for (const fiatlux::Luminaire& one : *luminaires)
      require(one.flux >= 0 && std::fabs(fiatlux::length(one.normal) - 1) < 1e-9);
  }
}

/// What `fiatlux solve` and `alpha` do, and the page.
void tryIntentions(const std::string& text) {
  fiatlux::Scene here = room();
  fiatlux::Result<fiatlux::IntentionsFile> file = fiatlux::parseIntentionsFile(here, text, fileNamed);
  if (!isThere(file) || file->intentions.observers.size() > kMostSeen) return;
  const auto asked = fiatlux::AskedSearch::make(here, std::move(*file));
  if (!isThere(asked)) return;
  fiatlux::Session session;
  session.adopt(asked->scene());
  require(bool(session.setIntentions(asked->intentions())) && bool(session.start(1, nullptr)));
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
