// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <filesystem>

namespace foam::test {

/// Returns the folder tests/data.
std::filesystem::path data_folder();

/// Returns the path of the README.md of the project.
std::filesystem::path readme();

/// Returns the path of the program foamtex that was built with the tests.
std::filesystem::path executable();

}  // namespace foam::test
