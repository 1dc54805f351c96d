#include "precompute/files/command_host.h"

#include <algorithm>

#include "precompute/base/parallel.h"
#include "precompute/files/scene_io.h"
#include "precompute/files/source_file.h"

namespace fiatlux {
namespace {

constexpr std::size_t kMostWarnings = 5;  // that are printed unasked

}  // namespace

Host commandHost(const std::string& path, unsigned threads, TerminalProgress& progress, bool verbose) {
  Host host;
  host.deflate = zlibDeflate;
  host.resolve = siblingsOf(path);
  host.threads = threadCount(threads);
  host.progress = &progress;
  host.warn = [&progress, path, verbose](const std::vector<std::string>& warnings) {
    progress.clear();
    printWarnings(path, warnings, verbose);
  };
  return host;
}

void printWarnings(const std::string& path, const std::vector<std::string>& warnings, bool verbose) {
  const std::size_t shown = verbose ? warnings.size() : std::min(kMostWarnings, warnings.size());
  for (std::size_t i = 0; i < shown; ++i) printNote("warning: " + path + ": " + warnings[i]);
  if (const std::size_t more = warnings.size() - shown; more > 0)
    printNote(std::to_string(more) + (more == 1 ? " more remark" : " more remarks") +
              ": --verbose tells all");
}

Result<ModelFile> modelAt(const std::string& path) {
  Result<std::vector<std::uint8_t>> bytes = readModelFile(path);
  if (!bytes) return bytes.error();
  return ModelFile{path, std::move(*bytes)};
}

}  // namespace fiatlux
