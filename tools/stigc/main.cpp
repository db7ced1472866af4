// SPDX-License-Identifier: MIT
// stigc, the command line program. See command_line.cpp for what it understands.
#include "run_line.h"

int main(int argc, char** argv) { return stig::cli::run_main(argc, argv); }
