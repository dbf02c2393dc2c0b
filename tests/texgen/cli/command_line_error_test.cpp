// SPDX-License-Identifier: Apache-2.0

#include "texgen/cli/command_line_error.h"

#include "tests/texgen/cli/run_program.h"

#include <CLI/CLI.hpp>
#include <gtest/gtest.h>

#include <initializer_list>
#include <string>
#include <utility>

namespace foam::texgen {
namespace {

// Returns the message about a command line of a program that has the command `brew` with the
// argument LEAF and the options --cups and -s, and the command `cup` with the command `wash`.
std::string error_of(const std::string& arguments) {
    CLI::App program("Makes tea", "tea");
    program.require_subcommand(1);
    CLI::App* const brew = program.add_subcommand("brew", "");
    std::string leaf;
    int cups = 0;
    bool strong = false;
    brew->add_option("LEAF", leaf, "")->required();
    brew->add_option("-c,--cups", cups, "")->check(CLI::Range(1, 9));
    brew->add_flag("-s", strong, "");
    program.add_subcommand("cup", "")->require_subcommand(1)->add_subcommand("wash", "");
    try {
        program.parse(arguments);
    } catch (const CLI::ParseError& error) {
        return command_line_error(program, error);
    }
    return "";
}

TEST(CommandLineError, SuggestsOptions) {
    const std::string cups =
        "brew has no option '--cup'; did you mean '--cups'? (see tea brew --help)";
    EXPECT_EQ(error_of("brew mint --cup 3"), cups);
    EXPECT_EQ(error_of("brew mint --cup=3"), cups);
    EXPECT_EQ(error_of("brew --cup 3 mint"), cups);
    EXPECT_EQ(error_of("brew --cup"), cups);  // although LEAF is missing
    EXPECT_EQ(error_of("brew mint --xyzzy"), "brew has no option '--xyzzy' (see tea brew --help)");
    EXPECT_EQ(error_of("brew mint -x"), "brew has no option '-x' (see tea brew --help)");
    EXPECT_EQ(error_of("--hlep brew mint"),
              "tea has no option '--hlep'; did you mean '--help'? (see tea brew --help)");
    EXPECT_EQ(error_of("--cups 3 brew mint"),
              "the option '--cups' must follow 'brew' (see tea brew --help)");
    EXPECT_EQ(error_of("-s brew mint"), "the option '-s' must follow 'brew' (see tea brew --help)");
}

TEST(CommandLineError, SuggestsSubcommands) {
    EXPECT_EQ(error_of("brw"), "tea has no command 'brw'; did you mean 'brew'? (see tea --help)");
    EXPECT_EQ(error_of("cup wahs"),
              "cup has no command 'wahs'; did you mean 'wash'? (see tea cup --help)");
    EXPECT_EQ(error_of("xyzzy"), "tea has no command 'xyzzy' (see tea --help)");
}

TEST(CommandLineError, OtherErrorsAreThoseOfTheParser) {
    EXPECT_EQ(error_of(""), "A subcommand is required (see tea --help)");
    EXPECT_EQ(error_of("brew"), "LEAF is required (see tea brew --help)");
    EXPECT_EQ(error_of("brew mint --cups 10"),
              "--cups: Value 10 not in range 1 to 9 (see tea brew --help)");
    EXPECT_EQ(error_of("brew mint sage"),
              "The following argument was not expected: sage (see tea brew --help)");
}

// The words of a command line with few possible values: each has a suggestion.
TEST(CommandLineError, EveryChoiceHasASuggestion) {
    for (const auto& [arguments, meant] :
         std::initializer_list<std::pair<const char*, const char*>>{
             {"bake sea_foam --framess 3", "did you mean '--frames'?"},
             {"compare a.png b.png --fial 3", "did you mean '--fail'?"},
             {"maps albdo", "did you mean 'albedo'?"},
             {"maps albedo --jsn", "did you mean '--json'?"},
             {"presets keys looop", "did you mean [loop]?"},
             {"presets show sea_fom", "did you mean 'sea_foam'?"},
             {"presets show presets/sea_foam.toml", "must be the name of a shipped preset"},
             {"completion bsh", "did you mean 'bash'?"},
             {"bake sea_fom", "did you mean 'sea_foam'?"},
             {"simulate sea_fom --cache foam", "did you mean 'sea_foam'?"},
             {"stats sea_fom", "did you mean 'sea_foam'?"},
             {"preview sea_fom", "did you mean 'sea_foam'?"},
             {"bake sea_foam --maps albdo", "did you mean 'albedo'?"},
             {"bake sea_foam --set albedo.colormap=viridiss", "did you mean 'viridis'?"},
             {"bake sea_foam --set relief.profile=wett", "did you mean 'wet'?"},
             {"bake sea_foam --set albedo.colormp=magma", "did you mean 'albedo.colormap'?"},
             {"bake sea_foam --normal-y gll", "did you mean 'gl'?"},
             {"bake sea_foam --progress jsn", "did you mean 'json'?"},
             {"preview sea_foam --as contct", "did you mean 'contact'?"},
             {"compare a.png b.png --map albdo", "did you mean 'albedo'?"}}) {
        const Outcome outcome = run_program(arguments);
        EXPECT_NE(outcome.err.find(meant), std::string::npos) << arguments << '\n' << outcome.err;
        EXPECT_NE(outcome.code, 0) << arguments;
        EXPECT_EQ(outcome.out, "") << arguments;
        EXPECT_TRUE(outcome.written.empty()) << arguments;
    }
}

}  // namespace
}  // namespace foam::texgen
