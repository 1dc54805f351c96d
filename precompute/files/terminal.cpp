// A bar is redrawn at most ten times a second; plain lines come at most every five.
#include "precompute/files/terminal.h"

#include <unistd.h>

#include <algorithm>
#include <cstdio>

namespace fiatlux {

TerminalProgress::TerminalProgress() : terminal_(::isatty(2) != 0) {}

TerminalProgress::~TerminalProgress() { clear(); }

void TerminalProgress::begin(const std::string& stage) {
  stages_.push_back({stage, Clock::now()});
  if (terminal_) last_ = {};  // a new bar appears at once
  update(0);
}

void TerminalProgress::update(double fraction) {
  if (stages_.empty()) return;
  const auto now = Clock::now();
  const auto pause = std::chrono::milliseconds(terminal_ ? 100 : 5000);
  if (now - last_ < pause) return;
  last_ = now;
  const std::string& stage = stages_.back().name;
  const int percent = static_cast<int>(100 * std::clamp(fraction, 0.0, 1.0));
  if (terminal_) {
    std::string bar(30, ' ');
    std::fill_n(bar.begin(), percent * 30 / 100, '#');
    std::fprintf(stderr, "\r\033[K%-22s [%s] %3d %%", stage.c_str(), bar.c_str(), percent);
    shown_ = true;
  } else {
    std::fprintf(stderr, "%s: %d %%\n", stage.c_str(), percent);
  }
  std::fflush(stderr);
}

std::vector<StageSeconds> TerminalProgress::seconds() {
  std::vector<StageSeconds> seconds;
  for (std::size_t i = 0; i < stages_.size(); ++i) {
    const auto end = i + 1 < stages_.size() ? stages_[i + 1].start : Clock::now();
    seconds.push_back({stages_[i].name, std::chrono::duration<double>(end - stages_[i].start).count()});
  }
  return seconds;
}

double TerminalProgress::total() const {
  return std::chrono::duration<double>(Clock::now() - start_).count();
}

void TerminalProgress::clear() {
  if (shown_) std::fprintf(stderr, "\r\033[K"), std::fflush(stderr);
  shown_ = false;
}

void printNote(const std::string& line) { std::fprintf(stderr, "fiatlux: %s\n", printable(line).c_str()); }

std::string printable(const std::string& text, std::size_t longest) {
  std::size_t cut = std::min(longest, text.size());
  while (cut > 0 && cut < text.size() && (text[cut] & 0xc0) == 0x80)
    --cut;  // to the beginning of a character
  std::string result = text.size() > longest ? text.substr(0, cut) + "..." : text;
  for (char& c : result)
    if (static_cast<unsigned char>(c) < 32 || c == 127) c = '?';
  // U+202A..U+202E and U+2066..U+2069 would turn the direction of the text that follows.
  for (std::size_t i = 0; i + 2 < result.size(); ++i) {
    const auto byte = [&](std::size_t k) { return static_cast<unsigned char>(result[i + k]); };
    const bool turns = byte(0) == 0xe2 && ((byte(1) == 0x80 && byte(2) >= 0xaa && byte(2) <= 0xae) ||
                                           (byte(1) == 0x81 && byte(2) >= 0xa6 && byte(2) <= 0xa9));
    if (turns) result[i] = '?', result[i + 1] = '?', result[i + 2] = '?';
  }
  return result;
}

}  // namespace fiatlux
