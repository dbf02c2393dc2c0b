// SPDX-License-Identifier: Apache-2.0

#include "texgen/cli/grammar.h"

#include <CLI/CLI.hpp>
#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace foam::texgen {
namespace {

TEST(Grammar, AgreesWithTheHelp) {
    CLI::App app("A program", "program");
    CLI::App* const command = app.add_subcommand("brew", "Make tea");
    int cups = 0;
    bool strong = false;
    std::string leaf;
    command->add_option("LEAF", leaf, "What it is made of")->required();
    command->add_option("-c,--cups", cups, "How many")->option_text("N");
    command->add_option("--name", leaf, "Without a text of its own");
    command->add_flag("--strong", strong, "With more leaves")->option_text(" ");
    command->footer("Examples");
    const CommandGrammar program = grammar_of(app);
    EXPECT_EQ(program.name, "program");
    ASSERT_EQ(program.commands.size(), 1U);
    const CommandGrammar& brew = program.commands.front();
    EXPECT_EQ(brew.name, "brew");
    EXPECT_EQ(brew.meaning, "Make tea");
    EXPECT_EQ(brew.notes, "Examples");
    ASSERT_EQ(brew.positionals.size(), 1U);
    EXPECT_EQ(brew.positionals[0].names, std::vector<std::string>{"LEAF"});
    ASSERT_EQ(brew.options.size(), 4U);  // including --help
    EXPECT_EQ(brew.options[1].names, (std::vector<std::string>{"-c", "--cups"}));
    EXPECT_EQ(brew.options[1].value, "N");
    EXPECT_EQ(brew.options[2].value, "VALUE");
    EXPECT_EQ(brew.options[3].value, "");  // a flag
}

}  // namespace
}  // namespace foam::texgen
