// SPDX-License-Identifier: Apache-2.0

#include "texgen/bake/estimated_memory.h"

#include "tests/support/sanitizers.h"
#include "tests/support/temporary_folder.h"
#include "tests/support/test_files.h"

#include <gtest/gtest.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <string>
#include <vector>

namespace foam::texgen {
namespace {

// A bake and the arguments of the estimate that belongs to it.
struct Subject {
    const char* name;  // file name pattern
    std::vector<std::string> maps;
    int bubbles;
    int size;
    int frames;
    int threads;
    SheetKind sheets = SheetKind::None;
    double grain = 0.0;  // albedo.grain and relief.grain
    LoopKind loop = LoopKind::None;
};

Preset preset_of(const Subject& subject) {
    Preset preset;
    preset.image.maps = subject.maps;
    preset.seeding.bubbles = subject.bubbles;
    preset.image.width = preset.image.height = subject.size;
    preset.output.pattern = subject.name;
    preset.output.sheets = subject.sheets;
    preset.maps.albedo.grain = preset.maps.relief.grain = subject.grain;
    preset.loop.kind = subject.loop;
    return preset;
}

std::string joined(const std::vector<std::string>& maps) {
    std::string list;
    for (const std::string& map : maps) {
        list += (list.empty() ? "" : ",") + map;
    }
    return list;
}

// Returns the peak memory, in bytes, of a process that runs the bake.
double measured_memory(const Subject& subject) {
    const TemporaryFolder folder;
    std::vector<std::string> arguments{
        "foamtex",
        "bake",
        "sea_foam",
        "-q",
        "--set",
        std::string("loop.kind=") + (subject.loop == LoopKind::Flow ? "flow" : "none"),
        "--set",
        "loop.current=0",
        "--set",
        "frames.count=" + std::to_string(subject.frames),
        "--set",
        "frames.warm_up=0",
        "--set",
        "foam.bubbles=" + std::to_string(subject.bubbles),
        "--frames",
        "1-" + std::to_string(subject.frames),
        "--size",
        std::to_string(subject.size),
        "--maps",
        joined(subject.maps),
        "--threads",
        std::to_string(subject.threads),
        "--set",
        std::string("output.sheets=") + (subject.sheets == SheetKind::None ? "none" : "ktx2"),
        "--set",
        "albedo.grain=" + std::to_string(subject.grain),
        "--set",
        "relief.grain=" + std::to_string(subject.grain),
        "--set",
        "output.sheet_pattern=" + (folder.path() / "{map}").string(),
        "--out",
        (folder.path() / subject.name).string()};
    std::vector<char*> pointers;
    for (std::string& argument : arguments) {
        pointers.push_back(argument.data());
    }
    pointers.push_back(nullptr);
    const std::string program = foam::test::executable().string();
    const pid_t child = fork();
    if (child == 0) {
        execv(program.c_str(), pointers.data());
        _exit(127);
    }
    int status = 0;
    rusage usage{};
    EXPECT_EQ(wait4(child, &status, 0, &usage), child);
    EXPECT_EQ(status, 0);
    return 1024.0 * static_cast<double>(usage.ru_maxrss);
}

// Frames that threads draw at the same time do not always reach their peaks together. The estimate
// is for the case that they do, which the largest of several bakes comes near.
double largest_memory(const Subject& subject) {
    double largest = 0.0;
    for (int bake = 0; bake < (subject.threads > 1 ? 3 : 1); ++bake) {
        largest = std::max(largest, measured_memory(subject));
    }
    return largest;
}

TEST(EstimatedMemory, IsRightWithinAFactorOfOneAndAHalf) {
    if (foam::test::kMayHaveSanitizers) {
        GTEST_SKIP() << "sanitizers need memory of their own";
    }
    const std::vector<Subject> subjects{
        {"{map}.#.png", {"albedo"}, 100, 1024, 1, 1},
        {"{map}.#.png", {"lit"}, 100, 512, 4, 2},
        {"{map}.#.png", {"lit"}, 100, 1024, 1, 1, SheetKind::None, 0.05},
        {"{map}.#.png", {"id", "film", "normal"}, 100, 1024, 4, 4},
        {"{map}.#.exr", {"height", "distance"}, 100, 1024, 1, 1},
        {"all.#.exr", {"albedo", "height", "id", "normal"}, 100, 1024, 2, 2},
        {"all.#.exr", {"height", "distance", "curvature", "normal"}, 100, 1024, 1, 1},
        {"{map}.#.png", {"albedo"}, 10000, 64, 1, 1},
        {"relief.#.stl", {"albedo"}, 100, 1024, 1, 1},
        {"relief.#.glb", {"albedo"}, 100, 1024, 2, 2},
        {"walls.#.stl", {"maze"}, 2000, 64, 1, 1},
        {"walls.#.glb", {"maze"}, 2000, 64, 1, 1},
        {"{map}.#.png", {"albedo", "height"}, 100, 512, 32, 2, SheetKind::Ktx2},
        {"{map}.#.png", {"height"}, 100, 1024, 6, 1, SheetKind::None, 0.0, LoopKind::Flow},
        {"{map}.#.png", {"lit"}, 100, 1024, 6, 1, SheetKind::None, 0.0, LoopKind::Flow}};
    for (const Subject& subject : subjects) {
        const auto estimated = static_cast<double>(estimated_memory(
            preset_of(subject), static_cast<std::size_t>(subject.frames), subject.threads));
        const double ratio = estimated / largest_memory(subject);
        const std::string what = joined(subject.maps) + " " + subject.name;
        EXPECT_GT(ratio, 1.0 / 1.5) << what;
        EXPECT_LT(ratio, 1.5) << what;
    }
}

// A float in a file takes 2 bytes more than a half float; `height` has one channel, and `normal`
// has three.
TEST(EstimatedMemory, LayersOfFloatsNeedMoreThanHalfFloats) {
    Preset preset = preset_of({"all.#.exr", {"height", "normal"}, 100, 1024, 1, 1});
    const std::uint64_t floats = estimated_memory(preset, 1, 1);
    preset.output.exr_numbers = SampleType::Half;
    EXPECT_EQ(floats - estimated_memory(preset, 1, 1), 4U * 2U * 1024U * 1024U);
}

// An array of BC4 blocks has half a byte per pixel, and a third more for its mip levels. The array
// and its file are in memory; a KTX2 file twice. A sheet has the samples of the frames.
TEST(EstimatedMemory, IncludesSheets) {
    Preset preset = preset_of({"{map}.#.png", {"film"}, 100, 768, 1, 1});
    const auto added = [&](SheetKind sheets) {
        preset.output.sheets = SheetKind::None;
        const std::uint64_t without = estimated_memory(preset, 6, 1);
        preset.output.sheets = sheets;
        return estimated_memory(preset, 6, 1) - without;
    };
    const std::uint64_t pixels = 6U * 768U * 768U;
    EXPECT_EQ(added(SheetKind::Dds), pixels * 4 / 3);
    EXPECT_EQ(added(SheetKind::Ktx2), pixels * 2);
    EXPECT_EQ(added(SheetKind::Strip), pixels * 2);
    preset.image.width = 767;
    EXPECT_EQ(added(SheetKind::Dds), 6U * 768U * 767U * 8 / 3);
}

TEST(EstimatedMemory, GrowsWithFramesUpToTheThreads) {
    const Subject one{"{map}.#.png", {"lit"}, 100, 4096, 1, 8};
    const auto of = [&](std::size_t frames, int threads) {
        return static_cast<double>(estimated_memory(preset_of(one), frames, threads));
    };
    EXPECT_NEAR(of(8, 8) / of(1, 8), 8.0, 0.1);
    EXPECT_EQ(of(8, 8), of(100, 8));
    EXPECT_EQ(of(100, 1), of(1, 8));
}

}  // namespace
}  // namespace foam::texgen
