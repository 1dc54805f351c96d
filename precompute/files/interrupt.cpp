// The path of the unfinished file is kept where a signal handler may see it.
#include "precompute/files/interrupt.h"

#include <signal.h>
#include <unistd.h>

#include <atomic>
#include <cassert>
#include <cstring>
#include <string_view>

namespace fiatlux {
namespace {

char unfinished[RemovedOnInterrupt::kLongestPath + 1];
std::atomic<bool> isUnfinished{false};

/// note: it may only call what is async-signal-safe.
extern "C" void onInterrupt(int) {
  if (isUnfinished.load()) ::unlink(unfinished);
  constexpr std::string_view kClear = "\r\033[K", kLine = "fiatlux: stopped; nothing was written\n";
  if (::isatty(2)) (void)!::write(2, kClear.data(), kClear.size());
  (void)!::write(2, kLine.data(), kLine.size());
  ::_exit(2);
}

}  // namespace

void installInterruptHandler() {
  struct sigaction action {};
  action.sa_handler = onInterrupt;
  for (const int signal : {SIGINT, SIGTERM, SIGHUP}) {
    struct sigaction before {};
    ::sigaction(signal, nullptr, &before);
    if (before.sa_handler != SIG_IGN) ::sigaction(signal, &action, nullptr);
  }
  ::signal(SIGXFSZ, SIG_IGN);
}

RemovedOnInterrupt::RemovedOnInterrupt(const std::string& path) {
  assert(path.size() <= kLongestPath && !isUnfinished);
  std::memcpy(unfinished, path.c_str(), path.size() + 1);
  isUnfinished = true;
}

RemovedOnInterrupt::~RemovedOnInterrupt() { isUnfinished = false; }

}  // namespace fiatlux
