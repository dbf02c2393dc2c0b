// SPDX-License-Identifier: Apache-2.0

#include "tests/support/temporary_folder.h"
#include "tests/texgen/cli/run_program.h"
#include "texgen/image/png.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <string>

namespace foam::texgen {
namespace {

const char* const kSmall = "simulate sea_foam --set foam.bubbles=16 --frames 1-2 --size 16 ";

TEST(SimulateCommand, FillsACache) {
    const Outcome outcome = run_program(std::string(kSmall) + "--cache foam");
    EXPECT_EQ(outcome.code, 0) << outcome.err;
    EXPECT_EQ(outcome.out, "foam\n");
    for (const char* const name : {"foam/cache.json", "foam/state.000001.foam"}) {
        EXPECT_EQ(std::ranges::count(outcome.written, name), 1) << name;
    }
    EXPECT_EQ(run_program(std::string(kSmall) + "--cache foam -q").out, "");
}

TEST(SimulateCommand, ReplacesTheCacheOfAnotherFoamOnlyIfForced) {
    const TemporaryFolder folder;
    const std::string cache = "--cache '" + (folder.path() / "foam").string() + "' -q ";
    EXPECT_EQ(run_program(kSmall + cache).code, 0);
    EXPECT_EQ(run_program(kSmall + cache).code, 0);  // the same foam again
    EXPECT_EQ(run_program(kSmall + cache + "--set albedo.film_width=2").code, 0);
    const Outcome other = run_program(kSmall + cache + "--seed 5");
    EXPECT_EQ(other.code, 2);
    EXPECT_NE(other.err.find("contains a different foam of the preset sea_foam: "),
              std::string::npos);
    EXPECT_NE(other.err.find("foam.seed"), std::string::npos) << other.err;
    EXPECT_EQ(run_program(kSmall + cache + "--seed 5 --force").code, 0);
}

TEST(SimulateCommand, SaysThatAPictureHasChanged) {
    const TemporaryFolder folder;
    const std::string command = std::string(kSmall) + "--set foam.density=x.png --cache foam -q";
    Image<std::uint8_t> picture(2, 2, 1);
    write_png(folder.path() / "x.png", picture.view());
    EXPECT_EQ(run_program(command, folder).code, 0);
    picture.pixel(1, 0)[0] = 200;
    write_png(folder.path() / "x.png", picture.view());
    const Outcome changed = run_program(command, folder);
    EXPECT_EQ(changed.code, 2);
    EXPECT_EQ(changed.err,
              "foamtex: the cache 'foam' contains a different foam of the preset sea_foam: the "
              "file that foam.density or foam.outline names has changed; --force replaces this "
              "cache\n");
}

// `simulate` writes no images: `render --out` may replace the pattern later.
TEST(SimulateCommand, AMalformedPatternOfImagesIsNoError) {
    const TemporaryFolder folder;
    const std::string images = "--set image.maps=height --set output.pattern=";
    const Outcome outcome = run_program(kSmall + images + "x.foo --cache foam", folder);
    EXPECT_EQ(outcome.code, 0) << outcome.err;
    const Outcome drawn = run_program("render foam --out '{map}.####.png' -q", folder);
    EXPECT_EQ(drawn.code, 0) << drawn.err;
}

TEST(SimulateCommand, FindsAnOutputThatCannotBeWrittenBeforeItSimulates) {
    const Outcome outcome = run_program(std::string(kSmall) + "--cache /dev/null/foam");
    EXPECT_EQ(outcome.code, 5);
    EXPECT_EQ(outcome.err, "foamtex: cannot write into '/dev/null': Not a directory\n");
}

TEST(SimulateCommand, NeedsAFolder) {
    expect_rejected(kSmall, "--cache is required (see foamtex simulate --help)");
}

}  // namespace
}  // namespace foam::texgen
