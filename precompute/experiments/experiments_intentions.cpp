// Section 5.2: illuminate, overshadow, homogenize and vary the yellow wall; and the same with three
// luminaires against the optimum of every possible layout.
#include <cmath>

#include "core/search/evaluator.h"
#include "precompute/experiments/experiments.h"

namespace fiatlux {
namespace {

constexpr double kLower = 0.30 / 0.42,
                 kUpper = 0.35 / 0.42;  // the paper's bounds as shares of its brightest mean

struct Verb {
  const char* name;
  Statistic statistic;
  Sense sense;
  bool bounded;
  const char* paper;  // min, max, mean, sd
};
constexpr Verb kVerbs[4] = {
    {"illuminate", Statistic::kMean, Sense::kMaximize, false, "0.409, 0.426, 0.420, 1.1 %"},
    {"overshadow", Statistic::kMean, Sense::kMinimize, false, "7.20e-4, 7.64e-4, 7.30e-4, 2.0 %"},
    {"homogenize", Statistic::kSigma, Sense::kMinimize, true, "0.066, 0.072, 0.068, 2.8 %"},
    {"vary", Statistic::kSigma, Sense::kMaximize, true, "0.159, 0.175, 0.165, 2.7 %"}};

Intentions verbProblem(const Experiments& e, const Verb& verb, std::uint32_t count, double brightest) {
  Intentions problem = problemOf(e, count, verb.statistic, verb.sense, e.wall);
  if (verb.bounded)
    problem.constraints = {{Statistic::kMean, kLower * brightest, kUpper * brightest, 1, e.wall, {}}};
  return problem;
}

/// The best of all layouts of three luminaires.
Evaluation exhaustive(Experiments& e, const Intentions& problem) {
  Evaluator evaluator(e.prepared, problem);
  Evaluation best{kUnbounded, 0, 1};
  std::vector<std::uint32_t> sites(3);
  const std::uint32_t m = e.prepared.candidateCount();
  for (sites[0] = 0; sites[0] < m; ++sites[0])
    for (sites[1] = sites[0] + 1; sites[1] < m; ++sites[1])
      for (sites[2] = sites[1] + 1; sites[2] < m; ++sites[2])
        if (const Evaluation evaluation = evaluator.evaluate(sites); isBetter(evaluation, best))
          best = evaluation;
  return best;
}

void enumerateThree(Experiments& e) {
  const std::uint64_t m = e.prepared.candidateCount();
  if (m < 4 || m > 400) return;  // above, the enumeration takes minutes
  e.report += "### Three luminaires, against all " + std::to_string(m * (m - 1) * (m - 2) / 6) +
              " layouts\n\n| verb | seeds that found the optimum of the enumeration |\n|---|---|\n";
  double brightest = 0;
  for (const Verb& verb : kVerbs) {
    const Intentions problem = verbProblem(e, verb, 3, brightest);
    const Evaluation optimum = exhaustive(e, problem);
    std::uint32_t hits = 0;
    for (std::uint64_t seed = 1; seed <= e.runs; ++seed) {
      Vns vns(e.prepared, problem, seed);
      vns.advance(e.evaluations);
      hits += !isBetter(optimum, vns.evaluation()) ||
              std::fabs(optimum.goal - vns.evaluation().goal) <= 1e-7 * std::fabs(optimum.goal);
      if (verb.statistic != Statistic::kMean || verb.sense != Sense::kMaximize) continue;
      Evaluator evaluator(e.prepared, problem);
      evaluator.load(vns.incumbent().sites);
      brightest = std::max(brightest, evaluator.goalValue(0));
    }
    e.report += std::string("| ") + verb.name + " | " + std::to_string(hits) + " of " +
                std::to_string(e.runs) + " |\n";
    e.comparison.push_back(std::string("| 5.2 ") + verb.name +
                           ", 3 luminaires: optimum of the enumeration found | - | " + std::to_string(hits) +
                           " of " + std::to_string(e.runs) + " | |");
  }
  e.report += "\n";
}

}  // namespace

void experimentIntentions(Experiments& e) {
  e.report +=
      "## 5.2 Four verbs on the yellow wall\n\nSix luminaires. Homogenize and vary keep the mean within " +
      number(kLower, 3) + " to " + number(kUpper, 3) +
      " of the brightest mean, the same shares as in the paper.\n\n"
      "| verb | least | largest | mean | sd / mean | time a run | best run | paper (least, largest, mean, sd "
      "/ mean) |\n"
      "|---|---|---|---|---|---|---|---|\n";
  std::string plans;
  for (const Verb& verb : kVerbs) {
    const Intentions problem = verbProblem(e, verb, 6, e.brightestWall);
    const RunSummary s = repeat(e, std::string("5.2 ") + verb.name, problem);
    if (e.brightestWall == 0) e.brightestWall = s.largest;
    e.report += std::string("| ") + verb.name + " | " + number(s.least) + " | " + number(s.largest) + " | " +
                number(s.mean) + " | " + number(100 * s.deviation / s.mean, 2) + " % | " +
                number(1e3 * s.seconds, 3) + " ms | " + provedText(e, problem, s.bestEvaluation) + " | " +
                verb.paper + " |\n";
    plans += planOf(e, std::string("verb-") + verb.name, s.best, 30) + "\n";
  }
  e.report += "\n" + plans + "\n";
  enumerateThree(e);
}

}  // namespace fiatlux
