// How work fails below the commands: inside a library by an exception, at its door as a Result of one
// readable line.
#pragma once

#include <new>
#include <stdexcept>
#include <string>
#include <type_traits>
#include <utility>

#include "core/base/result.h"
#include "precompute/base/progress.h"

namespace fiatlux {

/// Its line is for a person; a command that meets it prints it and ends with status 2.
struct CommandError : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// The door of a library: what `work` returns, or the line of the CommandError that it throws; `noMemory`
/// where there is too little, and "stopped" where its Progress said so.
template <class Work>
auto atDoor(const Work& work, const char* noMemory) -> Result<std::invoke_result_t<Work>> {
  try {
    return work();
  } catch (const CommandError& error) {
    return Error{error.what()};
  } catch (const Stopped& stopped) {
    return Error{stopped.what()};
  } catch (const std::bad_alloc&) {
    return Error{noMemory};
  }
}

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
