// SPDX-License-Identifier: Apache-2.0

#include "tests/support/readme_table.h"

#include "tests/support/test_files.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>

namespace foam::test {

namespace {

std::string read_text(const std::filesystem::path& path) {
    std::ifstream file(path);
    return {std::istreambuf_iterator<char>(file), {}};
}

/// Replaces the table that has the same headings in a text. Returns the text unchanged if it has no
/// such table.
std::string replace_table(std::string text, std::string_view table) {
    const std::string_view headings = table.substr(0, table.find('\n') + 1);
    const std::size_t begin = text.find(headings);
    if (begin == std::string::npos) {
        return text;
    }
    std::size_t end = begin;
    while (end < text.size() && text[end] == '|') {
        end = text.find('\n', end) + 1;
    }
    return text.replace(begin, end - begin, table);
}

}  // namespace

void expect_in_readme(std::string_view folder, std::string_view table, std::string_view page) {
    const std::filesystem::path path = readme().parent_path() / folder / page;
    if (std::getenv("FOAMTEX_UPDATE_GOLDEN") != nullptr) {
        const std::string updated = replace_table(read_text(path), table);
        std::ofstream(path) << updated;
    }
    EXPECT_NE(read_text(path).find(table), std::string::npos)
        << "FOAMTEX_UPDATE_GOLDEN=1 writes this table into " << path << ":\n"
        << table;
}

}  // namespace foam::test
