// How a command fails: one readable line on standard error, status 2.
#pragma once

#include <stdexcept>
#include <string>
#include <utility>

#include "core/base/result.h"

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

/// The same of what was read from a file or made of it: the line names the file once, whoever found the
/// fault.
template <class T>
T orThrow(const std::string& path, Result<T> result) {
  if (!result && result.error().message.rfind(path, 0) != 0)
    throw CommandError(path + ": " + result.error().message);
  return orThrow(std::move(result));
}

}  // namespace fiatlux
