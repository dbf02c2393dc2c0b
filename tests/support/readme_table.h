// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <string_view>

namespace foam::test {

/// Expects that the README.md of a folder of the project contains the table. The table is Markdown
/// and begins with a line of headings and a line of dashes. If FOAMTEX_UPDATE_GOLDEN is set, the
/// table first replaces the table with the same headings in the README.
void expect_in_readme(std::string_view folder, std::string_view table);

}  // namespace foam::test
