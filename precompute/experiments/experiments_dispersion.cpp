// Section 5.1 and figure 3: how evenly six luminaires can light the whole scene, and a ladder of dispersions.
#include <cmath>

#include "precompute/experiments/experiments.h"

namespace fiatlux {
namespace {

std::string rowOf(const std::string& name, const RunSummary& s, const std::string& proved) {
  return "| " + name + " | " + number(s.least) + " | " + number(s.largest) + " | " + number(s.mean) + " | " +
         number(s.deviation, 2) + " | " + number(1e3 * s.seconds, 3) + " ms | " + proved + " |\n";
}

}  // namespace

void experimentDispersion(Experiments& e) {
  Intentions problem = problemOf(e, 6, Statistic::kSigma, Sense::kMinimize, {});
  const RunSummary even = repeat(e, "5.1 min sigma", problem);
  const std::string evenProof = provedText(e, problem, even.bestEvaluation);
  Intentions opposite = problemOf(e, 6, Statistic::kSigma, Sense::kMaximize, {});
  const RunSummary uneven = repeat(e, "5.1 max sigma", opposite);
  e.report +=
      "## 5.1 Dispersion\n\nSix luminaires, sigma of the reflected light of the whole scene, " +
      std::to_string(e.runs) + " runs of " + std::to_string(e.evaluations) +
      " evaluations. Values in lm/m2.\n\n| goal | least | largest | mean | sd | time a run | best run |\n"
      "|---|---|---|---|---|---|---|\n";
  e.report += rowOf("min sigma", even, evenProof);
  e.report += rowOf("max sigma", uneven, provedText(e, opposite, uneven.bestEvaluation));
  // The paper's ladder 3.51, 2.1, 1.52, 1.03, 0.43, as shares of its largest.
  std::string plans = planOf(e, "dispersion-1", uneven.best, 30);
  int rung = 2;
  for (const double share : {2.1 / 3.51, 1.52 / 3.51, 1.03 / 3.51}) {
    Intentions ladder = problem;
    ladder.constraints = {{Statistic::kSigma, share * uneven.largest, kUnbounded, 1, {}, {}}};
    const RunSummary step = repeat(e, "5.1 sigma at least " + number(share, 3) + " of max", ladder);
    e.report += rowOf("min sigma, at least " + number(share * uneven.largest), step, "-");
    plans += "\n" + planOf(e, "dispersion-" + std::to_string(rung++), step.best, 30);
  }
  plans += "\n" + planOf(e, "dispersion-5", even.best, 30);
  e.report += "\nFrom the most uneven to the most even, as in figure 3:\n\n" + plans + "\n\n";
  e.comparison.push_back("| 5.1 min sigma: sd over 20 runs / mean | 0.0035 / 0.428 = 0.82 % | " +
                         number(100 * even.deviation / even.mean, 2) +
                         " % | local search on deltas, restarts |");
  e.comparison.push_back(
      "| 5.1 largest sigma / smallest | 3.51 / 0.425 = 8.3 | " + number(uneven.largest / even.least, 3) +
      " | another room and, here, exact light of small lamps instead of light spread over clusters |");
  e.comparison.push_back("| 5.1 time of 25 000 evaluations | 10 s | " + number(1e3 * even.seconds, 2) +
                         " ms | O(1) deltas on sums that are kept; compiled code |");
}

}  // namespace fiatlux
