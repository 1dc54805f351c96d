// How a command fails: one readable line on standard error, status 2.
#pragma once

#include <stdexcept>
#include <string>
#include <utility>

#include "core/result.h"

namespace fiatlux {

struct CommandError : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// The value, or a CommandError with the Result's line.
template <class T>
T orThrow(Result<T> result) {
  if (!result) throw CommandError(result.error().message);
  return std::move(result.value());
}

}  // namespace fiatlux
