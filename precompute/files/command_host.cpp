#include "precompute/files/command_host.h"

#include "precompute/base/parallel.h"
#include "precompute/files/scene_io.h"
#include "precompute/files/source_file.h"

namespace fiatlux {

Host commandHost(const std::string& path, unsigned threads, TerminalProgress& progress) {
  Host host;
  host.deflate = zlibDeflate;
  host.resolve = siblingsOf(path);
  host.threads = threadCount(threads);
  host.progress = &progress;
  host.warn = [&progress, path](const std::string& warning) {
    progress.clear();
    printNote("warning: " + path + ": " + warning);
  };
  return host;
}

Result<ModelFile> modelAt(const std::string& path) {
  Result<std::vector<std::uint8_t>> bytes = readModelFile(path);
  if (!bytes) return bytes.error();
  return ModelFile{path, std::move(*bytes)};
}

}  // namespace fiatlux
