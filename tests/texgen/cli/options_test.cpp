// SPDX-License-Identifier: Apache-2.0

#include "texgen/cli/options.h"

#include <CLI/CLI.hpp>
#include <gtest/gtest.h>

namespace foam::texgen {
namespace {

TEST(Options, ReadTheirValues) {
    CLI::App app;
    bool json = false;
    bool quiet = false;
    int threads = 0;
    std::optional<std::string> frames;
    std::optional<std::string> maps;
    std::string set;
    std::optional<std::filesystem::path> out;
    add_json_option(app, json);
    add_quiet_option(app, quiet);
    add_threads_option(app, threads);
    add_frames_option(app, frames);
    add_maps_option(app, maps, "");
    add_preset_name_option(app, set);
    add_out_folder_option(app, out, "");
    app.parse("--json -q --threads 3 --frames 1-2 --maps a,b --preset x -o y");
    EXPECT_TRUE(json);
    EXPECT_TRUE(quiet);
    EXPECT_EQ(threads, 3);
    EXPECT_EQ(frames, "1-2");
    EXPECT_EQ(maps, "a,b");
    EXPECT_EQ(set, "x");
    EXPECT_EQ(out, "y");
    EXPECT_THROW(app.parse("--threads 257"), CLI::ParseError);
}

TEST(Options, ListsOfWordsMayContainSpaces) {
    EXPECT_EQ(split_words("albedo, height ,lit"),
              (std::vector<std::string>{"albedo", "height", "lit"}));
}

TEST(Options, AllowOnlyWords) {
    CLI::App app;
    std::string shell;
    CLI::Option* const option = app.add_option("--shell", shell);
    allow_only(*option, {"bash", "zsh"});
    EXPECT_EQ(option->get_option_text(), "bash|zsh");
    app.parse("--shell zsh");
    EXPECT_EQ(shell, "zsh");
    try {
        app.parse("--shell bsh");
        FAIL();
    } catch (const CLI::ParseError& error) {
        EXPECT_STREQ(error.what(), "--shell: 'bsh' must be one of bash, zsh; did you mean 'bash'?");
    }
}

TEST(Options, ProgressIsAutomaticOrJson) {
    CLI::App app;
    std::string progress;
    add_progress_option(app, progress);
    EXPECT_FALSE(progress_options(false, progress).json);
    app.parse("--progress json");
    EXPECT_TRUE(progress_options(false, progress).json);
    EXPECT_EQ(progress_options(true, progress).verbosity, Verbosity::Quiet);
    app.parse("--progress auto");
    EXPECT_FALSE(progress_options(false, progress).json);
    EXPECT_THROW(app.parse("--progress xml"), CLI::ParseError);
}

}  // namespace
}  // namespace foam::texgen
