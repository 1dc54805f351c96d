// Opens a .flux file in a Session natively, for the tests' and benchmarks' own small programs. Ends the
// program with one line where it cannot.
#pragma once

#include <zlib.h>

#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <iterator>
#include <string>
#include <vector>

#include "core/session/session.h"

namespace fiatlux {

[[noreturn]] inline void fail(const std::string& message) {
  std::fprintf(stderr, "%s\n", message.c_str());
  std::exit(2);
}

inline void requireDone(const Result<Done>& result) {
  if (!result) fail(result.error().message);
}

inline void openFile(Session& session, const char* path) {
  using Bytes = std::vector<std::uint8_t>;
  std::ifstream stream(path, std::ios::binary);
  const Bytes file{std::istreambuf_iterator<char>(stream), {}};
  requireDone(session.openTable(file));
  for (std::uint32_t i = 0; i < session.table()->sections.size(); ++i) {
    if (!session.needed(i)) continue;
    const SceneSection& section = session.table()->sections[i];
    const auto stored = storedBytes(file, section);
    Bytes bytes(stored.begin(), stored.end());
    if (section.codec == Codec::kDeflate) {
      uLongf size = section.inflatedBytes;
      bytes.resize(size);
      if (uncompress(bytes.data(), &size, stored.data(), stored.size()) != Z_OK)
        fail(section.name + ": cannot be inflated");
    }
    requireDone(session.provide(i, std::move(bytes)));
  }
  requireDone(session.finish());
}

}  // namespace fiatlux
