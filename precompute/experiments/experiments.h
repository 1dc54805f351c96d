// The paper's section 5 run again on the E corridor (or another scene with a yellow wall): one function a
// subsection, each adding its part to the report, its plots and the raw runs.
#pragma once

#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "core/base/short_number.h"
#include "core/search/prepared_scene.h"
#include "core/search/vns.h"

namespace fiatlux {

/// What an experiment has to work with and what it leaves behind. The quantity is exitance, the paper's B.
struct Experiments {
  PreparedScene& prepared;
  SurfaceSet wall;  // the yellow wall
  std::uint32_t runs = 20, evaluations = 25000;
  bool byPairs = false;     // bounds by pairs of luminaires, too: minutes instead of seconds
  double flux = 1000;       // lm each
  std::string report = {};  // Markdown
  std::string rows = "experiment,seed,goal,violation,evaluations,found_at,seconds,sites\n";  // CSV
  std::vector<std::pair<std::string, std::string>> pictures = {};                            // file name, SVG
  std::vector<std::string> comparison = {};  // rows of the table of paper against ours

  // What later experiments take from earlier ones, lm/m2.
  double brightestWall = 0;  // the wall's mean when illuminated as much as possible
  double guaranteed = 0;     // the minimum that is guaranteed on every patch of it
};

/// Twenty runs (or `runs`) of one problem.
struct RunSummary {
  double least = 0, largest = 0, mean = 0, deviation = 0;  // of the goal in its unit
  double seconds = 0;                                      // per run, mean
  std::uint32_t feasible = 0;                              // runs that met every constraint
  Layout best;
  Evaluation bestEvaluation;
};

/// N luminaires of the experiments' flux with one goal.
Intentions problemOf(const Experiments& e, std::uint32_t count, Statistic statistic, Sense sense,
                     const SurfaceSet& surfaces);

/// Runs seeds 1..runs, writes a CSV row each.
RunSummary repeat(Experiments& e, const std::string& name, const Intentions& intentions);

/// Adds a plan of a layout's exitance as a picture and returns its Markdown. `brightest`: what is shown as
/// white.
std::string planOf(Experiments& e, const std::string& name, const Layout& layout, double brightest);

/// "proved optimal", "within 4.2 %" of the best possible, or "nothing proved".
std::string provedText(Experiments& e, const Intentions& intentions, const Evaluation& best);

/// As the report writes it.
inline std::string number(double value, int digits = 4) { return shortNumber(value, digits); }

void experimentDispersion(Experiments& e);  // 5.1
void experimentIntentions(Experiments& e);  // 5.2, and the exhaustive check for three luminaires
void experimentChebyshev(Experiments& e);   // 5.3; after 5.2, whose brightestWall it takes
void experimentAlpha(Experiments& e);       // 5.4; after 5.3, whose guaranteed it takes
void experimentSpeed(Experiments& e);       // 5.5

}  // namespace fiatlux
