// The commands of `fiatlux`, one file each (<name>.cpp). Each adds its subcommand and options to the
// command line.
#pragma once

namespace CLI {
class App;
}

namespace fiatlux {

// Each registers a callback that throws CommandError on failure; runProgram() prints it and returns 2.
void addSurfacesCommand(CLI::App& app);
void addInfoCommand(CLI::App& app);
void addEvaluateCommand(CLI::App& app);
void addLightCommand(CLI::App& app);
void addPhotometryCommand(CLI::App& app);
void addValidateCommand(CLI::App& app);
void addSolveCommand(CLI::App& app);
void addAlphaCommand(CLI::App& app);
void addExperimentsCommand(CLI::App& app);

}  // namespace fiatlux
