// The calling thread works too, and it alone reports progress.
#include "precompute/base/parallel.h"

#include <algorithm>
#include <atomic>
#include <exception>
#include <mutex>
#include <system_error>
#include <thread>
#include <vector>

namespace fiatlux {

unsigned threadCount(unsigned asked) {
  return asked > 0 ? asked : std::max(1u, std::thread::hardware_concurrency());
}

void parallelFor(std::size_t count, unsigned threads, const std::function<void(std::size_t)>& body,
                 const std::function<void(double)>& progress) {
  std::atomic<std::size_t> next{0};
  std::exception_ptr failure;
  std::mutex failureGuard;
  const auto work = [&](bool reports) {
    try {
      for (std::size_t i = next++; i < count; i = next++) {
        body(i);
        if (reports && progress)
          progress(static_cast<double>(std::min(next.load(), count)) / static_cast<double>(count));
      }
    } catch (...) {
      const std::lock_guard lock(failureGuard);
      if (!failure) failure = std::current_exception();
      next = count;
    }
  };
  std::vector<std::thread> others;
  const std::size_t used = std::min<std::size_t>(threadCount(threads), std::max<std::size_t>(count, 1));
  try {
    for (std::size_t i = 1; i < used; ++i) others.emplace_back(work, false);
  } catch (const std::system_error&) {
    // The machine has no more threads to give: those there are do it.
  }
  work(true);
  for (std::thread& thread : others) thread.join();
  if (failure) std::rethrow_exception(failure);
}

void parallelPortions(std::uint32_t count, std::uint32_t portion, unsigned threads,
                      const std::function<void(std::uint32_t, std::uint32_t)>& body,
                      const std::function<void(double)>& progress) {
  const auto doPortion = [&](std::size_t i) {
    const auto first = static_cast<std::uint32_t>(i) * portion;
    body(first, std::min(first + portion, count));
  };
  parallelFor((count + portion - 1) / portion, threads, doPortion, progress);
}

}  // namespace fiatlux
