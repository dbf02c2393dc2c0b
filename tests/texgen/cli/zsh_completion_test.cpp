// SPDX-License-Identifier: Apache-2.0

#include "tests/texgen/cli/run_program.h"
#include "texgen/cli/completion.h"

#include <gtest/gtest.h>

#include <fstream>
#include <string>
#include <string_view>
#include <vector>

namespace foam::texgen {
namespace {

TEST(ZshCompletion, OffersEveryCommand) {
    const std::string script = run_program("completion zsh").out;
    EXPECT_TRUE(script.starts_with("#compdef foamtex\n"));
    for (const char* command : {"bake", "presets_show", "compare", "verify"}) {
        EXPECT_NE(script.find(std::string("\n_foamtex_") + command + "() {"), std::string::npos)
            << command;
    }
}

TEST(ZshCompletion, OffersTheValuesOfKeys) {
    const std::string script = run_program("completion zsh").out;
    EXPECT_NE(script.find("            relief.profile) compadd - dome ridge wet ;;\n"),
              std::string::npos);
    EXPECT_NE(script.find(":KEY=VALUE:_foamtex_keys'"), std::string::npos);
}

TEST(ZshCompletion, OffersRepeatableOptionsAgain) {
    const std::string script = run_program("completion zsh").out;
    for (const char* option : {"--set", "--pack", "--sweep"}) {
        EXPECT_NE(script.find(std::string("'*") + option), std::string::npos) << option;
    }
    EXPECT_EQ(script.find("'*--size"), std::string::npos);
}

TEST(ZshCompletion, ARepeatableOptionMayHaveSeveralNames) {
    CommandGrammar program;
    program.name = "brew";
    program.options.push_back({{"-h", "--herb"}, "NAME", "What to add", true});
    program.options.push_back({{"-c", "--cups"}, "N", "How many", false});
    const std::string script = zsh_completion(program, {});
    EXPECT_NE(script.find("        '*'{-h,--herb}'[What to add]:NAME:_files'"), std::string::npos);
    EXPECT_NE(script.find("        '(-c --cups)'{-c,--cups}'[How many]:N:_files'"),
              std::string::npos)
        << script;
}

}  // namespace
}  // namespace foam::texgen
