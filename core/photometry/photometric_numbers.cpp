#include "core/photometry/photometric_numbers.h"

#include <algorithm>
#include <cmath>

#include "core/photometry/photometry.h"

namespace fiatlux {
namespace {

constexpr double kLeastStep = 1e-4;  // degrees between two angles

/// Does `token` end with `unit`, letters in capitals or not?
bool endsWith(std::string_view token, std::string_view unit) {
  return token.size() > unit.size() && std::equal(unit.rbegin(), unit.rend(), token.rbegin(),
                                                  [](char a, char b) { return (a | 0x20) == (b | 0x20); });
}

}  // namespace

double NumberReader::next(const char* what) {
  if (failure_) return 0;
  const std::optional<std::string_view> token = take();
  if (!token) return failAtEnd(what), 0;
  const std::optional<double> value = numberOf(*token);
  if (!value)
    fail(quoted(*token) + " stands where " + what +
         " should, and is no number; is something missing before it?");
  return value.value_or(0);
}

double NumberReader::within(const char* what, double least, double most) {
  const double value = next(what);
  if (!failure_ && !(value >= least && value <= most))
    fail(std::string(what) + " is " + shortNumber(value) + ", but must lie within " + shortNumber(least) +
         " and " + shortNumber(most) + "; correct it or export the file again");
  return failure_ ? least : value;
}

std::size_t NumberReader::count(const char* what, std::size_t least, std::size_t most) {
  const double value = next(what);
  if (!failure_ && !(value >= static_cast<double>(least) && value <= static_cast<double>(most) &&
                     value == std::floor(value)))
    fail(std::string(what) + " is " + shortNumber(value) + ", but must be a whole number from " +
         std::to_string(least) + " to " + std::to_string(most) + "; is something missing before it?");
  return failure_ ? least : static_cast<std::size_t>(value);
}

void NumberReader::fail(const std::string& what) {
  if (!failure_) failure_ = errorAt(line_, what);
}

void NumberReader::failAtEnd(const char* what) {
  line_ = std::max<std::size_t>(1, lines_.size());
  fail(std::string("the file ends where ") + what +
       " should stand; it was cut short or a line is missing, fetch it again");
}

bool StreamReader::parts(char c) const {
  return c == ' ' || c == '\t' || c == '\f' || c == '\v' || (c == ',' && comma_ == Comma::kParts);
}

std::string_view StreamReader::peek() {
  for (; next_ < lines_.size(); ++next_, at_ = 0) {
    const std::string_view line = lines_[next_];
    while (at_ < line.size() && parts(line[at_])) ++at_;
    if (at_ == line.size()) continue;
    std::size_t end = at_;
    while (end < line.size() && !parts(line[end])) ++end;
    return line.substr(at_, end - at_);
  }
  return {};
}

std::optional<std::string_view> StreamReader::take() {
  const std::string_view token = peek();
  if (token.empty()) return {};
  line_ = next_ + 1;
  at_ += token.size();
  return token;
}

std::optional<double> StreamReader::numberOf(std::string_view token) const {
  return comma_ == Comma::kParts ? fiatlux::numberOf(token) : numberOfLine(token);
}

bool StreamReader::numberFollows() { return numberOf(peek()).has_value(); }

std::optional<std::string_view> LineReader::take() {
  if (next_ >= lines_.size()) return {};
  line_ = next_ + 1;
  return lines_[next_++];
}

std::optional<double> LineReader::numberOf(std::string_view token) const {
  token = trimmed(token);
  return numberOfLine(endsWith(token, unit_) ? token.substr(0, token.size() - unit_.size()) : token);
}

bool LineReader::numberFollows() { return next_ < lines_.size() && numberOf(lines_[next_]); }

std::string_view LineReader::text(const char* what) {
  if (failure()) return {};
  const std::optional<std::string_view> line = take();
  if (!line) failAtEnd(what);
  return line.value_or(std::string_view());
}

double LineReader::blankOrWithin(const char* what, double least, double most, std::string_view unit) {
  if (!failure() && next_ < lines_.size() && trimmed(lines_[next_]).empty()) return take(), 0;
  unit_ = unit;
  const double value = within(what, least, most);
  unit_ = {};
  return value;
}

std::vector<double> readAngles(NumberReader& reader, std::size_t count, const char* what, double least,
                               double most) {
  std::vector<double> angles;
  for (std::size_t i = 0; i < count && !reader.failure(); ++i) {
    const double angle = reader.within(what, least, most);
    if (i > 0 && angle < angles.back() + kLeastStep)
      reader.fail(std::string(what) + " of " + shortNumber(angle) + " follows " + shortNumber(angles.back()) +
                  ": they must ascend; does the number of angles agree with the list?");
    angles.push_back(angle);
  }
  return angles;
}

std::vector<double> readCandela(NumberReader& reader, std::size_t count, double factor) {
  std::vector<double> candela;
  for (std::size_t i = 0; i < count && !reader.failure(); ++i) {
    const double value = factor * reader.next("an intensity");
    if (value < 0) reader.fail(shortNumber(value) + " cd: intensities cannot be negative; correct the value");
    if (!(value <= kMaxCandela))
      reader.fail(shortNumber(value) +
                  " cd is more than 1e7; correct the value, the multiplier or the lamps' flux");
    candela.push_back(value);
  }
  return candela;
}

}  // namespace fiatlux
