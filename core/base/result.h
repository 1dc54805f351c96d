// Errors without exceptions: a Result holds either a value or one line for a person.
// The core is built with -fno-exceptions, natively and as Wasm; callers decide how a line is shown.
#pragma once

#include <cassert>
#include <string>
#include <utility>
#include <variant>

namespace fiatlux {

/// One readable line: what is wrong, where, and the cure. No trailing newline.
struct Error {
  std::string message;
};

/// A value or an Error. `value()` and `error()` require that the other is absent.
template <class T>
class [[nodiscard]] Result {
 public:
  Result(T value) : state_(std::move(value)) {}      // NOLINT: implicit, so that `return value;` reads well
  Result(Error error) : state_(std::move(error)) {}  // NOLINT
  explicit operator bool() const { return state_.index() == 0; }
  T& value() { return assert(*this), *std::get_if<0>(&state_); }
  const T& value() const { return assert(*this), *std::get_if<0>(&state_); }
  const Error& error() const { return assert(!*this), *std::get_if<1>(&state_); }
  T* operator->() { return &value(); }
  const T* operator->() const { return &value(); }
  T& operator*() { return value(); }
  const T& operator*() const { return value(); }

 private:
  std::variant<T, Error> state_;
};

/// The Result of a step that yields nothing.
struct Done {};

}  // namespace fiatlux
