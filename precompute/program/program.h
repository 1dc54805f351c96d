// A program of commands: its command line, and how what fails is told.
#pragma once

#include <initializer_list>

namespace CLI {
class App;
}

namespace fiatlux {

/// Runs the command that the arguments ask for, among those that each of `addCommands` adds, which --help
/// lists in this order. What main returns: 0, 2 where the arguments or the command fail (said on standard
/// error), or what a command says itself.
int runProgram(int argc, char** argv, std::initializer_list<void (*)(CLI::App&)> addCommands);

}  // namespace fiatlux
