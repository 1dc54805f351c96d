// Write beside, flush to the disk, rename.
#include "precompute/files/files_on_disk.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstdlib>
#include <cstring>

#include "precompute/files/interrupt.h"

namespace fiatlux {
namespace {

/// What errno says, and the cure where there is one.
std::string reason() {
  switch (errno) {
    case ENOSPC:
    case EDQUOT:
      return "the disk is full: make room or write elsewhere";
    case EFBIG:
      return "it is larger than a file may be here: see ulimit -f";
    case ENOENT:
      return "there is no such folder";
    case EACCES:
    case EPERM:
    case EROFS:
      return "that is not permitted";
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

Error cannotWrite(const std::string& path, const std::string& why) {
  return Error{path + ": cannot be written: " + why};
}

Error cannotRead(const std::string& path, const std::string& why) {
  return Error{path + ": cannot be read: " + why};
}

/// An open file that closes itself.
class OpenFile {
 public:
  OpenFile(const std::string& path, int flags) : file_(::open(path.c_str(), flags | O_CLOEXEC, 0666)) {}
  ~OpenFile() { close(); }
  OpenFile(const OpenFile&) = delete;
  OpenFile& operator=(const OpenFile&) = delete;
  explicit operator bool() const { return file_ >= 0; }
  int number() const { return file_; }
  /// False with errno set where the last bytes could not be written.
  bool close() {
    const int file = file_;
    file_ = -1;
    return file < 0 || ::close(file) == 0;
  }

 private:
  int file_;
};

Result<Done> writeSpecial(const std::string& path, std::span<const std::uint8_t> bytes) {
  const OpenFile file(path, O_WRONLY);
  if (!file || !writeAll(file.number(), bytes)) return cannotWrite(path, reason());
  return Done{};
}

}  // namespace

Result<Done> replaceFile(const std::string& path, std::span<const std::uint8_t> bytes) {
  if (isFolder(path)) return cannotWrite(path, "that is a folder");
  if (isSpecial(path)) return writeSpecial(path, bytes);
  const std::string target = resolved(path), beside = besides(target);
  if (beside.size() > RemovedOnInterrupt::kLongestPath) return cannotWrite(path, "its name is too long");
  const RemovedOnInterrupt guard(beside);
  OpenFile file(beside, O_WRONLY | O_CREAT | O_TRUNC);
  if (!file) return cannotWrite(path, reason());
  if (writeAll(file.number(), bytes) && file.close() && ::rename(beside.c_str(), target.c_str()) == 0)
    return Done{};
  const Error error = cannotWrite(path, reason());
  ::unlink(beside.c_str());
  return error;
}

Result<Done> replaceFile(const std::string& path, std::string_view text) {
  return replaceFile(path, std::span(reinterpret_cast<const std::uint8_t*>(text.data()), text.size()));
}

Result<Done> checkReplaceable(const std::string& path) {
  if (isFolder(path)) return cannotWrite(path, "that is a folder");
  if (isSpecial(path)) return Done{};
  const std::string beside = besides(resolved(path));
  const OpenFile file(beside, O_WRONLY | O_CREAT);
  if (!file) return cannotWrite(path, reason());
  ::unlink(beside.c_str());
  return Done{};
}

Result<std::vector<std::uint8_t>> readFileBytes(const std::string& path, std::uint64_t most) {
  constexpr std::size_t kChunk = 1 << 20;
  const OpenFile file(path, O_RDONLY);
  if (!file) return cannotRead(path, errno == ENOENT ? "there is no such file" : reason());
  std::vector<std::uint8_t> bytes;
  for (;;) {
    const std::size_t size = bytes.size();
    bytes.resize(size + kChunk);
    const ssize_t count = ::read(file.number(), bytes.data() + size, kChunk);
    if (count < 0 && errno != EINTR) return cannotRead(path, reason());
    bytes.resize(size + static_cast<std::size_t>(count < 0 ? 0 : count));
    if (count == 0) return bytes;
    if (bytes.size() > most)
      return cannotRead(path, "it is larger than " + std::to_string(most >> 20) + " MB");
  }
}

}  // namespace fiatlux
