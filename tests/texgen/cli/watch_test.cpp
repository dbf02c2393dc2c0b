// SPDX-License-Identifier: Apache-2.0

#include "texgen/cli/watch.h"

#include "tests/support/temporary_folder.h"
#include "tests/support/test_files.h"
#include "tests/texgen/cli/run_program.h"

#include <gtest/gtest.h>

#include <chrono>
#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

namespace foam::texgen {
namespace {

namespace fs = std::filesystem;

void write(const fs::path& path, const std::string& text) {
    std::ofstream(path) << text;
}

TEST(WatchedFiles, ChangeWhenTheirContentDoes) {
    const TemporaryFolder folder;
    const fs::path file = folder.path() / "a.toml";
    write(file, "one");
    WatchedFiles files({file, folder.path() / "missing"});
    EXPECT_FALSE(files.have_changed());
    write(file, "three");
    EXPECT_TRUE(files.have_changed());
    EXPECT_FALSE(files.have_changed());
}

// Many editors save a file in this way: they write another file and rename it to the first one.
TEST(WatchedFiles, ChangeWhenAnotherFileTakesTheirPlace) {
    const TemporaryFolder folder;
    const fs::path file = folder.path() / "a.toml";
    write(file, "one");
    WatchedFiles files({file});
    write(folder.path() / "new", "two and more");
    fs::rename(folder.path() / "new", file);
    EXPECT_TRUE(files.have_changed());
}

TEST(WatchedFiles, AreTheSameIfOnlyTheirTimeChanges) {
    const TemporaryFolder folder;
    const fs::path file = folder.path() / "a.toml";
    write(file, "one");
    WatchedFiles files({file});
    fs::last_write_time(file, fs::last_write_time(file) + std::chrono::hours(1));
    EXPECT_FALSE(files.have_changed());
}

TEST(WatchedFiles, ChangeWhenTheyAppearOrVanish) {
    const TemporaryFolder folder;
    const fs::path file = folder.path() / "a.toml";
    WatchedFiles files({file});
    write(file, "one");
    EXPECT_TRUE(files.have_changed());
    fs::remove(file);
    EXPECT_TRUE(files.have_changed());
    EXPECT_FALSE(files.have_changed());
}

// The path of the program, and functions of a shell that wait until a file exists or until stderr
// contains a text, as long as the program runs.
std::string shell_start() {
    return "--version > /dev/null; foamtex='" + foam::test::executable().string() +
           "'; until_file() { until [ -e \"$1\" ] || ! kill -0 $pid; do sleep 0.02; done; }; "
           "until_text() { until grep -q \"$1\" err || ! kill -0 $pid; do sleep 0.02; done; }; "
           "small='--set foam.bubbles=16 --set loop.kind=none --size 16 --frames 1'; ";
}

// The seed in the name of the image shows which version of the preset has been baked.
TEST(Watch, BakesAgainWhenThePresetOrItsBaseChanges) {
    const TemporaryFolder folder;
    write(folder.path() / "base.toml", "extends = \"sea_foam\"\n[foam]\nseed = 1\n");
    write(folder.path() / "a.toml", "extends = \"base.toml\"\n");
    const Outcome outcome = run_program(
        shell_start() +
            "\"$foamtex\" bake a.toml $small --watch --out '{seed}.png' 2>err >out.txt & pid=$!; "
            "until_file 1.png; until_text 'watching a.toml, base.toml'; "
            "sed 's/seed = 1/seed = 2/' base.toml > new; mv new base.toml; until_file 2.png; "
            "printf '[foam]\\nbubles = 3\\n' > a.toml; until_text 'bubles'; "
            "printf 'extends = \"base.toml\"\\n[foam]\\nseed = 3\\n' > a.toml; until_file 3.png; "
            "kill -INT $pid; wait $pid",
        folder);
    EXPECT_EQ(outcome.code, 130);
    EXPECT_EQ(file_content(folder.path() / "out.txt"), "1.png\n2.png\n3.png\n");
    const std::string err = file_content(folder.path() / "err");
    EXPECT_NE(err.find("foamtex: watching a.toml, base.toml; Ctrl-C ends\n"), std::string::npos);
    EXPECT_NE(err.find("foamtex: a.toml:2: key 'foam.bubles' = 3: unknown key; did you mean "
                       "'foam.bubbles'?\n"),
              std::string::npos)
        << err;
    EXPECT_TRUE(err.ends_with("foamtex: interrupted\n")) << err;
}

TEST(Watch, PreviewsAgainWhenThePresetChanges) {
    const TemporaryFolder folder;
    write(folder.path() / "a.toml", "extends = \"sea_foam\"\n");
    const Outcome outcome = run_program(
        shell_start() +
            "\"$foamtex\" preview a.toml $small --as tiling --watch 2>err >out.txt & pid=$!; "
            "until_text 'watching a.toml'; cp out/a_lit_tiling.png first.png; "
            "printf 'extends = \"sea_foam\"\\n[foam]\\nseed = 2\\n' > a.toml; "
            "until ! cmp -s out/a_lit_tiling.png first.png || ! kill -0 $pid; do sleep 0.02; done; "
            "kill -TERM $pid; wait $pid",
        folder);
    EXPECT_EQ(outcome.code, 143) << file_content(folder.path() / "err");
    EXPECT_NE(file_content(folder.path() / "first.png"),
              file_content(folder.path() / "out/a_lit_tiling.png"));
}

TEST(Watch, NeedsAFile) {
    expect_rejected("bake sea_foam --watch",
                    "--watch: 'sea_foam' has no file that could change; 'foamtex presets show "
                    "sea_foam > my.toml' makes one");
    EXPECT_EQ(run_program("preview . --watch").code, 2);
    EXPECT_EQ(run_program("bake a.toml --watch --json").code, 2);
    EXPECT_EQ(run_program("bake a.toml --watch --set nonsense").code, 2);
}

}  // namespace
}  // namespace foam::texgen
