// The frame of every command; see program.h.
#include "precompute/program/program.h"

#include <CLI/CLI.hpp>
#include <cstdio>
#include <exception>
#include <new>
#include <string>

#include "precompute/base/version.h"
#include "precompute/files/interrupt.h"
#include "precompute/files/terminal.h"

namespace fiatlux {
namespace {

/// One line where the first word is no command; empty where it is one, or an option.
std::string unknownCommand(const CLI::App& app, int argc, char** argv) {
  if (argc < 2 || argv[1][0] == '-') return "";
  std::string known;
  for (const CLI::App* command : app.get_subcommands([](const CLI::App*) { return true; })) {
    if (command->get_name() == argv[1]) return "";
    known += (known.empty() ? "" : ", ") + command->get_name();
  }
  return "there is no command \"" + printable(argv[1], 100) + "\"; the commands are " + known;
}

}  // namespace

int runProgram(int argc, char** argv, std::initializer_list<void (*)(CLI::App&)> addCommands) {
  CLI::App app{"Say what the light in a room should do; the luminaires find their places."};
  app.name("fiatlux");
  app.set_version_flag("--version", programVersion());
  app.require_subcommand(1);
  app.failure_message([](const CLI::App*, const CLI::Error& error) {
    return "fiatlux: " + printable(error.what(), 1000) + " (--help lists what there is)\n";
  });
  for (const auto addCommand : addCommands) addCommand(app);
  if (const std::string fault = unknownCommand(app, argc, argv); !fault.empty()) {
    std::fprintf(stderr, "fiatlux: %s\n", fault.c_str());
    return 2;
  }
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
