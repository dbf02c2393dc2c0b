// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <filesystem>

namespace foam::test {

/// tests/data.
std::filesystem::path data_folder();

/// The README.md of the project.
std::filesystem::path readme();

/// The program, as it was built with the tests.
std::filesystem::path executable();

}  // namespace foam::test
