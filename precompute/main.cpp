// fiatlux: glTF in, scene file out; and everything one may ask of a scene file without a browser.
#include <CLI/CLI.hpp>
#include <cstdio>
#include <exception>
#include <new>

#include "precompute/base/error.h"
#include "precompute/base/version.h"
#include "precompute/commands/commands.h"
#include "precompute/files/interrupt.h"
#include "precompute/files/terminal.h"

int main(int argc, char** argv) {
  CLI::App app{"Say what the light in a room should do; the luminaires find their places."};
  app.name("fiatlux");
  app.set_version_flag("--version", fiatlux::programVersion());
  app.require_subcommand(1);
  app.failure_message([](const CLI::App*, const CLI::Error& error) {
    return "fiatlux: " + fiatlux::printable(error.what(), 1000) + " (--help lists what there is)\n";
  });
  fiatlux::addSolveCommand(app);
  fiatlux::addAlphaCommand(app);
  fiatlux::addExperimentsCommand(app);
  fiatlux::addPrecomputeCommand(app);
  fiatlux::addSurfacesCommand(app);
  fiatlux::addInfoCommand(app);
  fiatlux::addEvaluateCommand(app);
  fiatlux::addLightCommand(app);
  fiatlux::addPhotometryCommand(app);
  fiatlux::addValidateCommand(app);
  fiatlux::installInterruptHandler();
  try {
    app.parse(argc, argv);
  } catch (const CLI::RuntimeError& error) {
    return error.get_exit_code();  // said already
  } catch (const CLI::ParseError& error) {
    return app.exit(error) == 0 ? 0 : 2;
  } catch (const std::bad_alloc&) {
    std::fputs("fiatlux: not enough memory: use larger patches or fewer rays\n", stderr);
    return 2;
  } catch (const std::exception& error) {
    std::fprintf(stderr, "fiatlux: %s\n", fiatlux::printable(error.what(), 1000).c_str());
    return 2;
  }
  return 0;
}
