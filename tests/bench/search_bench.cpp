// How good are the layouts that the search finds? Problems from standard input, one a line:
//   FAMILY COUNT EVALUATIONS SEEDS [SITE ...]     the sites of the best layout that is known, if any is
// and a JSON line each to standard output: what every seed found, and the best of it.
//   search_bench FILE FOCUS OTHER THIRD           surfaces by name, those of a set joined by "+"
// search-bench.mjs asks, compares and writes.
#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <iostream>
#include <sstream>

#include "core/search/layout_search.h"
#include "core/search/validate_intentions.h"
#include "tests/bench/search_problems.h"
#include "tests/wasm/open_file.h"

namespace fiatlux {
namespace {

SurfaceSet surfacesNamed(const Scene& scene, const std::string& names) {
  SurfaceSet set;
  std::istringstream rest(names);
  for (std::string name; std::getline(rest, name, '+');) {
    std::uint32_t s = 0;
    while (s < scene.surfaces.size() && scene.surfaces[s].name != name) ++s;
    if (s == scene.surfaces.size()) fail("no surface \"" + name + "\"");
    set.push_back(s);
  }
  std::sort(set.begin(), set.end());
  return set;
}

void print(const char* name, const std::vector<double>& values) {
  std::printf("\"%s\": [", name);
  for (std::size_t i = 0; i < values.size(); ++i) std::printf(i > 0 ? ", %.12g" : "%.12g", values[i]);
  std::printf("], ");
}

struct Best {
  std::vector<std::uint32_t> sites;
  Evaluation evaluation{kUnbounded, kUnbounded, 1};

  void offer(const std::vector<std::uint32_t>& other, const Evaluation& worth) {
    if (!isBetter(worth, evaluation)) return;
    sites = other;
    evaluation = worth;
  }
};

/// The best layout, its worth, what the first goal says in its own unit, and the size of all goals together.
void print(Evaluator& evaluator, std::size_t goals, const Best& best) {
  evaluator.load(best.sites);
  double scale = 0;
  for (std::size_t g = 0; g < goals; ++g)
    scale += std::fabs(evaluator.objective().goalFactor(g) * evaluator.goalValue(g));
  std::printf("\"goal\": %.12g, \"violation\": %.6g, \"value\": %.6g, \"scale\": %.12g, \"sites\": [",
              best.evaluation.goal, best.evaluation.violation, evaluator.goalValue(0), scale);
  for (std::size_t i = 0; i < best.sites.size(); ++i) std::printf(i > 0 ? ", %u" : "%u", best.sites[i]);
  std::printf("]}\n");
}

void answer(PreparedScene& prepared, const ProblemSurfaces& surfaces, std::istringstream line) {
  std::string family;
  std::uint32_t count = 0, evaluations = 0, seeds = 0;
  if (!(line >> family >> count >> evaluations >> seeds) || seeds == 0)
    fail("a line is FAMILY COUNT EVALUATIONS SEEDS");
  const std::optional<Intentions> asked = problemOf(prepared, surfaces, family, count);
  if (!asked) fail("no family \"" + family + "\"");
  requireDone(checkIntentions(prepared.scene(), *asked));
  Evaluator evaluator(prepared, *asked);
  Best best;
  std::vector<std::uint32_t> known;
  for (std::uint32_t site; line >> site;) known.push_back(site);
  if (!known.empty()) best.offer(known, evaluator.evaluate(known));
  std::vector<double> goals, violations, milliseconds;
  for (std::uint32_t seed = 1; seed <= seeds; ++seed) {
    const auto begin = std::chrono::steady_clock::now();
    LayoutSearch search(prepared, *asked, seed);
    search.advance(evaluations);
    const std::chrono::duration<double, std::milli> spent = std::chrono::steady_clock::now() - begin;
    milliseconds.push_back(spent.count());
    goals.push_back(search.evaluation().goal);
    violations.push_back(search.evaluation().violation);
    best.offer(search.incumbent().sites, search.evaluation());
  }
  std::nth_element(milliseconds.begin(), milliseconds.begin() + seeds / 2, milliseconds.end());
  std::printf("{\"family\": \"%s\", \"count\": %u, \"evaluations\": %u, \"milliseconds\": %.4g, ",
              family.c_str(), count, evaluations, milliseconds[seeds / 2]);
  print("goals", goals);
  print("violations", violations);
  print(evaluator, asked->goals.size(), best);
  std::fflush(stdout);
}

}  // namespace
}  // namespace fiatlux

int main(int count, char** arguments) {
  using namespace fiatlux;
  if (count != 5) fail("usage: search_bench FILE FOCUS OTHER THIRD");
  Session session;
  openFile(session, arguments[1]);
  const Scene& scene = *session.scene();
  PreparedScene prepared(scene);
  const ProblemSurfaces surfaces{surfacesNamed(scene, arguments[2]), surfacesNamed(scene, arguments[3]),
                                 surfacesNamed(scene, arguments[4])};
  for (std::string line; std::getline(std::cin, line);) answer(prepared, surfaces, std::istringstream(line));
  return 0;
}
