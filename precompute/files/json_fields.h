// The one strict reader of JSON that a person wrote: every key known, every type and range right, or one line
// that says what is wrong, where, and on which line. Used while readJson runs; its faults never leave it.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <limits>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "core/base/result.h"
#include "core/base/vec3.h"

namespace fiatlux {

inline constexpr std::size_t kLongestJson = 2 << 20;  // bytes of a layout or of intentions
inline constexpr double kAnyNumber = std::numeric_limits<double>::max();
inline constexpr double kLeastFlux = 1e-6, kLargestFlux = 1e9;  // lm, of a photometric file that is scaled
inline constexpr double kMostTurn = 3600;                       // degrees
inline constexpr double kMostAimingAngle = 180;                 // degrees

/// A value somewhere in a document. What it is asked for and cannot give ends the reading.
class JsonField {
 public:
  bool has(const std::string& key) const;
  /// A member that must be there; `cure` says what to write: `no "flux"; <cure>`.
  JsonField at(const std::string& key, const std::string& cure) const;
  /// A member that may be there.
  std::optional<JsonField> find(const std::string& key) const;
  /// Requires an object with no keys but these.
  void requireKeys(const std::vector<std::string>& known) const;

  bool isList() const;
  bool isText() const;
  double number(double low = -kAnyNumber, double high = kAnyNumber) const;
  /// A whole number from 0 on, of 32 bits.
  std::uint32_t whole() const;
  std::string text() const;
  /// Exactly `count` numbers; `form` is how one writes them: "[x, y, z]".
  std::vector<double> numbers(std::size_t count, const std::string& form, double low = -kAnyNumber,
                              double high = kAnyNumber) const;
  /// Entries are called <name of the list>[0], or "<entry> 1" where an own name is given.
  std::vector<JsonField> list(std::size_t most, const std::string& entry = "") const;

  /// What goes with the text of this value.
  template <class T>
  T oneOf(const std::vector<std::pair<std::string, T>>& choices) const {
    std::vector<std::string> names;
    for (const auto& choice : choices) names.push_back(choice.first);
    return choices[indexAmong(names)].second;
  }

  /// Ends the reading with this word on the value.
  [[noreturn]] void fail(const std::string& what) const;

 private:
  friend Result<Done> readJson(const std::string&, const std::function<void(const JsonField&)>&);
  JsonField(const nlohmann::json& json, std::string name, std::vector<std::string> path)
      : json_(&json), name_(std::move(name)), path_(std::move(path)) {}

  JsonField member(const nlohmann::json& json, std::string name, std::string step) const;
  std::size_t indexAmong(const std::vector<std::string>& names) const;
  [[noreturn]] void failAsType(const std::string& expected) const;

  const nlohmann::json* json_;
  std::string name_;               // for people: "goal 1.surface"
  std::vector<std::string> path_;  // for jsonLineOf
};

/// [x, y, z] in m, within 1000 km of the origin.
Vec3 vectorOf(const JsonField& field);
/// The same of any length but 0, made a unit one.
Vec3 directionOf(const JsonField& field);

/// Hands the document in `text`, at most kLongestJson long, to `read`, and turns its fault into an error.
Result<Done> readJson(const std::string& text, const std::function<void(const JsonField&)>& read);

}  // namespace fiatlux
