// SPDX-License-Identifier: Apache-2.0

#include "tests/support/test_files.h"
#include "tests/texgen/cli/run_program.h"
#include "tests/texgen/pictures.h"
#include "texgen/image/png.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <string>

namespace foam::texgen {
namespace {

constexpr const char* kSmall =
    "--threads 1 --size 48x32 --frames 1-3 --set foam.bubbles=12 --set loop.kind=none";

bool has_ffmpeg() {
    return std::system("command -v ffmpeg ffprobe >/dev/null") == 0;
}

/// Returns the text that ffprobe prints about a file of the folder `out`: the given entries,
/// separated by commas.
std::string probed(const std::string& file,
                   const std::string& entries,
                   const TemporaryFolder& folder) {
    const std::string command =
        "cd " + folder.path().string() +
        "/out && ffprobe -v error -count_frames -show_entries stream=" + entries + " -of csv=p=0 " +
        file + " >../said";
    EXPECT_EQ(std::system(command.c_str()), 0);
    return file_content(folder.path() / "said");
}

TEST(PreviewCommand, ShowsAPresetAndLeavesNoOtherFiles) {
    const TemporaryFolder folder;
    const Outcome outcome = run_program(std::string("preview sea_foam ") + kSmall, folder);
    EXPECT_EQ(outcome.code, 0) << outcome.err;
    EXPECT_EQ(outcome.out,
              "out/sea_foam_lit_contact.png\nout/sea_foam_lit_loop.png\n"
              "out/sea_foam_lit_tiling.png\n");
    EXPECT_EQ(outcome.written.size(), 3U);
}

TEST(PreviewCommand, ShowsAFolder) {
    const TemporaryFolder folder;
    ASSERT_EQ(run_program(std::string("bake sea_foam -q ") + kSmall, folder).code, 0);
    const Outcome outcome =
        run_program("preview out --as loop --width 24 --frames 2,1 -o shown -q", folder);
    EXPECT_EQ(outcome.code, 0) << outcome.err;
    EXPECT_EQ(outcome.out, "");
    EXPECT_EQ(codes8(read_picture(folder.path() / "shown" / "sea_foam_lit_loop.png")).width(), 24);
}

TEST(PreviewCommand, ABadRequestIsOneLine) {
    const TemporaryFolder folder;
    ASSERT_EQ(run_program(std::string("bake sea_foam -q ") + kSmall, folder).code, 0);
    const Outcome set = run_program("preview out --set foam.seed=3", folder);
    EXPECT_EQ(set.code, static_cast<int>(ExitCode::BadRequest));
    EXPECT_EQ(set.err, "foamtex: --set is only allowed with a preset, not with a folder\n");
    const Outcome preset = run_program("preview sea_foam --preset lava", folder);
    EXPECT_EQ(preset.code, static_cast<int>(ExitCode::BadRequest));
    EXPECT_EQ(preset.err,
              "foamtex: --preset is only allowed with a folder, but 'sea_foam' is not a folder\n");
    const Outcome seed = run_program("preview out --seed 3", folder);
    EXPECT_EQ(seed.code, static_cast<int>(ExitCode::BadInput));
    EXPECT_EQ(
        seed.err,
        "foamtex: 'out/manifest.json' has no images of seed 3; it has images of: sea_foam (seed "
        "1, 48 x 32)\n");
    EXPECT_EQ(run_program("preview out --as film", folder).code,
              static_cast<int>(ExitCode::BadRequest));
    EXPECT_EQ(run_program("preview beer", folder).code, static_cast<int>(ExitCode::BadRequest));
    EXPECT_EQ(run_program("preview .", folder).code, static_cast<int>(ExitCode::BadInput));
}

// The preset alone shows that each of these previews is impossible. A bake of all of the frames
// would take hours, and that of a million bubbles minutes even for one frame.
TEST(PreviewCommand, AnImpossiblePreviewIsReportedBeforeTheSimulation) {
    const std::string frames =
        " --set foam.bubbles=1000000 --set loop.kind=none --frames 20-100000 ";
    for (const char* const arguments :
         {"soap_raft --as contact,tiling", "shear --as tiling", "sea_foam --maps id --size 8"}) {
        const Outcome outcome = run_program("preview " + std::string(arguments) + frames);
        EXPECT_EQ(outcome.code, 2) << outcome.err;
        EXPECT_TRUE(outcome.written.empty());
    }
}

// The last frame of the preset `shear` is sheared by a whole width, in steps that are rounded.
TEST(PreviewCommand, AFoamThatIsShearedByAWholeWidthTiles) {
    const TemporaryFolder folder;
    const std::string eight = "--set frames.count=8 --set 'event[1].frames=[2, 8]' --size 64 ";
    const std::string small = "preview shear --set foam.bubbles=40 --as tiling -q " + eight;
    EXPECT_EQ(run_program(small + "--frames 8", folder).code, 0);
    EXPECT_EQ(run_program(small + "--frames 7", folder).code, 2);
}

// This PATH hides ffmpeg even if it is installed.
TEST(PreviewCommand, ReportsMissingFfmpeg) {
    const TemporaryFolder folder;
    const std::string command = "cd " + folder.path().string() + " && PATH=. '" +
                                test::executable().string() + "' preview sea_foam --as mp4 2>err";
    const int status = std::system(command.c_str());
    EXPECT_EQ(WEXITSTATUS(status), static_cast<int>(ExitCode::OutputFailed));
    EXPECT_EQ(file_content(folder.path() / "err"),
              "foamtex: cannot write MP4 or GIF: the program 'ffmpeg' was not found in PATH; "
              "install ffmpeg or use --as loop\n");
}

// A program of this name that reports an error and fails.
TEST(PreviewCommand, ReportsTheErrorsOfFfmpeg) {
    const TemporaryFolder folder;
    const std::filesystem::path ffmpeg = folder.path() / "ffmpeg";
    std::ofstream(ffmpeg) << "#!/bin/sh\necho 'no codec for you' >&2\nexit 3\n";
    std::filesystem::permissions(ffmpeg, std::filesystem::perms::owner_all);
    const std::string command = "cd " + folder.path().string() + " && PATH=. '" +
                                test::executable().string() + "' preview sea_foam --as mp4 2>err";
    const int status = std::system(command.c_str());
    EXPECT_EQ(WEXITSTATUS(status), static_cast<int>(ExitCode::OutputFailed));
    EXPECT_EQ(file_content(folder.path() / "err"),
              "foamtex: ffmpeg failed with exit code 3: no codec for you\n");
}

TEST(PreviewCommand, MakesVideos) {
    if (!has_ffmpeg()) {
        GTEST_SKIP() << "there is no ffmpeg";
    }
    const TemporaryFolder folder;
    const std::string arguments = std::string("preview sea_foam --as mp4,gif ") + kSmall;
    const Outcome outcome = run_program(arguments + " --width 33", folder);
    EXPECT_EQ(outcome.code, 0) << outcome.err;
    EXPECT_EQ(probed("sea_foam_lit.mp4", "width,height,r_frame_rate,nb_read_frames", folder),
              "32,22,24/1,3\n");
    EXPECT_EQ(probed("sea_foam_lit.gif", "width,height,nb_read_frames", folder), "33,22,3\n");
}

// ffmpeg decodes every frame of the animation to the same samples as the frame's own PNG.
TEST(PreviewCommand, FfmpegReadsOurAnimation) {
    if (!has_ffmpeg()) {
        GTEST_SKIP() << "there is no ffmpeg";
    }
    const TemporaryFolder folder;
    ASSERT_EQ(run_program(std::string("bake sea_foam -q ") + kSmall, folder).code, 0);
    ASSERT_EQ(run_program("preview out --as loop", folder).code, 0);
    const std::string split = "cd " + folder.path().string() +
                              "/out && ffmpeg -v error -i sea_foam_lit_loop.png "
                              "-vsync passthrough %d.png";
    ASSERT_EQ(std::system(split.c_str()), 0);
    for (const std::string number : {"1", "2", "3"}) {
        EXPECT_EQ(
            codes8(read_picture(folder.path() / "out" / (number + ".png"))),
            codes8(read_picture(folder.path() / "out" / ("sea_foam_lit.000" + number + ".png"))));
    }
}

}  // namespace
}  // namespace foam::texgen
