// SPDX-License-Identifier: Apache-2.0

#include "tests/texgen/cli/run_program.h"
#include "texgen/material/shipped_profiles.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

namespace foam::texgen {
namespace {

TEST(ProfilesCommand, ListsAllProfiles) {
    const Outcome listed = run_program("profiles");
    EXPECT_EQ(listed.code, 0) << listed.err;
    EXPECT_EQ(static_cast<std::size_t>(std::ranges::count(listed.out, '\n')),
              shipped_profiles().size());
    EXPECT_NE(listed.out.find("unreal"), std::string::npos);
    EXPECT_NE(run_program("profiles --json").out.find("\"profiles\":["), std::string::npos);
}

TEST(ProfilesCommand, PrintsAProfile) {
    EXPECT_EQ(run_program("profiles show godot").out, find_shipped_profile("godot").toml);
    expect_rejected("profiles show godt",
                    "profile 'godt': must be a .toml file or one of unreal, unity-hdrp, "
                    "unity-urp, godot, gltf, blender; did you mean 'godot'?");
}

// Options of the command line override the profile.
TEST(ProfilesCommand, AProfileSelectsTheFilesOfABake) {
    const std::string bake =
        "bake lava --set foam.bubbles=16 --frames 1 --size 16 --threads 1 --for gltf";
    EXPECT_EQ(
        run_program(bake).out,
        "out/lava_baseColor.0001.png\nout/lava_normal.0001.png\n"
        "out/lava_emissive.0001.png\nout/lava_occlusionRoughnessMetallic.0001.png\nout/lava.glb\n");
    EXPECT_EQ(run_program(bake + " --maps albedo --out 'a/{map}.png' --pack X=0,0,roughness").out,
              "a/baseColor.png\na/X.png\na/lava.glb\n");
    EXPECT_EQ(run_program(bake + " --set lit.glow=0 --set 'output.pack=[]'").out,
              "out/lava_baseColor.0001.png\nout/lava_normal.0001.png\nout/lava.glb\n");
}

// The frames are joined to array textures, whose names are those of the engine.
TEST(ProfilesCommand, AProfileJoinsTheFramesToArrays) {
    const Outcome outcome = run_program(
        "bake lava --set foam.bubbles=16 --set frames.count=2 --size 16 --threads 1 --for unreal");
    EXPECT_EQ(outcome.code, 0) << outcome.err;
    EXPECT_EQ(outcome.out,
              "out/frames/T_lava_BC.####.png 1-2\nout/frames/T_lava_N.####.png 1-2\n"
              "out/frames/T_lava_H.####.png 1-2\nout/frames/T_lava_E.####.png 1-2\n"
              "out/frames/T_lava_ORM.####.png 1-2\n"
              "out/T_lava_BC.dds\nout/T_lava_N.dds\nout/T_lava_H.dds\nout/T_lava_E.dds\n"
              "out/T_lava_ORM.dds\nout/T_lava.json\n");
    EXPECT_EQ(outcome.written.size(), 10U + 1U + 6U);
}

}  // namespace
}  // namespace foam::texgen
