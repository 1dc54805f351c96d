// What the experiments share; see experiments.h.
#include "precompute/experiments/experiments.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "core/bound/bound.h"
#include "precompute/experiments/processor_time.h"
#include "precompute/experiments/svg_plot.h"

namespace fiatlux {

Intentions problemOf(const Experiments& e, std::uint32_t count, Statistic statistic, Sense sense,
                     const SurfaceSet& surfaces) {
  Intentions intentions;
  intentions.luminaires.count = count;
  intentions.luminaires.flux = {e.flux};
  intentions.goals = {{statistic, sense, 1, surfaces, {}}};
  intentions.quantity = Quantity::kExitance;
  return intentions;
}

RunSummary repeat(Experiments& e, const std::string& name, const Intentions& intentions) {
  RunSummary summary;
  std::vector<double> values;
  for (std::uint64_t seed = 1; seed <= e.runs; ++seed) {
    const ProcessorTime time;
    Vns vns(e.prepared, intentions, seed);
    vns.advance(e.evaluations);
    const double seconds = time.seconds();
    Evaluator evaluator(e.prepared, intentions);
    evaluator.load(vns.incumbent().sites);
    values.push_back(evaluator.goalValue(0));
    summary.seconds += seconds / e.runs;
    summary.feasible += vns.evaluation().violation <= 1e-9;
    if (seed == 1 || isBetter(vns.evaluation(), summary.bestEvaluation)) {
      summary.best = vns.incumbent();
      summary.bestEvaluation = vns.evaluation();
    }
    e.rows += name + "," + std::to_string(seed) + "," + number(values.back(), 9) + "," +
              number(vns.evaluation().violation, 6) + "," + std::to_string(vns.evaluations()) + "," +
              std::to_string(vns.foundAt()) + "," + number(seconds, 4) + ",";
    for (std::uint32_t site : vns.incumbent().sites) e.rows += std::to_string(site) + " ";
    e.rows.back() = '\n';
  }
  summary.least = *std::min_element(values.begin(), values.end());
  summary.largest = *std::max_element(values.begin(), values.end());
  for (double value : values) summary.mean += value / static_cast<double>(values.size());
  double squares = 0;
  for (double value : values) squares += (value - summary.mean) * (value - summary.mean);
  summary.deviation = std::sqrt(squares / static_cast<double>(values.size()));
  return summary;
}

std::string planOf(Experiments& e, const std::string& name, const Layout& layout, double brightest) {
  std::vector<float> exitance = illuminanceOf(e.prepared.scene(), layout);
  for (std::size_t p = 0; p < exitance.size(); ++p) exitance[p] *= e.prepared.scene().patches.reflectance[p];
  e.pictures.emplace_back(name + ".svg", svgPlan(e.prepared.scene(), exitance, brightest, layout));
  return "![" + name + "](" + name + ".svg)";
}

std::string provedText(Experiments& e, const Intentions& intentions, const Evaluation& best) {
  OptimumBound bound(e.prepared, intentions, best);
  if (!e.byPairs) bound.takePairs();
  while (!bound.done()) bound.advance(1u << 12);
  const std::optional<double> within = bound.within(best);
  if (!within) return "nothing proved";
  return *within < 1e-5 ? "proved optimal" : "within " + number(100 * *within, 3) + " %";
}

}  // namespace fiatlux
