// What a command lends the pipeline: zlib, the folder of the model, the machine's threads and the terminal.
#pragma once

#include <string>

#include "precompute/files/terminal.h"
#include "precompute/pipeline/pipeline.h"

namespace fiatlux {

/// For the model at `path`; `threads` 0: as many as the machine has cores. `progress` must outlive it.
Host commandHost(const std::string& path, unsigned threads, TerminalProgress& progress);

/// The model at `path` in memory.
Result<ModelFile> modelAt(const std::string& path);

}  // namespace fiatlux
