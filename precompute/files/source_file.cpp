#include "precompute/files/source_file.h"

#include <algorithm>
#include <filesystem>

#include "precompute/base/names.h"
#include "precompute/files/files_on_disk.h"
#include "precompute/gltf/refusal.h"

namespace fiatlux {
namespace {

namespace fs = std::filesystem;

/// The bytes of a plain file of an accepted size; an error's line begins with what is wrong with it ("has 300
/// MB...").
Result<std::vector<std::uint8_t>> readPlainFile(const fs::path& path) {
  std::error_code error;
  if (!fs::exists(path, error)) return Error{"does not exist; check the name"};
  if (!fs::is_regular_file(path, error)) return Error{"is not a file; name a .glb or .gltf file"};
  const auto size = fs::file_size(path, error);
  if (error || size > GltfBudget::kBytes)
    return Error{"has " + megabytes(size) + ", and " + megabytes(GltfBudget::kBytes) +
                 " are accepted; make the textures or meshes smaller"};
  Result<std::vector<std::uint8_t>> bytes = readFileBytes(path.string(), GltfBudget::kBytes);
  if (!bytes) return Error{"cannot be read; check its permissions"};
  return bytes;
}

}  // namespace

Result<std::vector<std::uint8_t>> readModelFile(const std::string& path) {
  Result<std::vector<std::uint8_t>> bytes = readPlainFile(path);
  if (!bytes) return Error{std::string("'").append(cleanText(path)) + "' " + bytes.error().message};
  return bytes;
}

Resolve siblingsOf(const std::string& path) {
  const fs::path parent = fs::path(path).parent_path();
  const fs::path folder = parent.empty() ? fs::path(".") : parent;
  return [folder](const std::string& name) -> Result<std::optional<std::vector<std::uint8_t>>> {
    std::error_code error;
    const fs::path root = fs::canonical(folder, error), file = fs::canonical(root / name, error);
    if (error) return std::optional<std::vector<std::uint8_t>>();
    // note: after links are followed, so that none leads out
    if (std::mismatch(root.begin(), root.end(), file.begin(), file.end()).first != root.end())
      return Error{
          "links to outside the file's folder; put the file beside the glTF and name it plainly, or export "
          "as "
          ".glb"};
    Result<std::vector<std::uint8_t>> bytes = readPlainFile(file);
    if (!bytes) return bytes.error();
    return std::optional(std::move(*bytes));
  };
}

}  // namespace fiatlux
