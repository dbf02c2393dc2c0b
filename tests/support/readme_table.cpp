#include "tests/support/readme_table.h"

#include "tests/support/places.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <fstream>
#include <iterator>
#include <string>

namespace foam::test {

namespace {

std::string read_readme() {
    std::ifstream file(readme());
    return {std::istreambuf_iterator<char>(file), {}};
}

/// Returns the text with the table in place of the one that has the same headings; unchanged if
/// there is none.
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

void expect_in_readme(std::string_view table) {
    if (std::getenv("FOAMTEX_UPDATE_GOLDEN") != nullptr) {
        const std::string updated = replace_table(read_readme(), table);
        std::ofstream(readme()) << updated;
    }
    EXPECT_NE(read_readme().find(table), std::string::npos)
        << "FOAMTEX_UPDATE_GOLDEN=1 writes this table into the README:\n"
        << table;
}

}  // namespace foam::test
