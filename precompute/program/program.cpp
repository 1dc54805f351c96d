// The frame of every command; see program.h.
#include "precompute/program/program.h"

#include <CLI/CLI.hpp>
#include <cstdio>
#include <exception>
#include <new>

#include "precompute/base/version.h"
#include "precompute/files/interrupt.h"
#include "precompute/files/terminal.h"

namespace fiatlux {

int runProgram(int argc, char** argv, std::initializer_list<void (*)(CLI::App&)> addCommands) {
  CLI::App app{"Say what the light in a room should do; the luminaires find their places."};
  app.name("fiatlux");
  app.set_version_flag("--version", programVersion());
  app.require_subcommand(1);
  app.failure_message([](const CLI::App*, const CLI::Error& error) {
    return "fiatlux: " + printable(error.what(), 1000) + " (--help lists what there is)\n";
  });
  for (const auto addCommand : addCommands) addCommand(app);
  installInterruptHandler();
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
    std::fprintf(stderr, "fiatlux: %s\n", printable(error.what(), 1000).c_str());
    return 2;
  }
  return 0;
}

}  // namespace fiatlux
