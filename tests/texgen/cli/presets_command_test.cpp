// SPDX-License-Identifier: Apache-2.0

#include "tests/support/test_files.h"
#include "tests/texgen/cli/run_program.h"
#include "texgen/json/json_writer.h"
#include "texgen/preset/preset_schema.h"
#include "texgen/preset/shipped_presets.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <string>
#include <vector>

namespace foam::texgen {
namespace {

TEST(PresetsCommand, APresetThatIsShownCanBeBaked) {
    const Outcome outcome =
        run_program("presets show labyrinth > mine.toml && '" + foam::test::executable().string() +
                    "' bake mine.toml --set foam.bubbles=16 --frames 1 --size 8 --out a.png");
    EXPECT_EQ(outcome.code, 0) << outcome.err;
    EXPECT_EQ(outcome.written, (std::vector<std::string>{"a.png", "manifest.json", "mine.toml"}));
}

TEST(PresetsCommand, ListsPresetsAndKeys) {
    const std::string list = run_program("presets").out;
    EXPECT_EQ(list.find("sea_foam    "), 0U);
    EXPECT_EQ(run_program("presets list").out, list);
    EXPECT_NE(run_program("presets keys").out.find("\nbubbles = 1000\n"), std::string::npos);
}

TEST(PresetsCommand, PrintsOneTableOfKeys) {
    const Outcome loop = run_program("presets keys loop");
    EXPECT_EQ(loop.out.rfind("[loop]\n", 0), 0U);
    EXPECT_EQ(loop.out.find("[image]"), std::string::npos);
    EXPECT_EQ(run_program("presets keys event").out.rfind("[[event]]\n", 0), 0U);
    expect_rejected("presets keys lop", "unknown table [lop]; did you mean [loop]?");
}

TEST(PresetsCommand, HelpHasItsOwnExamples) {
    for (const char* arguments : {"presets", "presets list", "presets keys", "presets show"}) {
        const std::string help = run_program(std::string(arguments) + " --help").out;
        EXPECT_EQ(help.find("foamtex bake sea_foam"), std::string::npos) << help;
        EXPECT_EQ(help.find("TEXT"), std::string::npos) << help;  // CLI11 names types of values so
    }
    EXPECT_NE(run_program("presets --help").out.find("foamtex presets keys foam"),
              std::string::npos);
    EXPECT_NE(run_program("presets keys --help").out.find("foamtex presets keys event"),
              std::string::npos);
}

TEST(PresetsCommand, PrintsJson) {
    const Json presets = Json::parse(run_program("presets --json").out);
    EXPECT_EQ(presets["status"], "complete");
    EXPECT_EQ(presets["presets"][0]["name"], "sea_foam");
    EXPECT_EQ(presets["presets"].size(), shipped_presets().size());
    EXPECT_EQ(run_program("presets list --json").out, run_program("presets --json").out);
    EXPECT_EQ(run_program("presets keys --json-schema").out, preset_schema());
}

}  // namespace
}  // namespace foam::texgen
