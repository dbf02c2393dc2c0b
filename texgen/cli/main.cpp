// SPDX-License-Identifier: Apache-2.0

#include "texgen/cli/program.h"

int main(int argc, char** argv) {
    return static_cast<int>(foam::texgen::run_program(argc, argv));
}
