// What a command lends the pipeline: zlib, the folder of the model, the machine's threads and the terminal.
#pragma once

#include <string>

#include "precompute/files/terminal.h"
#include "precompute/pipeline/pipeline.h"

namespace fiatlux {

/// For the model at `path`; `threads` 0: as many as the machine has cores. `progress` must outlive it.
/// `verbose`: all warnings are printed, else the first five.
Host commandHost(const std::string& path, unsigned threads, TerminalProgress& progress, bool verbose);

/// Prints warnings of the model at `path`: the first five, unless `verbose`.
void printWarnings(const std::string& path, const std::vector<std::string>& warnings, bool verbose);

/// The model at `path` in memory.
Result<ModelFile> modelAt(const std::string& path);

}  // namespace fiatlux
