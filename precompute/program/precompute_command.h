// fiatlux precompute: glTF in, scene file out.
#pragma once

namespace CLI {
class App;
}

namespace fiatlux {

/// Adds the command, whose callback throws CommandError on failure.
void addPrecomputeCommand(CLI::App& app);

}  // namespace fiatlux
