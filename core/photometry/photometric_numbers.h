// The numbers of a photometric file, one after the other, each checked where it is read. LM-63 writes them as
// a stream, EULUMDAT one a line; the rest is the same for both.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/photometry/photometric_text.h"

namespace fiatlux {

// Beyond these a number is a fault of the file, not a luminaire.
inline constexpr double kMaxLumens = 1e9, kMaxWatts = 1e7, kMaxFactor = 1e6;

/// The first failure is kept; after it every call returns 0, or the least that was allowed.
class NumberReader {
 public:
  virtual ~NumberReader() = default;
  /// The next number; `what` is named if there is none ("the input watts").
  double next(const char* what);
  /// The next number, which must lie within [least, most].
  double within(const char* what, double least, double most);
  /// The next number, which must be whole and within [least, most]; "3.0" is whole.
  std::size_t count(const char* what, std::size_t least, std::size_t most);
  /// Keeps `what` as the failure, at the line read last, unless there is one already.
  void fail(const std::string& what);
  const std::optional<Error>& failure() const { return failure_; }
  /// The line read last, from 1.
  std::size_t line() const { return line_; }
  /// Does a number follow?
  virtual bool numberFollows() = 0;

 protected:
  explicit NumberReader(const PhotometricText& text) : lines_(text.lines) {}
  /// Takes the text of the next number and sets line_; none at the end of the file.
  virtual std::optional<std::string_view> take() = 0;
  virtual std::optional<double> numberOf(std::string_view token) const = 0;
  void failAtEnd(const char* what);

  const std::vector<std::string>& lines_;
  std::size_t line_ = 1;

 private:
  std::optional<Error> failure_;
};

/// What a comma stands for in a stream of numbers.
enum class Comma : std::uint8_t { kParts, kIsDecimal };

/// Numbers parted by blanks and line ends, and by commas where these are not decimal.
class StreamReader : public NumberReader {
 public:
  /// Starts at the beginning of line `line` (from 1).
  StreamReader(const PhotometricText& text, std::size_t line, Comma comma = Comma::kParts)
      : NumberReader(text), comma_(comma), next_(line - 1) {}
  bool numberFollows() override;

 protected:
  std::optional<std::string_view> take() override;
  std::optional<double> numberOf(std::string_view token) const override;

 private:
  std::string_view peek();
  bool parts(char c) const;
  Comma comma_;
  std::size_t next_, at_ = 0;  // index of the line being read, place in it
};

/// One value a line; numbers may have a decimal comma.
class LineReader : public NumberReader {
 public:
  explicit LineReader(const PhotometricText& text) : NumberReader(text) {}
  /// The next line as it stands.
  std::string_view text(const char* what);
  /// As `within`; a blank line is 0, and a unit ("W", in capitals or not) may follow the number.
  double blankOrWithin(const char* what, double least, double most, std::string_view unit = {});
  bool numberFollows() override;

 protected:
  std::optional<std::string_view> take() override;
  std::optional<double> numberOf(std::string_view token) const override;

 private:
  std::size_t next_ = 0;
  std::string_view unit_;  // what may follow the number that is being read
};

/// `count` ascending angles within [least, most] degrees, at least 1e-4 apart.
std::vector<double> readAngles(NumberReader& reader, std::size_t count, const char* what, double least,
                               double most);

/// `count` intensities times `factor`, each within [0, kMaxCandela].
std::vector<double> readCandela(NumberReader& reader, std::size_t count, double factor);

}  // namespace fiatlux
