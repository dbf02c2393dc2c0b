// SPDX-License-Identifier: Apache-2.0

#include "tests/support/test_files.h"
#include "tests/texgen/cli/run_program.h"
#include "texgen/image/external_program.h"
#include "texgen/maps/all_maps.h"
#include "texgen/preset/preset_keys.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <string>
#include <vector>

namespace foam::texgen {
namespace {

TEST(Program, HelpFitsOneScreenAndNamesTheExitCodes) {
    for (const char* arguments : {"--help", "bake --help", "stats --help"}) {
        const Outcome help = run_program(arguments);
        EXPECT_EQ(help.code, 0);
        EXPECT_LE(std::count(help.out.begin(), help.out.end(), '\n'), 36) << arguments;
        EXPECT_NE(help.out.find("Examples:"), std::string::npos) << arguments;
    }
    EXPECT_NE(run_program("--help").out.find("3 the foam did not reach equilibrium"),
              std::string::npos);
}

TEST(Program, PrintsItsVersionAndLicenses) {
    const std::string out = run_program("--version").out;
    EXPECT_EQ(out.rfind("foamtex " FOAMTEX_VERSION "\n", 0), 0U);
    EXPECT_NE(out.find("Apache-2.0"), std::string::npos);
    EXPECT_NE(out.find("CC0-1.0"), std::string::npos);
}

// The version is defined in CMakeLists.txt. CITATION.cff must repeat it.
TEST(Program, HasTheVersionOfTheCitation) {
    const std::string page = file_content(foam::test::readme().parent_path() / "CITATION.cff");
    EXPECT_NE(page.find("\nversion: " FOAMTEX_VERSION "\n"), std::string::npos);
}

// A report about a fault needs these facts.
TEST(Program, PrintsTheFactsOfItsBuild) {
    for (const char* const arguments : {"--version --verbose", "--verbose --version"}) {
        const std::string out = run_program(arguments).out;
        for (const char* const word : {"\ncommit ",
                                       "\ncompiler ",
                                       "OpenEXR/3.",
                                       "libpng/1.",
                                       "\ninstructions ",
                                       "baseline"}) {
            EXPECT_NE(out.find(word), std::string::npos) << word << " in " << out;
        }
    }
}

TEST(Program, ABadCommandLineIsOneLineAndCode2) {
    expect_rejected("",
                    "a command is needed: 'foamtex studio' shows presets in the browser, 'foamtex "
                    "bake sea_foam' bakes one (see foamtex --help)");
    expect_rejected("bake", "PRESET is required (see foamtex bake --help)");
    expect_rejected("bake sea_foam --bogus",
                    "bake has no option '--bogus' (see foamtex bake --help)");
    expect_rejected("bake sea_foam --threads -1",
                    "--threads: Value -1 not in range 0 to 256 (see foamtex bake --help)");
    expect_rejected("bake sea_foam -q -v", "--quiet excludes --verbose (see foamtex bake --help)");
}

TEST(Program, AnUnknownCommandIsComparedWithThoseThatExist) {
    expect_rejected("bak sea_foam",
                    "foamtex has no command 'bak'; did you mean 'bake'? (see foamtex --help)");
    expect_rejected(
        "presets keyz",
        "presets has no command 'keyz'; did you mean 'keys'? (see foamtex presets --help)");
    expect_rejected("xyzzy", "foamtex has no command 'xyzzy' (see foamtex --help)");
}

TEST(Program, AnUnknownSimdLevelIsOneLineAndCode2) {
    setenv("FOAMTEX_SIMD", "mmx", 1);
    const Outcome outcome = run_program("bake sea_foam");
    unsetenv("FOAMTEX_SIMD");
    EXPECT_EQ(outcome.code, static_cast<int>(ExitCode::BadRequest));
    EXPECT_EQ(outcome.err.find("foamtex: environment variable FOAMTEX_SIMD = 'mmx': this machine "
                               "supports only baseline"),
              0U);
    EXPECT_TRUE(outcome.written.empty());
}

TEST(Program, AnOutputThatCannotBeWrittenIsCode5) {
    const Outcome outcome = run_program(
        "bake sea_foam --set foam.bubbles=16 --frames 1 --size 8 --out /proc/self/none.png");
    EXPECT_EQ(outcome.code, static_cast<int>(ExitCode::OutputFailed));
    EXPECT_TRUE(outcome.err.starts_with("foamtex: cannot write into '/proc/self': "))
        << outcome.err;
    // The # hides the redirections that run_program appends to the command.
    EXPECT_EQ(run_program("presets list >/dev/full 2>/dev/null #").code,
              static_cast<int>(ExitCode::OutputFailed));
}

TEST(Program, AFullOrClosedStdoutIsCode5) {
    for (const char* command : {"manual",
                                "maps",
                                "completion bash",
                                "presets keys",
                                "presets",
                                "presets show sea_foam",
                                "--help"}) {
        for (const char* lost : {">/dev/full", ">&-"}) {
            const Outcome outcome = run_program(std::string(command) + " " + lost + " 2>err #");
            EXPECT_EQ(outcome.code, 5) << command << lost;
        }
    }
}

TEST(Program, MessagesCannotControlATerminal) {
    EXPECT_EQ(run_program("bake 'a\033[31mb\007'").err,
              "foamtex: preset 'a?[31mb?': must be a .toml file or a name; 'foamtex presets' lists "
              "all presets\n");
    const Outcome outcome = run_program("bake sea_foam --set 'x.y=\xE2\x80\xAE\033]0;a\007'");
    EXPECT_EQ(outcome.code, 2);
    EXPECT_EQ(outcome.err.find('\033'), std::string::npos) << outcome.err;
    EXPECT_EQ(outcome.err.find('\007'), std::string::npos) << outcome.err;
    EXPECT_EQ(outcome.err.find("\xE2\x80\xAE"), std::string::npos) << outcome.err;
}

TEST(Program, MessagesAreShort) {
    const Outcome outcome = run_program("bake " + std::string(100'000, 'a'));
    EXPECT_EQ(outcome.code, 2);
    EXPECT_LT(outcome.err.size(), 2100U);
    EXPECT_TRUE(outcome.err.ends_with("'foamtex presets' lists all presets\n")) << outcome.err;
}

// The folder of a bake may have any name; the names that its manifest lists must be UTF-8.
TEST(Program, OnlyNamesOfFoldersNeedNotBeUtf8) {
    const std::string bake =
        "bake sea_foam -q --set foam.bubbles=16 --set loop.kind=none --frames 1-2 --size 8 ";
    const TemporaryFolder folder;
    const Outcome outcome = run_program(bake + "--json --out 'a\xFF/{map}.####.png'", folder);
    EXPECT_EQ(outcome.code, 0) << outcome.err;
    EXPECT_NE(outcome.out.find("a\xEF\xBF\xBD/manifest.json"), std::string::npos) << outcome.out;
    EXPECT_EQ(run_program("verify -q 'a\xFF'", folder).code, 0);
    EXPECT_EQ(run_program("flipbook -q 'a\xFF'", folder).code, 0);
    const Outcome rejected = run_program(bake +
                                         "--out '{map}\xFF"
                                         ".####.png'");
    EXPECT_EQ(rejected.code, 2) << rejected.err;
    EXPECT_TRUE(rejected.written.empty());
    const std::string rest =
        " sea_foam -q --json --set foam.bubbles=16 --set loop.kind=none "
        "--frames 1-2 --size 8 ";
    EXPECT_EQ(run_program("simulate" + rest +
                              "--cache 'b\xFF"
                              "'",
                          folder)
                  .code,
              0);
    EXPECT_EQ(run_program("stats" + rest +
                              "--out 'c\xFF"
                              "'",
                          folder)
                  .code,
              0);
    EXPECT_EQ(run_program("bake 'd\xFF"
                          ".toml'")
                  .code,
              2);
}

// A loop of links, and a path that is too long.
TEST(Program, FoldersThatCannotBeReachedAreCode5) {
    const TemporaryFolder folder;
    const TemporaryFolder other;
    std::filesystem::create_symlink("loop", other.path() / "loop");
    for (const std::string& out : {(other.path() / "loop").string(), std::string(5000, 'a')}) {
        const Outcome outcome =
            run_program("bake sea_foam --frames 1 --out '" + out + "/{map}.png'", folder);
        EXPECT_EQ(outcome.code, 5) << outcome.err;
        EXPECT_EQ(std::ranges::count(outcome.err, '\n'), 1) << outcome.err;
        EXPECT_EQ(run_program("bake " + out + "/a.toml", folder).code, 2);
        EXPECT_EQ(run_program("verify " + out, folder).code, 4);
        EXPECT_EQ(run_program("render " + out, folder).code, 4);
    }
}

#if !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__) && !defined(__clang__)
// Only some of the threads can be started: their stacks do not fit into the address space.
TEST(Program, RunsOnFewerThreadsIfTheSystemCannotStartSoMany) {
    const Outcome outcome = run_program(
        "--version >/dev/null; ulimit -v 300000; timeout -s KILL 60 '" +
        foam::test::executable().string() +
        "' bake sea_foam -q --set foam.bubbles=24 --set frames.count=30 --size 16 --threads 64 "
        "--out '{map}.####.png'");
    EXPECT_EQ(outcome.code, 0) << outcome.err;
}

// musl gives threads a stack of 128 KiB by default.
TEST(Program, ASmallStackIsEnough) {
    const Outcome outcome =
        run_program("--version >/dev/null; ulimit -s 128; '" + foam::test::executable().string() +
                    "' bake sea_foam -q --set foam.bubbles=24 --frames 1-2 --size 32 --threads 4 "
                    "--maps lit,film,height,distance,motion,maze,thin_film --out '{map}.####.png'");
    EXPECT_EQ(outcome.code, 0) << outcome.err;
}

TEST(Program, OutOfMemoryIsOneLineThatSaysWhatToLower) {
    const Outcome outcome = run_program(
        "--version >/dev/null; ulimit -v 600000; '" + foam::test::executable().string() +
        "' bake sea_foam -q --set foam.bubbles=24 --set loop.kind=none --frames 1 --size 16384 "
        "--threads 1 --out '{map}.####.png'");
    EXPECT_EQ(outcome.code, 1);
    EXPECT_TRUE(outcome.err.starts_with("foamtex: out of memory: ")) << outcome.err;
    EXPECT_NE(outcome.err.find("image.size"), std::string::npos) << outcome.err;
    EXPECT_EQ(std::ranges::count(outcome.err, '\n'), 1) << outcome.err;
}
#endif

}  // namespace
}  // namespace foam::texgen
