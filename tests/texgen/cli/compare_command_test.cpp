// SPDX-License-Identifier: Apache-2.0

#include "core/files/file_io.h"
#include "tests/texgen/cli/run_program.h"
#include "tests/texgen/pictures.h"
#include "texgen/image/png.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cstdint>
#include <filesystem>
#include <span>
#include <string>
#include <vector>

namespace foam::texgen {
namespace {

/// Writes a gray PNG of `width` x 2 pixels. All pixels have the value `value` except the first one,
/// which has `first`.
void write_gray(const std::filesystem::path& path, int width, int value, int first) {
    Image<std::uint8_t> image(width, 2, 1);
    std::ranges::fill(image.samples(), static_cast<std::uint8_t>(value));
    image.samples()[0] = static_cast<std::uint8_t>(first);
    write_png(path, image.view());
}

class CompareCommand : public testing::Test {
  protected:
    CompareCommand() {
        write_gray(folder_.path() / "a.0001.png", 4, 100, 100);
        write_gray(folder_.path() / "a.0002.png", 4, 100, 100);
        write_gray(folder_.path() / "b.0001.png", 4, 100, 100);
        write_gray(folder_.path() / "b.0002.png", 4, 100, 151);  // differs by 0.2 of the range
        write_gray(folder_.path() / "wide.png", 5, 100, 100);
        write_file(folder_.path() / "torn.png", Bytes(10));
    }

    Outcome compare(const std::string& arguments) {
        return run_program("compare " + arguments, folder_);
    }

    TemporaryFolder folder_;
};

TEST_F(CompareCommand, ExitCodesAreThoseOfIdiff) {
    EXPECT_EQ(compare("a.0001.png b.0001.png").code, 0);
    EXPECT_EQ(compare("a.0002.png b.0002.png --warn 0.1 --fail 0.3").code, 1);
    EXPECT_EQ(compare("a.0002.png b.0002.png").code, 2);
    EXPECT_EQ(compare("a.0002.png b.0002.png --warn 0.3 --fail 0.3").code, 0);
    EXPECT_EQ(compare("a.0001.png wide.png").code, 3);
    EXPECT_EQ(compare("a.0001.png torn.png").code, 4);
    EXPECT_EQ(compare("a.0001.png none.png").code, 4);
}

#if !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__) && !defined(__clang__)
// The exit code 1, which other commands return if there is too little memory, is a verdict of
// `compare`. Two images of 67 million pixels do not fit into the address space.
TEST_F(CompareCommand, TooLittleMemoryHasItsOwnExitCode) {
    Image<std::uint8_t> large(8192, 8192, 1);
    write_png(folder_.path() / "large.png", large.view());
    const Outcome outcome =
        run_program("--version >/dev/null; ulimit -v 250000; '" +
                        foam::test::executable().string() + "' compare large.png large.png",
                    folder_);
    EXPECT_EQ(outcome.code, static_cast<int>(ExitCode::CompareInternalFailure)) << outcome.err;
    EXPECT_TRUE(outcome.err.starts_with("foamtex: out of memory: ")) << outcome.err;
    EXPECT_EQ(std::ranges::count(outcome.err, '\n'), 1) << outcome.err;
}
#endif

TEST_F(CompareCommand, PrintsTheDifferenceOnOneLine) {
    EXPECT_EQ(
        compare("a.0002.png b.0002.png").out,
        "b.0002.png: failure (1 of 8 pixels above 1e-06), largest difference 0.2 in Y at 0,1, "
        "mean 0.025, rms 0.0707, percentile 99.9 = 0.2\n");
    EXPECT_EQ(compare("a.0001.png b.0001.png").out, "b.0001.png: same\n");
    EXPECT_EQ(compare("a.0001.png wide.png").out, "wide.png: different size or channels\n");
    EXPECT_EQ(compare("-q a.0002.png b.0002.png").out, "");
    const Outcome torn = compare("a.0001.png torn.png");
    EXPECT_EQ(torn.err, "foamtex: cannot read 'torn.png': malformed PNG: Not a PNG file\n");
}

TEST_F(CompareCommand, TheWorstFrameDecides) {
    EXPECT_EQ(compare("'a.####.png' 'b.####.png' --frames 1").code, 0);
    const Outcome both = compare("'a.####.png' 'b.####.png' --frames 1-2");
    EXPECT_EQ(both.code, 2);
    EXPECT_EQ(both.out.rfind("b.0001.png: same\nb.0002.png: failure", 0), 0U) << both.out;
    EXPECT_EQ(compare("'a.####.png' 'b.####.png' --frames 1-3").code, 4);
}

TEST_F(CompareCommand, APatternMeansAllFramesOfBothSides) {
    write_gray(folder_.path() / "a.0003.png", 4, 100, 100);
    const Outcome all = compare("'a.####.png' 'b.####.png' --fail 0.5 --warn 0.5");
    EXPECT_EQ(all.code, 2);
    EXPECT_NE(all.out.find("b.0003.png: missing, but 'a.0003.png' exists\n"), std::string::npos)
        << all.out;
    EXPECT_NE(all.out.find("frames 3 exist only in A\n3 images: 2 same, 1 missing\n"),
              std::string::npos)
        << all.out;
    EXPECT_EQ(compare("'x.####.png' 'y.####.png'").code, 4);
}

TEST_F(CompareCommand, AnUnreadableImageDoesNotEndTheComparison) {
    write_file(folder_.path() / "b.0001.png", Bytes(10));
    const Outcome both = compare("'a.####.png' 'b.####.png' --json");
    EXPECT_EQ(both.code, 4);
    const nlohmann::json report = nlohmann::json::parse(both.out);
    EXPECT_EQ(report["status"], "unreadable");
    EXPECT_EQ(report["images"][0]["verdict"], "unreadable");
    EXPECT_EQ(report["images"][1]["verdict"], "failure");
    EXPECT_EQ(both.err, "foamtex: cannot read 'b.0001.png': malformed PNG: Not a PNG file\n");
}

TEST_F(CompareCommand, FoldersAreComparedByName) {
    for (const char* folder : {"old", "new"}) {
        make_folders(folder_.path() / folder);
        write_gray(folder_.path() / folder / "x.png", 4, 100, 100);
    }
    EXPECT_EQ(compare("old new").code, 0);
    write_gray(folder_.path() / "new" / "y.png", 4, 100, 100);
    const Outcome extra = compare("old/ new/");
    EXPECT_EQ(extra.code, 2);
    EXPECT_EQ(extra.out.rfind("new/x.png: same\nnew/y.png: extra, because 'old/y.png' does not", 0),
              0U)
        << extra.out;
    const Outcome mixed = compare("old b.0001.png");
    EXPECT_EQ(mixed.code, 64);
    EXPECT_EQ(mixed.err,
              "foamtex: cannot compare a folder ('old') with an image ('b.0001.png'); A and B must "
              "both be images, patterns, folders or manifests\n");
    EXPECT_EQ(compare("old new --diff d.png").code, 64);
    const Outcome missing = compare("old none");
    EXPECT_EQ(missing.code, 4);
    EXPECT_EQ(missing.err, "foamtex: cannot compare 'old' with 'none': 'none' does not exist\n");
}

// The two images differ in one pixel of eight, by 0.2; the rms is 0.2 / sqrt(8) = 0.0707.
TEST_F(CompareCommand, HasTheLimitsOfIdiffAndMore) {
    const auto code = [&](const std::string& limits) {
        return compare("-q a.0002.png b.0002.png --warn 1 " + limits).code;
    };
    EXPECT_EQ(code("--fail 0.1 --fail-percent 12.5"), 0);
    EXPECT_EQ(code("--fail 0.1 --fail-percent 12.4"), 2);
    EXPECT_EQ(code("--fail 0.1 --fail-pixels 1"), 0);
    EXPECT_EQ(code("--fail 0.1 --fail-pixels 1 --hard-fail 0.3"), 0);
    EXPECT_EQ(code("--fail 0.1 --fail-pixels 1 --hard-fail 0.1"), 2);
    EXPECT_EQ(code("--fail-rms 0.071"), 0);
    EXPECT_EQ(code("--fail-rms 0.070"), 2);
    EXPECT_EQ(code("--fail-percentile 87.5=0"), 0);
    EXPECT_EQ(code("--fail-percentile 87.5=0,90=0.1"), 2);
    EXPECT_EQ(compare("-q a.0002.png b.0002.png --fail 1 --warn 1 --hard-warn 0.1").code, 1);
}

TEST_F(CompareCommand, AnglesNeedANormalMap) {
    Image<std::uint8_t> image(1, 1, 3);
    std::ranges::copy(std::vector<int>{128, 128, 255}, image.samples().begin());
    write_png(folder_.path() / "n.png", image.view());
    image.samples()[0] = 129;  // turns by atan(3 / 255) - atan(1 / 255), 0.4493 degrees
    write_png(folder_.path() / "m.png", image.view());
    EXPECT_EQ(compare("n.png m.png --map normal --warn 1 --fail-angle 0.5").code, 0);
    const Outcome turned = compare("n.png m.png --map normal --warn 1 --fail-angle 0.4");
    EXPECT_EQ(turned.code, 2);
    EXPECT_NE(turned.out.find("largest angle 0.4493 degrees at 0,0"), std::string::npos)
        << turned.out;
    const Outcome unknown = compare("n.png m.png --fail-angle 0.5");
    EXPECT_EQ(unknown.code, 2);
    EXPECT_EQ(unknown.err,
              "foamtex: note: --fail-angle has no effect, because no image is known to be a normal "
              "map; if the images are normal maps, add --map normal\n");
    EXPECT_EQ(compare("n.png m.png --map nomral").code, 64);
}

TEST_F(CompareCommand, OptionsOverrideTolerances) {
    const std::string toml = "[default]\nfail = 0.3\n[height]\nfail = 0.1\n";
    write_file(folder_.path() / "t.toml", std::as_bytes(std::span(toml)));
    const std::string images = "-q a.0002.png b.0002.png --tolerances t.toml ";
    EXPECT_EQ(compare(images).code, 0);
    EXPECT_EQ(compare(images + "--map height").code, 2);
    EXPECT_EQ(compare(images + "--map height --fail 0.3").code, 0);
    EXPECT_EQ(compare(images + "--warn 0.1").code, 1);
    const Outcome missing = compare("a.0002.png b.0002.png --tolerances none.toml");
    EXPECT_EQ(missing.code, 64);
    EXPECT_EQ(missing.out, "");
}

// The codes 1 and 2 are verdicts, so an error of the command line has another code.
TEST_F(CompareCommand, ABadCommandLineIsCode64) {
    const auto expect_bad = [&](const std::string& arguments, const std::string& line) {
        const Outcome bad = compare(arguments);
        EXPECT_EQ(bad.code, static_cast<int>(ExitCode::CompareBadRequest)) << arguments;
        EXPECT_EQ(bad.out, "") << arguments;
        EXPECT_EQ(bad.err, "foamtex: " + line + "\n");
    };
    expect_bad("a.0001.png", "B is required (see foamtex compare --help)");
    expect_bad("a.0001.png b.0001.png --bogus",
               "compare has no option '--bogus' (see foamtex compare --help)");
    for (const char* wrong : {"nan", "-1", "inf", "x"}) {
        expect_bad(std::string("a.0001.png b.0001.png --fail ") + wrong,
                   std::string("--fail: '") + wrong +
                       "' must be a number from 0 to 1e+300 (see foamtex compare --help)");
    }
    expect_bad("a.0001.png b.0001.png --fail-percent 101",
               "--fail-percent: '101' must be a number from 0 to 100 (see foamtex compare --help)");
    EXPECT_EQ(compare("--help").code, 0);
}

TEST_F(CompareCommand, AFileNameNeedNotBeUtf8) {
    const Outcome outcome = compare("'z\xff.png' b.0001.png --json");
    EXPECT_EQ(outcome.code, 4);
}

TEST_F(CompareCommand, SeveralFramesNeedAFrameNumberInBothNames) {
    const Outcome fixed = compare("'a.####.png' b.0001.png --frames 1-2");
    EXPECT_EQ(fixed.code, static_cast<int>(ExitCode::CompareBadRequest));
    EXPECT_EQ(fixed.out, "");
    EXPECT_EQ(fixed.err,
              "foamtex: file name pattern 'b.0001.png': must contain a frame number (####, @@@@ or "
              "%04d) for 2 frames\n");
    EXPECT_EQ(compare("a.0001.png 'b.####.png' --frames 1-2").out, "");
    EXPECT_EQ(compare("a.0001.png b.0001.png --frames 1").code, 0);
}

TEST_F(CompareCommand, ShowsWhereTheyDiffer) {
    EXPECT_EQ(compare("a.0002.png b.0002.png --diff d.exr").code, 64);
    EXPECT_FALSE(std::filesystem::exists(folder_.path() / "d.exr"));
    EXPECT_EQ(compare("a.0002.png b.0002.png --diff d.png").code, 2);
    const Image<std::uint16_t> shown = codes16(read_picture(folder_.path() / "d.png"));
    EXPECT_EQ(shown.row(0)[0], 65535);
    EXPECT_EQ(shown.row(0)[1], 0);
    EXPECT_EQ(compare("a.0001.png wide.png --diff e.png").code, 3);
    EXPECT_FALSE(std::filesystem::exists(folder_.path() / "e.png"));
}

}  // namespace
}  // namespace foam::texgen
