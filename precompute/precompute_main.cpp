// fiatlux-precompute: of fiatlux what makes rooms, which is there sooner.
#include "precompute/program/precompute_command.h"
#include "precompute/program/program.h"

int main(int argc, char** argv) { return fiatlux::runProgram(argc, argv, {fiatlux::addPrecomputeCommand}); }
