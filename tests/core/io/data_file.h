// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "tests/support/test_files.h"

#include <fstream>
#include <iterator>
#include <string>

namespace foam::test {

/// Returns the content of a file in tests/data.
inline std::string data_file(const std::string& name) {
    std::ifstream file(data_folder() / name);
    return {std::istreambuf_iterator<char>(file), {}};
}

}  // namespace foam::test
