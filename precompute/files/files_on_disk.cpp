// Write beside, flush to the disk, rename. The name of the file being written is kept where a signal handler
// may see it.
#include "precompute/files/files_on_disk.h"

#include <fcntl.h>
#include <signal.h>
#include <sys/stat.h>
#include <unistd.h>

#include <atomic>
#include <cerrno>
#include <cstring>

#include "precompute/base/error.h"

namespace fiatlux {
namespace {

// Set while a temporary file exists; the handler may only call what is async-signal-safe.
char temporaryName[4096];
std::atomic<bool> temporaryExists{false};

extern "C" void onInterrupt(int) {
  if (temporaryExists.load()) ::unlink(temporaryName);
  constexpr std::string_view kClear = "\r\033[K", kLine = "fiatlux: stopped; nothing was written\n";
  if (::isatty(2)) (void)!::write(2, kClear.data(), kClear.size());
  (void)!::write(2, kLine.data(), kLine.size());
  ::_exit(2);
}

std::string reason() {
  switch (errno) {
    case ENOSPC:
    case EDQUOT:
      return "the disk is full: make room or write elsewhere";
    case ENOENT:
      return "there is no such folder";
    case EACCES:
    case EPERM:
    case EROFS:
      return "writing there is not permitted";
    case EISDIR:
      return "that is a folder";
    default:
      return std::strerror(errno);
  }
}

/// Writes all bytes and flushes them to the disk; false with errno set.
bool writeAll(int file, std::span<const std::uint8_t> bytes) {
  while (!bytes.empty()) {
    const ssize_t written = ::write(file, bytes.data(), bytes.size());
    if (written < 0 && errno == EINTR) continue;
    if (written <= 0) return false;
    bytes = bytes.subspan(static_cast<std::size_t>(written));
  }
  return ::fsync(file) == 0 || errno == EINVAL || errno == ENOTSUP;  // pipes and devices cannot be flushed
}

bool isSpecial(const std::string& path) {
  struct stat status {};
  return ::stat(path.c_str(), &status) == 0 && !S_ISREG(status.st_mode) && !S_ISDIR(status.st_mode);
}

bool isFolder(const std::string& path) {
  struct stat status {};
  return ::stat(path.c_str(), &status) == 0 && S_ISDIR(status.st_mode);
}

/// The file that `path` means, through symbolic links, so that a rename replaces the file and not the link.
std::string resolved(const std::string& path) {
  char* real = ::realpath(path.c_str(), nullptr);
  if (!real) return path;
  std::string result = real;
  ::free(real);
  return result;
}

std::string besides(const std::string& path) { return path + ".part" + std::to_string(::getpid()); }

void writeSpecial(const std::string& path, std::span<const std::uint8_t> bytes) {
  const int file = ::open(path.c_str(), O_WRONLY | O_CLOEXEC);
  const bool written = file >= 0 && writeAll(file, bytes);
  const std::string why = written ? "" : reason();
  if (file >= 0) ::close(file);
  if (!written) throw CommandError(path + ": cannot be written: " + why);
}

}  // namespace

void writeFileAtomically(const std::string& path, std::span<const std::uint8_t> bytes) {
  if (isFolder(path)) throw CommandError(path + ": cannot be written: that is a folder");
  if (isSpecial(path)) return writeSpecial(path, bytes);
  const std::string target = resolved(path);
  const std::string temporary = besides(target);
  if (temporary.size() >= sizeof temporaryName)
    throw CommandError(path + ": cannot be written: its name is too long");
  std::memcpy(temporaryName, temporary.c_str(), temporary.size() + 1);
  temporaryExists = true;
  const int file = ::open(temporary.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0666);
  bool written = file >= 0 && writeAll(file, bytes);
  std::string why = written ? "" : reason();
  if (file >= 0 && ::close(file) != 0 && written) written = false, why = reason();
  if (written && ::rename(temporary.c_str(), target.c_str()) != 0) written = false, why = reason();
  if (!written && file >= 0) ::unlink(temporary.c_str());
  temporaryExists = false;
  if (!written) throw CommandError(path + ": cannot be written: " + why);
}

void writeFileAtomically(const std::string& path, std::string_view text) {
  writeFileAtomically(path, std::span(reinterpret_cast<const std::uint8_t*>(text.data()), text.size()));
}

void checkWritable(const std::string& path) {
  if (isFolder(path)) throw CommandError(path + ": cannot be written: that is a folder");
  if (isSpecial(path)) return;
  const std::string temporary = besides(resolved(path));
  const int file = ::open(temporary.c_str(), O_WRONLY | O_CREAT | O_CLOEXEC, 0666);
  if (file < 0) throw CommandError(path + ": cannot be written: " + reason());
  ::close(file);
  ::unlink(temporary.c_str());
}

std::vector<std::uint8_t> readFileBytes(const std::string& path, std::uint64_t maxBytes) {
  const auto fail = [&](const std::string& why) { return CommandError(path + ": cannot be read: " + why); };
  const int file = ::open(path.c_str(), O_RDONLY | O_CLOEXEC);
  if (file < 0) throw fail(errno == ENOENT ? "there is no such file" : std::strerror(errno));
  std::vector<std::uint8_t> bytes;
  for (;;) {
    constexpr std::size_t kChunk = 1 << 20;
    const std::size_t size = bytes.size();
    bytes.resize(size + kChunk);
    const ssize_t count = ::read(file, bytes.data() + size, kChunk);
    if (count < 0 && errno == EINTR) {
      bytes.resize(size);
      continue;
    }
    const std::string why = count < 0 ? std::strerror(errno) : "";
    bytes.resize(size + static_cast<std::size_t>(count < 0 ? 0 : count));
    if (count > 0 && bytes.size() <= maxBytes) continue;
    ::close(file);
    if (count < 0) throw fail(why);
    if (count > 0) throw fail("it is larger than " + std::to_string(maxBytes >> 20) + " MB");
    return bytes;
  }
}

void installInterruptHandler() {
  struct sigaction action {};
  action.sa_handler = onInterrupt;
  for (int signal : {SIGINT, SIGTERM, SIGHUP}) ::sigaction(signal, &action, nullptr);
}

}  // namespace fiatlux
