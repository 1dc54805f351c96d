// The places of brackets, keys and values in JSON text, of which a parsed document no longer knows.
#pragma once

#include <algorithm>
#include <cstddef>
#include <string>
#include <string_view>

namespace fiatlux {

/// Steps over JSON without building anything. Of text that is no JSON it only finds some end.
class JsonWalk {
 public:
  explicit JsonWalk(std::string_view text) : text_(text) {}

  std::size_t at() const { return at_; }
  bool done() const { return at_ >= text_.size(); }

  void skipBlanks() {
    while (!done() && std::string_view(" \t\r\n").find(text_[at_]) != std::string_view::npos) ++at_;
  }

  /// From one quote to behind the other; what is between them, escapes as written.
  std::string_view skipText() {
    const std::size_t begin = ++at_;
    while (!done() && text_[at_] != '"') at_ += text_[at_] == '\\' ? 2 : 1;
    const std::string_view inside = text_.substr(begin, std::min(at_, text_.size()) - begin);
    ++at_;
    return inside;
  }

  /// One bracket, text or other character; how much deeper the next one is.
  int skipToken() {
    const char c = text_[at_];
    if (c == '"') return skipText(), 0;
    ++at_;
    return c == '{' || c == '[' ? 1 : c == '}' || c == ']' ? -1 : 0;
  }

  /// To the comma or bracket behind the value that begins here.
  void skipValue() {
    for (int depth = 0; !done(); depth += skipToken())
      if (depth == 0 && (text_[at_] == ',' || text_[at_] == '}' || text_[at_] == ']')) return;
  }

  /// From the beginning of an object or a list to that of its member `step`; false, without a move, where it
  /// has none.
  bool enter(const std::string& step) {
    const std::size_t begin = at_;
    if (done() || (text_[at_] != '{' && text_[at_] != '[')) return false;
    const bool object = text_[at_++] == '{';
    for (std::size_t index = 0; skipBlanks(), !done() && text_[at_] != '}' && text_[at_] != ']'; ++index) {
      const bool found = object ? skipText() == step : std::to_string(index) == step;
      skipBlanks();
      if (object) ++at_;  // the colon
      skipBlanks();
      if (found) return true;
      skipValue();
      if (!done() && text_[at_] == ',') ++at_;
    }
    at_ = begin;
    return false;
  }

 private:
  std::string_view text_;
  std::size_t at_ = 0;
};

}  // namespace fiatlux
