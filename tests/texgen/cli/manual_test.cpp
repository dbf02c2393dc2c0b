// SPDX-License-Identifier: Apache-2.0

#include "tests/texgen/cli/run_program.h"

#include <gtest/gtest.h>

#include <fstream>
#include <string>
#include <string_view>
#include <vector>

namespace foam::texgen {
namespace {

TEST(Manual, HasEveryCommandAndNoLineThatIsARequestByMistake) {
    const std::string page = run_program("manual").out;
    EXPECT_TRUE(page.starts_with(".TH FOAMTEX 1 "));
    EXPECT_NE(page.find(".SS foamtex bake [OPTIONS] PRESET\n"), std::string::npos);
    EXPECT_NE(page.find(".SS foamtex presets show [OPTIONS] NAME\n"), std::string::npos);
    std::size_t at = 0;
    while ((at = page.find("\n.", at)) != std::string::npos) {
        const std::string_view line = std::string_view(page).substr(at + 2, 3);
        const bool known = line.starts_with("SH ") || line.starts_with("SS ") ||
                           line.starts_with("TP\n") || line.starts_with("PP\n") || line == "nf\n" ||
                           line == "fi\n";
        EXPECT_TRUE(known) << line;
        ++at;
    }
}

}  // namespace
}  // namespace foam::texgen
