// SPDX-License-Identifier: Apache-2.0

#include "tests/support/test_files.h"

namespace foam::test {

std::filesystem::path data_folder() {
    return FOAMTEX_TEST_DATA;
}

std::filesystem::path readme() {
    return FOAMTEX_README;
}

std::filesystem::path executable() {
    return FOAMTEX_EXECUTABLE;
}

}  // namespace foam::test
