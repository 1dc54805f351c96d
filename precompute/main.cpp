// fiatlux: glTF in, scene file out; and everything one may ask of a scene file without a browser.
#include <CLI/CLI.hpp>
#include <cstdio>
#include <exception>

#include "precompute/command_error.h"
#include "precompute/commands.h"

int main(int argc, char** argv) {
  CLI::App app{"Say what the light in a room should do; the luminaires find their places."};
  app.name("fiatlux");
  app.set_version_flag("--version", "fiatlux 1.0.0");
  app.require_subcommand(1);
  fiatlux::addSolveCommand(app);
  fiatlux::addAlphaCommand(app);
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    return app.exit(error) == 0 ? 0 : 2;
  } catch (const std::exception& error) {
    std::fprintf(stderr, "fiatlux: %s\n", error.what());
    return 2;
  }
  return 0;
}
