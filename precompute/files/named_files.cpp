#include "precompute/files/named_files.h"

#include <algorithm>
#include <filesystem>

#include "precompute/files/files_on_disk.h"

namespace fiatlux {
namespace {

namespace fs = std::filesystem;

fs::path folderOf(const std::string& path) {
  const fs::path parent = fs::path(path).parent_path();
  return parent.empty() ? fs::path(".") : parent;
}

bool isBelow(const fs::path& folder, const fs::path& file) {
  return std::mismatch(folder.begin(), folder.end(), file.begin(), file.end()).first == folder.end();
}

}  // namespace

ReadNamed filesBeside(const std::string& path, const std::string& what) {
  return [folder = folderOf(path), what](const std::string& name) -> Result<std::vector<std::uint8_t>> {
    std::error_code error;
    const fs::path root = fs::canonical(folder, error), file = fs::canonical(root / name, error);
    if (error) return Error{"does not exist; its path is relative to the " + what};
    // note: after links are followed, so that none leads out
    if (!isBelow(root, file)) return Error{"is outside the " + what + "'s folder; put it beside the " + what};
    Result<std::vector<std::uint8_t>> bytes = readFileBytes(file.string(), kMaxPhotometricBytes);
    if (!bytes) return Error{"cannot be read, or has more than 4 MB"};
    return bytes;
  };
}

std::shared_ptr<const Photometry> photometryOf(const JsonField& name, const ReadNamed& read) {
  if (!read) name.fail("there is no folder in which to look for the file");
  const Result<std::vector<std::uint8_t>> bytes = read(name.text());
  if (!bytes) name.fail("the file " + bytes.error().message);
  Result<Photometry> photometry = readPhotometry(*bytes);
  if (!photometry) name.fail(photometry.error().message);
  return std::make_shared<const Photometry>(std::move(*photometry));
}

Result<std::string> nameSeenFrom(const std::string& to, const std::string& from, const std::string& name) {
  std::error_code error;
  const fs::path root = fs::canonical(folderOf(to), error),
                 file = fs::canonical(folderOf(from) / name, error);
  if (error || !isBelow(root, file))
    return Error{"it names the photometric file " + name +
                 ", which must lie beside it or below; write it to the " + "folder of " + from};
  return file.lexically_relative(root).generic_string();
}

}  // namespace fiatlux
