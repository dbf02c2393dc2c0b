// SPDX-License-Identifier: Apache-2.0

#include "tests/support/places.h"
#include "tests/texgen/cli/run_program.h"
#include "texgen/image/external_program.h"
#include "texgen/maps/all_maps.h"
#include "texgen/preset/preset_keys.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
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

TEST(Program, ABadCommandLineIsOneLineAndCode2) {
    expect_rejected("", "A subcommand is required (see foamtex --help)");
    expect_rejected("bake", "PRESET is required (see foamtex --help)");
    expect_rejected("bake sea_foam --bogus",
                    "The following argument was not expected: --bogus (see foamtex --help)");
    expect_rejected("bake sea_foam --threads -1",
                    "--threads: Value -1 not in range 0 to 1024 (see foamtex --help)");
    expect_rejected("bake sea_foam -q -v", "--quiet excludes --verbose (see foamtex --help)");
}

TEST(Program, AnUnknownCommandIsComparedWithThoseThatExist) {
    expect_rejected("bak sea_foam",
                    "foamtex has no command 'bak'; did you mean 'bake'? (see foamtex --help)");
    expect_rejected("presets keyz",
                    "presets has no command 'keyz'; did you mean 'keys'? (see foamtex --help)");
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

}  // namespace
}  // namespace foam::texgen
