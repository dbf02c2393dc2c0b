#pragma once

#include <fstream>
#include <iterator>
#include <string>

namespace foam::test {

/// The content of a file of tests/data.
inline std::string data_file(const std::string& name) {
    std::ifstream file(std::string(FOAMTEX_TEST_DATA "/") + name);
    return {std::istreambuf_iterator<char>(file), {}};
}

}  // namespace foam::test
