// The native half of solve_25000: milliseconds of 25 000 evaluations on a .flux file, N = 6, even light
// everywhere, the median of 40 seeds. bench.mjs asks the same of the Wasm module.
//   solve_bench FILE
#include <algorithm>
#include <chrono>
#include <cstdio>

#include "tests/wasm/open_file.h"

int main(int count, char** arguments) {
  using namespace fiatlux;
  if (count != 2) fail("usage: solve_bench FILE");
  Session session;
  openFile(session, arguments[1]);
  Intentions intentions;
  intentions.luminaires.count = 6;
  intentions.goals = {{Statistic::kSigma, Sense::kMinimize, 1, {}, {}}};
  requireDone(session.setIntentions(intentions));
  std::vector<double> milliseconds;
  for (std::uint32_t seed = 1; seed <= 40; ++seed) {
    const auto begin = std::chrono::steady_clock::now();
    requireDone(session.start(seed, nullptr));
    session.advance(25000);
    const std::chrono::duration<double, std::milli> spent = std::chrono::steady_clock::now() - begin;
    milliseconds.push_back(spent.count());
  }
  std::nth_element(milliseconds.begin(), milliseconds.begin() + 20, milliseconds.end());
  std::printf("%.4f\n", milliseconds[20]);
  return 0;
}
