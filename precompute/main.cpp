// fiatlux: glTF in, scene file out; and everything one may ask of a scene file without a browser.
#include "precompute/commands/commands.h"
#include "precompute/program/precompute_command.h"
#include "precompute/program/program.h"

int main(int argc, char** argv) {
  using namespace fiatlux;
  return runProgram(
      argc, argv,
      {addSolveCommand, addAlphaCommand, addExperimentsCommand, addPrecomputeCommand, addSurfacesCommand,
       addInfoCommand, addEvaluateCommand, addLightCommand, addPhotometryCommand, addValidateCommand});
}
