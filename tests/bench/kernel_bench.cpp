// One batch of each kernel of the search, natively or as Wasm (the same file, the same flags): nanoseconds an
// evaluation at the paper's size, m = 258 sites, for N luminaires. Prints one JSON object; bench.mjs
// interleaves batches.
#include <algorithm>
#include <chrono>
#include <cstdio>
#include <vector>

#include "core/base/random.h"
#include "core/search/kernels.h"

namespace fiatlux {
namespace {

constexpr std::uint32_t kSites = 258, kLayouts = 512;
constexpr double kBatchSeconds = 0.1;
constexpr int kRepeats = 4;  // rounds between two looks at the clock

/// A symmetric matrix of the size of a surface's covariance, a mean row, and random layouts of n luminaires.
struct Problem {
  std::vector<double> mean, flux, row;
  std::vector<float> covariance, diagonal;
  std::vector<std::uint32_t> layouts;  // kLayouts x n
  std::uint32_t n;

  explicit Problem(std::uint32_t luminaires) : n(luminaires) {
    Random random(1);
    covariance.resize(kSites * kSites);
    for (std::uint32_t i = 0; i < kSites; ++i)
      for (std::uint32_t j = i; j < kSites; ++j)
        covariance[i * kSites + j] = covariance[j * kSites + i] = static_cast<float>(random.unit());
    for (std::uint32_t i = 0; i < kSites; ++i) {
      mean.push_back(random.unit());
      diagonal.push_back(covariance[i * kSites + i]);
    }
    flux.assign(n, 1000);
    for (std::uint32_t k = 0; k < kLayouts * n; ++k) layouts.push_back(random.below(kSites));
    row.resize(kSites);
  }
  const std::uint32_t* layout(std::uint32_t k) const { return layouts.data() + k * n; }
};

volatile double sink;

/// Nanoseconds an evaluation: the median of rounds (each makes `evaluations` of them), so that a machine that
/// does other things meanwhile disturbs little. The first third of the batch warms up.
template <class Round>
double nanoseconds(std::uint32_t evaluations, Round round) {
  using Clock = std::chrono::steady_clock;
  const auto seconds = [](Clock::time_point from) {
    return std::chrono::duration<double>(Clock::now() - from).count();
  };
  for (const auto begin = Clock::now(); seconds(begin) < kBatchSeconds / 2;) round();
  std::vector<double> rounds;
  for (const auto begin = Clock::now(); rounds.empty() || seconds(begin) < kBatchSeconds;) {
    const auto start = Clock::now();
    for (int k = 0; k < kRepeats; ++k) round();
    rounds.push_back(seconds(start));
  }
  std::nth_element(rounds.begin(), rounds.begin() + rounds.size() / 2, rounds.end());
  return rounds[rounds.size() / 2] * 1e9 / (static_cast<double>(kRepeats) * evaluations);
}

double fullMean(const Problem& p) {
  return nanoseconds(kLayouts, [&] {
    double sum = 0;
    for (std::uint32_t k = 0; k < kLayouts; ++k)
      sum += meanOf(p.mean.data(), p.layout(k), p.flux.data(), p.n);
    sink = sum;
  });
}

double fullSigma(const Problem& p) {
  return nanoseconds(kLayouts, [&] {
    double sum = 0;
    for (std::uint32_t k = 0; k < kLayouts; ++k)
      sum += varianceOf(p.covariance.data(), kSites, p.layout(k), p.flux.data(), p.n);
    sink = sum;
  });
}

/// One luminaire of a layout on each of 48 other sites, as the local search asks: mean and sigma^2 of each.
double deltaMove(Problem& p) {
  constexpr std::uint32_t kCandidates = 48;
  std::vector<double> means(kCandidates), variances(kCandidates);
  return nanoseconds(kLayouts * kCandidates, [&] {
    double sum = 0;
    for (std::uint32_t k = 0; k < kLayouts; ++k) {
      const std::uint32_t from = p.layout(k)[0], first = (k * 7) % (p.layouts.size() - kCandidates);
      const std::uint32_t* candidates = p.layouts.data() + first;
      movedMeans(p.mean.data(), 1, from, 1000, candidates, kCandidates, means.data());
      movedVariances(p.covariance.data(), p.diagonal.data(), kSites, p.row.data(), 1, from, 1000, candidates,
                     kCandidates, variances.data());
      sum += means[k % kCandidates] + variances[k % kCandidates];
    }
    sink = sum;
  });
}

}  // namespace
}  // namespace fiatlux

int main() {
  const char* comma = "{";
  for (std::uint32_t n : {1u, 6u, 12u, 24u}) {
    fiatlux::Problem problem(n);
    fiatlux::fillRow(problem.covariance.data(), fiatlux::kSites, problem.layout(0), problem.flux.data(), n,
                     problem.row.data());
    std::printf("%s\"mean_full_n%u\": %.3f, \"sigma_full_n%u\": %.3f, \"delta_move_n%u\": %.3f", comma, n,
                fiatlux::fullMean(problem), n, fiatlux::fullSigma(problem), n, fiatlux::deltaMove(problem));
    comma = ", ";
  }
  std::printf("}\n");
  return 0;
}
