// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <string_view>

namespace foam::test {

/// Expects that a page of a folder of the project, by default its README.md, contains the table.
/// The table is Markdown and begins with a line of headings and a line of dashes. If
/// FOAMTEX_UPDATE_GOLDEN is set, the table first replaces the table with the same headings in the
/// page.
void expect_in_readme(std::string_view folder,
                      std::string_view table,
                      std::string_view page = "README.md");

}  // namespace foam::test
