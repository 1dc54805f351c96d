// Checks of JSON values; see json_fields.h.
#include "precompute/files/json_fields.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>

#include "core/base/short_number.h"
#include "precompute/base/json_text.h"
#include "precompute/base/names.h"
#include "precompute/base/repeated_key.h"
#include "precompute/files/terminal.h"

namespace fiatlux {
namespace {

constexpr std::size_t kLongestFault = 800, kLongestQuote = 60, kLongestValue = 40;  // characters
constexpr int kDigits = 10;                                                         // of the ends of a range

struct JsonFault {
  std::string message;
  std::vector<std::string> path;
};

const char* typeOf(const nlohmann::json& value) {
  return value.is_number()   ? "a number"
         : value.is_string() ? "a text"
         : value.is_array()  ? "a list"
         : value.is_object() ? "an object"
         : value.is_null()   ? "null"
                             : "true or false";
}

/// unknown key "cuont"; the closest is "count" (known are count, flux)
std::string unknownWord(const std::string& kind, const std::string& word,
                        const std::vector<std::string>& known) {
  std::string all;
  for (const std::string& name : known) all += (all.empty() ? "" : ", ") + name;
  return "unknown " + kind + "\"" + printable(word, kLongestQuote) + "\"; the closest is " +
         closestNames(word, known, '"', 1) + " (known are " + all + ")";
}

}  // namespace

void JsonField::fail(const std::string& what) const {
  throw JsonFault{name_.empty() ? what : name_ + ": " + what, path_};
}

void JsonField::failAsType(const std::string& expected) const {
  fail("expected " + expected + ", found " + typeOf(*json_));
}

JsonField JsonField::member(const nlohmann::json& json, std::string name, std::string step) const {
  std::vector<std::string> path = path_;
  path.push_back(std::move(step));
  return {json, std::move(name), std::move(path)};
}

bool JsonField::has(const std::string& key) const { return json_->contains(key); }

std::optional<JsonField> JsonField::find(const std::string& key) const {
  if (!has(key)) return std::nullopt;
  return member((*json_)[key], name_.empty() ? key : name_ + "." + key, key);
}

JsonField JsonField::at(const std::string& key, const std::string& cure) const {
  if (!has(key)) fail("no \"" + key + "\"; " + cure);
  return *find(key);
}

void JsonField::requireKeys(const std::vector<std::string>& known) const {
  if (!json_->is_object()) failAsType("an object");
  for (const auto& item : json_->items())
    if (std::find(known.begin(), known.end(), item.key()) == known.end())
      fail(unknownWord("key ", item.key(), known));
}

bool JsonField::isList() const { return json_->is_array(); }
bool JsonField::isText() const { return json_->is_string(); }

double JsonField::number(double low, double high) const {
  if (!json_->is_number()) failAsType("a number");
  const double number = json_->get<double>();
  if (!(number >= low && number <= high))
    fail(printable(jsonText(*json_), kLongestValue) + " is out of range; give " + shortNumber(low, kDigits) +
         " to " + shortNumber(high, kDigits));
  return number;
}

std::uint32_t JsonField::whole() const {
  const double value = number();
  if (value < 0 || value > std::numeric_limits<std::uint32_t>::max() || value != std::floor(value))
    fail("expected a whole number from 0 on, found " + printable(jsonText(*json_), kLongestValue));
  return static_cast<std::uint32_t>(value);
}

std::string JsonField::text() const {
  if (!json_->is_string()) failAsType("a text");
  return json_->get<std::string>();
}

std::vector<double> JsonField::numbers(std::size_t count, const std::string& form, double low,
                                       double high) const {
  if (!json_->is_array()) failAsType(form);
  if (json_->size() != count)
    fail("expected " + form + ", found " + std::to_string(json_->size()) + " entries");
  std::vector<double> numbers;
  for (const JsonField& entry : list(count)) numbers.push_back(entry.number(low, high));
  return numbers;
}

std::vector<JsonField> JsonField::list(std::size_t most, const std::string& entry) const {
  if (!json_->is_array()) failAsType("a list");
  if (json_->size() > most) fail("more than " + std::to_string(most) + " entries");
  std::vector<JsonField> entries;
  for (std::size_t i = 0; i < json_->size(); ++i) {
    const std::string name =
        entry.empty() ? name_ + "[" + std::to_string(i) + "]" : entry + " " + std::to_string(i + 1);
    entries.push_back(member((*json_)[i], name, std::to_string(i)));
  }
  return entries;
}

std::size_t JsonField::indexAmong(const std::vector<std::string>& names) const {
  const std::string word = text();
  const auto found = std::find(names.begin(), names.end(), word);
  if (found == names.end()) fail(unknownWord("", word, names));
  return static_cast<std::size_t>(found - names.begin());
}

Vec3 vectorOf(const JsonField& field) {
  constexpr double kLargestDistance = 1e6;  // m
  const std::vector<double> v = field.numbers(3, "[x, y, z]", -kLargestDistance, kLargestDistance);
  return {v[0], v[1], v[2]};
}

Vec3 directionOf(const JsonField& field) {
  const Vec3 direction = vectorOf(field);
  if (length(direction) < 1e-9) field.fail("a direction must not be zero");
  return normalized(direction);
}

Result<Done> readJson(const std::string& text, const std::function<void(const JsonField&)>& read) {
  if (text.size() > kLongestJson) return Error{"longer than " + std::to_string(kLongestJson >> 20) + " MB"};
  const Result<nlohmann::json> json = parseJson(text);
  if (!json) return json.error();
  if (const auto twice = repeatedKey(text))
    return Error{"key \"" + printable(twice->key, kLongestQuote) +
                 "\" stands twice in one object; leave one out (line " + std::to_string(twice->line) + ")"};
  try {
    read(JsonField(*json, "", {}));
    return Done{};
  } catch (const JsonFault& fault) {
    return Error{printable(fault.message, kLongestFault) + " (line " +
                 std::to_string(jsonLineOf(text, fault.path)) + ")"};
  }
}

}  // namespace fiatlux
