// SPDX-License-Identifier: Apache-2.0

#include "texgen/cli/image_folder.h"

#include "tests/texgen/cli/run_program.h"

#include <fmt/core.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <string>

namespace foam::texgen {
namespace {

std::string bake(const TemporaryFolder& folder, const std::string& options) {
    const Outcome outcome = run_program(
        "bake sea_foam --threads 1 --set foam.bubbles=12 --set loop.kind=none --maps albedo " +
            options,
        folder);
    EXPECT_EQ(outcome.code, 0) << outcome.err;
    return outcome.err;
}

TEST(ImageFolder, ReadsSizesAndSeeds) {
    const SetChoice choice = choice_of({"lava", "512", "7"});
    EXPECT_EQ(choice.preset, "lava");
    EXPECT_EQ(choice.width, 512);
    EXPECT_EQ(choice.height, std::nullopt);
    EXPECT_EQ(choice.seed, 7U);
    EXPECT_EQ(choice_of({"", "64x32", {}}).height, 32);
    for (const char* const size : {"", "x", "64x", "x64", "64 x 32", "big"}) {
        EXPECT_THROW(choice_of({"", size, {}}), std::invalid_argument) << size;
    }
    EXPECT_THROW(choice_of({"", {}, "-1"}), std::invalid_argument);
}

TEST(ImageFolder, ABakeThatReplacesImagesOfAnotherWarns) {
    const TemporaryFolder folder;
    EXPECT_EQ(bake(folder, "--size 64 --frames 1-2"), "");
    EXPECT_EQ(bake(folder, "--size 64 --frames 1-3"), "");  // the same bake goes on
    EXPECT_EQ(bake(folder, "--size 48 --frames 1"),
              "foamtex: warning: this replaces 1 image of another bake, sea_foam (seed 1, 64 x "
              "64); to keep both, give this bake a folder of its own, such as --out "
              "'{preset}_{size}_{seed}/{map}.####.png'\n");
    EXPECT_EQ(bake(folder, "--size 32 --frames 1 -q"), "");
}

TEST(ImageFolder, TheNewestImagesAreUsedUnlessOthersAreChosen) {
    const TemporaryFolder folder;
    bake(folder, "--size 64 --frames 1-3");
    bake(folder, "--size 48 --frames 1-2 -q");
    const Outcome newest = run_program("flipbook out", folder);
    EXPECT_EQ(newest.code, 0);
    EXPECT_EQ(newest.err,
              "foamtex: note: 'out' has images of several bakes; the newest images, sea_foam (seed "
              "1, 48 x 48), are used; --preset, --size or --seed choose older images: sea_foam "
              "(seed 1, 64 x 64)\n");
    const Outcome older = run_program("preview out --size 64 --frames 3 --as tiling", folder);
    EXPECT_EQ(older.code, 0) << older.err;
    EXPECT_EQ(older.err, "");
    const Outcome none = run_program("flipbook out --size 64x48", folder);
    EXPECT_EQ(none.code, static_cast<int>(ExitCode::BadInput));
    EXPECT_NE(none.err.find("no images of width 64, height 48; it has images of: "),
              std::string::npos);
}

TEST(ImageFolder, VerifyChecksTheNewestImagesUnlessOthersAreChosen) {
    const TemporaryFolder folder;
    bake(folder, "--size 64 --frames 1-3");
    bake(folder, "--size 48 --frames 1-2 -q");
    const Outcome newest = run_program("verify out", folder);
    EXPECT_EQ(newest.code, 0) << newest.out;
    EXPECT_NE(newest.out.find("newer images of the same preset: sea_foam (seed 1, 64 x 64); --all"),
              std::string::npos)
        << newest.out;
    const int failed = static_cast<int>(ExitCode::CheckFailed);
    EXPECT_EQ(run_program("verify out --all", folder).code, failed);
    const Outcome older = run_program("verify out --size 64 --json", folder);
    EXPECT_EQ(older.code, failed);
    const auto report = nlohmann::json::parse(older.out);
    EXPECT_EQ(report["sets"].size(), 1U);
    EXPECT_EQ(report["unchecked"].size(), 0U);
}

// Profiles such as `unreal` put the frames and their manifest into a subfolder.
TEST(ImageFolder, ASubfolderWithAManifestIsSuggested) {
    const TemporaryFolder folder;
    bake(folder, "--size 8 --frames 1 --out 'out/b/{map}.#.png'");
    bake(folder, "--size 8 --frames 1 --out 'out/a/{map}.#.png'");
    EXPECT_EQ(run_program("verify out", folder).err,
              "foamtex: 'out' has no manifest.json: foamtex has baked no images into this folder; "
              "did you mean 'out/a'?\n");
}

TEST(ImageFolder, WrongFoldersGetAHint) {
    const TemporaryFolder folder;
    ASSERT_EQ(run_program("simulate sea_foam -q --cache foam --frames 1 --size 64 --set "
                          "foam.bubbles=12 --set loop.kind=none",
                          folder)
                  .code,
              0);
    for (const std::string command : {"flipbook", "preview", "verify"}) {
        const Outcome cache = run_program(command + " foam", folder);
        EXPECT_EQ(cache.code, static_cast<int>(ExitCode::BadInput));
        EXPECT_EQ(cache.err,
                  "foamtex: 'foam' has simulated states, but no images; 'foamtex render foam' "
                  "draws images of them into the folder 'out'\n");
        EXPECT_EQ(run_program(command + " .", folder).err,
                  "foamtex: '.' has no manifest.json: foamtex has baked no images into this "
                  "folder\n");
    }
    for (const std::string command : {"bake foam", "simulate foam --cache other"}) {
        const Outcome cache = run_program(command, folder);
        EXPECT_EQ(cache.code, static_cast<int>(ExitCode::BadRequest));
        EXPECT_EQ(cache.err,
                  "foamtex: 'foam' has simulated states, but is not a preset; 'foamtex render "
                  "foam' draws images of them, and 'foamtex stats foam' measures them\n");
    }
    EXPECT_EQ(run_program("flipbook lava", folder).err,
              "foamtex: 'lava' is a preset, not a folder of images; 'foamtex bake lava' draws its "
              "images into the folder 'out'\n");
    EXPECT_EQ(run_program("render .", folder).err,
              "foamtex: '.' has no cache.json: it is not a folder of simulated states\n");
    EXPECT_EQ(run_program("render lava", folder).err,
              "foamtex: 'lava' is a preset, not a folder of simulated states; 'foamtex simulate "
              "lava --cache FOLDER' makes one, and 'foamtex bake lava' draws the preset\n");
}

}  // namespace
}  // namespace foam::texgen
