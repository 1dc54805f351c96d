// Loops over independent pieces on several threads. Pieces are handed out as threads become free, so a result
// must depend on its index alone: then it is the same for any number of threads.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>

namespace fiatlux {

/// 0 becomes the machine's number of cores.
unsigned threadCount(unsigned asked);

/// Calls body(index) once for each index in [0, count). `progress`, if any, is called on the calling thread
/// with the share done so far. An exception of a body stops the loop and is thrown again here.
void parallelFor(std::size_t count, unsigned threads, const std::function<void(std::size_t)>& body,
                 const std::function<void(double)>& progress = {});

/// The same in portions of indices next to each other: body(first, end).
void parallelPortions(std::uint32_t count, std::uint32_t portion, unsigned threads,
                      const std::function<void(std::uint32_t, std::uint32_t)>& body,
                      const std::function<void(double)>& progress = {});

}  // namespace fiatlux
