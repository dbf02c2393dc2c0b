// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <string_view>

namespace foam::test {

/// Expects that the README.md of a folder of the project has the table, which is Markdown and
/// begins with a line of headings and a line of dashes. With FOAMTEX_UPDATE_GOLDEN set, the table
/// replaces the one in the README that has the same headings.
void expect_in_readme(std::string_view folder, std::string_view table);

}  // namespace foam::test
