// SPDX-License-Identifier: Apache-2.0

#include "texgen/cli/program.h"

#include <cstdlib>  // defines __GLIBC__
#ifdef __GLIBC__
#include <malloc.h>
#endif

namespace {

// Makes the program keep freed memory for the next image. By default, glibc returns most of it to
// the system. Clearing the pages of each new image then takes 3 to 12 % of the time of a bake.
void keep_freed_memory() {
#ifdef __GLIBC__
    constexpr int kMaxBlockBytes = 32 << 20;  // the largest value that mallopt accepts
    constexpr int kKeptBytes = 256 << 20;     // free memory that stays at the end of the heap
    mallopt(M_MMAP_THRESHOLD, kMaxBlockBytes);
    mallopt(M_TRIM_THRESHOLD, kKeptBytes);
#endif
}

}  // namespace

int main(int argc, char** argv) {
    keep_freed_memory();
    return static_cast<int>(foam::texgen::run_program(argc, argv));
}
