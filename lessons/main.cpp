#include "lessons/command_line.h"
#include "program/run_program.h"

int main(int argc, char** argv) { return zproof::run_program(argc, argv, zproof::parse_study); }
