// SPDX-License-Identifier: Apache-2.0

#include "tests/support/test_files.h"
#include "tests/texgen/cli/run_program.h"
#include "texgen/image/external_program.h"
#include "texgen/maps/map.h"
#include "texgen/preset/preset_keys.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <string>
#include <vector>

namespace foam::texgen {
namespace {

TEST(RunArguments, ABadPresetIsOneLineAndCode2) {
    expect_rejected("bake none.toml", "cannot read 'none.toml': No such file or directory");
    expect_rejected(
        "bake marzipan",
        "preset 'marzipan': must be a .toml file or a name; 'foamtex presets' lists all presets");
    expect_rejected("bake sea_foam --set foam.bubbles=-3",
                    "--set foam.bubbles=-3: key 'foam.bubbles' = -3: "
                    "must be an integer from 4 to 1000000");
    expect_rejected("bake sea_foam --set foam.bubbles",
                    "--set foam.bubbles: must be KEY=VALUE, as in --set foam.bubbles=500");
}

TEST(RunArguments, ABadOptionIsOneLineAndCode2) {
    expect_rejected("bake sea_foam --size 0x4",
                    "--size 0x4: key 'image.size' = [0, 4]: "
                    "must be [width, height], each an integer from 1 to 16384");
    expect_rejected("bake sea_foam --seed -1",
                    "--seed -1: key 'foam.seed' = -1: "
                    "must be an integer from 0 to 9223372036854775807");
    expect_rejected("bake sea_foam --maps albedo,beer",
                    "--maps albedo,beer: key 'image.maps' = [\"albedo\", \"beer\"]: must be " +
                        find_key("image.maps")->allowed);
    expect_rejected("bake sea_foam --frames 3-",
                    "frame range '3-': must be a list of ranges such as 5, 1-10, 1-10x2 or 1-10y3, "
                    "separated by commas");
    expect_rejected("bake sea_foam --out a.png",
                    "file name pattern 'a.png': must contain a frame number (####, @@@@ or %04d) "
                    "for 48 frames");
}

// The frame itself is not baked, because the file name of the images is rejected.
TEST(RunArguments, AKeyWithoutEffectIsNoted) {
    const std::string note = "foamtex: note: relief.angle has no effect with relief.profile = ";
    const std::string bake = "bake sea_foam --out a.png --set relief.angle=";
    EXPECT_EQ(run_program(bake + "30").err.find(note + "\"wet\"\n"), 0U);
    EXPECT_EQ(run_program(bake + "30 -q").err.find(note), std::string::npos);
    EXPECT_EQ(run_program(bake + "30 --set relief.profile=dome").err.find(note), std::string::npos);
}

TEST(RunArguments, TheOptionForNormalsIsNotedWithoutNormals) {
    const std::string bake =
        "bake sea_foam --set foam.bubbles=16 --set loop.kind=none --frames 1 --size 8 --out "
        "'{map}.png' --normal-y dx --maps ";
    EXPECT_EQ(run_program(bake + "id,normal_gl").err,
              "foamtex: note: --normal-y has no effect, because the map normal is not drawn\n");
    EXPECT_EQ(run_program(bake + "id,normal").err, "");
    EXPECT_EQ(run_program(bake + "id -q").err, "");
}

}  // namespace
}  // namespace foam::texgen
