// A bar is redrawn at most ten times a second; plain lines come at most every five.
#include "precompute/files/terminal.h"

#include <unistd.h>

#include <algorithm>
#include <cstdio>

namespace fiatlux {

Progress::Progress(bool quiet) : quiet_(quiet), terminal_(::isatty(2) != 0), last_(Clock::now()) {}

Progress::~Progress() { clear(); }

void Progress::update(const std::string& stage, double fraction) {
  if (quiet_) return;
  const std::lock_guard lock(mutex_);
  const auto now = Clock::now();
  const bool fresh = stage != stage_;
  const auto pause = std::chrono::milliseconds(terminal_ ? 100 : 5000);
  if (!(fresh && terminal_) && now - last_ < pause) return;
  stage_ = stage;
  last_ = now;
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

void Progress::clear() {
  const std::lock_guard lock(mutex_);
  if (shown_) std::fprintf(stderr, "\r\033[K"), std::fflush(stderr);
  shown_ = false;
}

void printNote(const std::string& line) { std::fprintf(stderr, "fiatlux: %s\n", printable(line).c_str()); }

std::string printable(const std::string& text, std::size_t longest) {
  std::string result = text.size() > longest ? text.substr(0, longest) + "..." : text;
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
