// A binary range coder with adaptive probabilities (Martin 1979, with carries let through as they come): each
// bit takes as much of a file as it is surprising. Whole numbers only, so that every machine reads the same.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

namespace fiatlux {

/// How likely a bit is to be 0, learnt as bits pass: the mean of a quick and a slow estimate.
class AdaptiveBit {
 public:
  /// In 1..2^15 - 1, of 2^15.
  std::uint32_t zero() const { return (std::uint32_t{quick_} + slow_) >> 2; }
  void learn(bool bit) {
    constexpr int kQuick = 4, kSlow = 7;
    quick_ = static_cast<std::uint16_t>(bit ? quick_ - (quick_ >> kQuick)
                                            : quick_ + ((kWhole - quick_) >> kQuick));
    slow_ = static_cast<std::uint16_t>(bit ? slow_ - (slow_ >> kSlow) : slow_ + ((kWhole - slow_) >> kSlow));
  }

 private:
  static constexpr std::uint32_t kWhole = 0xffff;
  std::uint16_t quick_ = 0x8000, slow_ = 0x8000;
};

inline constexpr std::uint32_t kSmallestRange = 1u << 24;

class RangeEncoder {
 public:
  /// Writes `value`; yields it, as the decoder does.
  bool bit(AdaptiveBit& model, bool value) {
    const std::uint32_t bound = (range_ >> 15) * model.zero();
    if (value)
      low_ += bound, range_ -= bound;
    else
      range_ = bound;
    model.learn(value);
    while (range_ < kSmallestRange) shift();
    return value;
  }
  /// Writes the lowest `count` bits of `value`, each as likely 0 as 1.
  std::uint32_t bits(int count, std::uint32_t value) {
    while (count-- > 0) {
      range_ >>= 1;
      if (value >> count & 1) low_ += range_;
      while (range_ < kSmallestRange) shift();
    }
    return value;
  }
  /// The bytes written; the encoder is as new afterwards.
  std::vector<std::uint8_t> finish() {
    for (int i = 0; i < 5; ++i) shift();
    std::vector<std::uint8_t> bytes = std::move(bytes_);
    *this = {};
    return bytes;
  }

 private:
  /// Moves the top byte out. One that a carry may still raise waits, with the 255s behind it.
  void shift() {
    if (low_ < 0xff000000u || low_ > 0xffffffffu) {
      const auto carry = static_cast<std::uint8_t>(low_ >> 32);
      if (begun_) bytes_.push_back(static_cast<std::uint8_t>(waiting_ + carry));
      for (; waitingFull_ > 0; --waitingFull_) bytes_.push_back(static_cast<std::uint8_t>(0xff + carry));
      waiting_ = static_cast<std::uint8_t>(low_ >> 24);
      begun_ = true;
    } else {
      ++waitingFull_;
    }
    low_ = (low_ & 0x00ffffffu) << 8;
    range_ <<= 8;
  }

  std::uint64_t low_ = 0;
  std::uint32_t range_ = 0xffffffffu;
  std::uint8_t waiting_ = 0;
  bool begun_ = false;
  std::size_t waitingFull_ = 0;
  std::vector<std::uint8_t> bytes_;
};

/// Refers to the bytes. Past their end it reads zeros; ended() tells.
class RangeDecoder {
 public:
  explicit RangeDecoder(std::span<const std::uint8_t> bytes)
      : at_(bytes.data()), end_(bytes.data() + bytes.size()) {
    for (int i = 0; i < 4; ++i) code_ = code_ << 8 | next();
  }
  /// The next bit; the argument is the encoder's.
  bool bit(AdaptiveBit& model, bool = false) {
    const std::uint32_t bound = (range_ >> 15) * model.zero();
    const bool value = code_ >= bound;
    if (value)
      code_ -= bound, range_ -= bound;
    else
      range_ = bound;
    model.learn(value);
    while (range_ < kSmallestRange) range_ <<= 8, code_ = code_ << 8 | next();
    return value;
  }
  std::uint32_t bits(int count, std::uint32_t = 0) {
    std::uint32_t value = 0;
    while (count-- > 0) {
      range_ >>= 1;
      const bool one = code_ >= range_;
      if (one) code_ -= range_;
      value = value << 1 | static_cast<std::uint32_t>(one);
      while (range_ < kSmallestRange) range_ <<= 8, code_ = code_ << 8 | next();
    }
    return value;
  }
  /// Whether it was asked for more bytes than there are.
  bool ranOut() const { return missing_ > 0; }
  /// Every byte was needed, or is a zero that fills up; and none was missing.
  bool ended() const {
    if (ranOut()) return false;
    for (const std::uint8_t* byte = at_; byte < end_; ++byte)
      if (*byte != 0) return false;
    return true;
  }

 private:
  std::uint32_t next() { return at_ < end_ ? *at_++ : (++missing_, 0u); }

  const std::uint8_t *at_, *end_;
  std::size_t missing_ = 0;
  std::uint32_t range_ = 0xffffffffu, code_ = 0;
};

}  // namespace fiatlux
