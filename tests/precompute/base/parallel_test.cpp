// Every index once, whatever the number of threads, asked for or to be had.
#include "precompute/base/parallel.h"

#include <gtest/gtest.h>
#include <sys/resource.h>

#include <atomic>
#include <fstream>
#include <stdexcept>
#include <vector>

namespace fiatlux {
namespace {

/// Whether each of 1000 indices comes exactly once.
bool eachComesOnce(unsigned threads) {
  std::vector<std::atomic<int>> times(1000);
  parallelFor(times.size(), threads, [&](std::size_t i) { ++times[i]; });
  for (const std::atomic<int>& count : times)
    if (count != 1) return false;
  return true;
}

TEST(Parallel, EachIndexComesOnce) {
  for (const unsigned threads : {0u, 1u, 7u}) EXPECT_TRUE(eachComesOnce(threads));
}

TEST(Parallel, PortionsAreNextToEachOtherAndTheLastIsShorter) {
  for (const unsigned threads : {1u, 7u}) {
    std::vector<int> times(1000);
    parallelPortions(1000, 64, threads, [&](std::uint32_t first, std::uint32_t end) {
      EXPECT_EQ(end - first, first == 960 ? 40u : 64u);
      for (std::uint32_t i = first; i < end; ++i) ++times[i];
    });
    EXPECT_EQ(times, std::vector<int>(1000, 1));
  }
}

TEST(Parallel, AFailureOfABodyComesBack) {
  const auto failing = [](std::size_t i) {
    if (i == 500) throw std::runtime_error("five hundred");
  };
  EXPECT_THROW(parallelFor(1000, 4, failing), std::runtime_error);
}

#if GTEST_HAS_DEATH_TEST  // processes to limit are only native
/// Leaves this process room for the stacks of a few threads more.
void limitMemory() {
  std::size_t pages = 0;
  std::ifstream("/proc/self/statm") >> pages;
  const rlimit limit{pages * 4096 + (64u << 20), RLIM_INFINITY};
  ::setrlimit(RLIMIT_AS, &limit);
}

TEST(ParallelDeathTest, FewerThreadsThanAskedForDoItToo) {
#ifdef __SANITIZE_ADDRESS__
  GTEST_SKIP() << "the sanitizer's shadow does not fit under a limit of memory";
#endif
  EXPECT_EXIT(limitMemory(); std::_Exit(eachComesOnce(1000) ? 0 : 1), ::testing::ExitedWithCode(0), "");
}
#endif

}  // namespace
}  // namespace fiatlux
