// SPDX-License-Identifier: Apache-2.0

#include "texgen/cli/report.h"

#include "core/files/file_io.h"
#include "tests/support/temporary_folder.h"
#include "tests/texgen/cli/run_program.h"

#include <gtest/gtest.h>

#include <cstdint>
#include <filesystem>
#include <span>
#include <string>
#include <string_view>

namespace foam::texgen {
namespace {

std::string warning(std::uint64_t size, const std::filesystem::path& folder) {
    testing::internal::CaptureStderr();
    warn_of_full_disk(size, folder);
    return testing::internal::GetCapturedStderr();
}

TEST(Report, WarnsOfADiskThatIsTooSmall) {
    EXPECT_EQ(warning(0, "/"), "");
    EXPECT_EQ(warning(1, ""), "");
    constexpr std::uint64_t kHuge = 12'345'678'900'000'000;
    for (const char* const folder : {"", ".", "missing/folders/of/a/bake", "/missing"}) {
        const std::string text = warning(kHuge, folder);
        EXPECT_TRUE(text.starts_with("foamtex: warning: the files need about 12345678.9 GB, but "))
            << text;
        EXPECT_TRUE(text.ends_with("B left\n")) << text;
    }
}

// No bubble of the foam has 40 sides.
TEST(Report, WarnsOfEventsThatFindNoBubble) {
    const TemporaryFolder folder;
    const std::string preset = (folder.path() / "a.toml").string();
    constexpr std::string_view kToml =
        "[foam]\nbubbles = 12\n[loop]\nkind = \"none\"\n[frames]\ncount = 3\n[[event]]\n"
        "kind = \"collapse\"\nframe = 2\nsides = [6, 40]\ncount = 12\n[[event]]\n"
        "kind = \"drive\"\nframe = 2\nsides = 40\n";
    write_file(preset, std::as_bytes(std::span(kToml)));
    const std::string pictures = " --size 8 --maps id --out " + folder.path().string() + "/#.png";
    const Outcome all = run_program("bake " + preset + pictures);
    EXPECT_EQ(all.code, 0) << all.err;
    EXPECT_NE(all.err.find("foamtex: warning: event[1] (collapse) did not find "),
              std::string::npos)
        << all.err;
    EXPECT_NE(all.err.find("foamtex: warning: event[2] (drive) did not find 1 of 1 bubble\n"),
              std::string::npos)
        << all.err;
    const Outcome before = run_program("bake " + preset + " --frames 1" + pictures);
    EXPECT_EQ(before.err.find("warning"), std::string::npos) << before.err;
}

TEST(Report, WarnsOfEventsAfterTheLastFrame) {
    const TemporaryFolder folder;
    const std::string preset = (folder.path() / "a.toml").string();
    constexpr std::string_view kToml =
        "[foam]\nbubbles = 12\n[loop]\nkind = \"none\"\n[frames]\ncount = 2\n[[event]]\n"
        "kind = \"collapse\"\nframe = 3\nsides = 6\n[[event]]\nkind = \"drive\"\nframes = [2, 9]\n"
        "bubble = 1\nscale = 1.1\n";
    write_file(preset, std::as_bytes(std::span(kToml)));
    const std::string note =
        "foamtex: warning: events of 'a' never happen, because they begin after the last frame, 2: "
        "event[1] begins at frame 3; raise frames.count\n"
        "foamtex: warning: events of 'a' are cut off at the last frame, 2: event[2] ends at frame "
        "9; raise frames.count\n";
    for (const std::string command : {"bake", "stats", "preview", "simulate --cache cache"}) {
        const std::string run = command + " --threads 1 --size 16 " + preset;
        EXPECT_EQ(run_program(run, folder).err, note) << command;
        EXPECT_EQ(run_program(run + " -q", folder).err, "") << command;
    }
}

// The warning comes before the work, which fails here because the loop does not close.
TEST(Report, ABakeWarnsBeforeItBegins) {
    const std::string bake =
        "bake sea_foam --set foam.bubbles=60 --set loop.amplitude=0.8 --set loop.cycles=1 "
        "--set frames.count=6 --out 'a/{map}.#.png' ";
    const Outcome large = run_program(bake + "--frames 1-100000 --size 16384");
    EXPECT_EQ(large.code, 3) << large.err;
    EXPECT_TRUE(large.err.starts_with("foamtex: warning: the files need about ")) << large.err;
    EXPECT_NE(large.err.find(" GB, but the disk of 'a' has only "), std::string::npos);
    const Outcome quiet = run_program(bake + "--frames 1-100000 --size 16384 -q");
    EXPECT_EQ(quiet.err.find("warning"), std::string::npos) << quiet.err;
    const Outcome small = run_program(bake + "--frames 1 --size 16");
    EXPECT_EQ(small.err.find("warning"), std::string::npos) << small.err;
}

}  // namespace
}  // namespace foam::texgen
