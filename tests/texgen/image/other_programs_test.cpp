// SPDX-License-Identifier: Apache-2.0

// Our files, read by programs that share none of our code, and a file of such a program, read by
// us. Where one is not installed its test is left out; tests/run.sh installs them all.
#include "tests/support/temporary_folder.h"
#include "tests/texgen/cli/run_program.h"
#include "tests/texgen/pictures.h"
#include "texgen/image/apng.h"
#include "texgen/image/exr.h"
#include "texgen/image/png.h"

#include <fmt/core.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstdlib>
#include <filesystem>
#include <string>
#include <utility>
#include <vector>

namespace foam::texgen {
namespace {

/// Returns the first of these programs that is not installed, or an empty string.
std::string missing(const std::vector<std::string>& programs) {
    for (const std::string& program : programs) {
        if (std::system(("command -v " + program + " >/dev/null").c_str()) != 0) {
            return program;
        }
    }
    return {};
}

/// Runs a command in a folder and returns the text that it prints. Expects the exit code 0.
std::string output_of(const std::string& command, const TemporaryFolder& folder) {
    const std::string out = (folder.path() / "printed").string();
    const std::string line =
        "cd " + folder.path().string() + " && " + command + " >" + out + " 2>&1";
    EXPECT_EQ(std::system(line.c_str()), 0) << command << "\n" << file_content(out);
    return file_content(out);
}

bool contains(const std::string& text, const std::string& part) {
    return text.find(part) != std::string::npos;
}

template <class Sample>
Image<Sample> numbered(int width, int height, int channels, unsigned first = 1) {
    Image<Sample> image(width, height, channels);
    unsigned k = first;
    for (Sample& sample : image.samples()) {
        sample = static_cast<Sample>(k);
        k = k * 40'503 + 12'345;
    }
    return image;
}

/// Returns the same picture with one more channel: an opacity of 1.
Image<std::uint8_t> with_opacity(const Image<std::uint8_t>& image) {
    constexpr std::uint8_t kOpaque = 255;
    Image<std::uint8_t> more(image.width(), image.height(), image.channels() + 1);
    for (int y = 0; y < image.height(); ++y) {
        for (int x = 0; x < image.width(); ++x) {
            std::ranges::copy(image.pixel(x, y), more.pixel(x, y).begin());
            more.pixel(x, y).back() = kOpaque;
        }
    }
    return more;
}

/// Returns the samples as bytes. The top row is first, and the high byte of a 16-bit sample is
/// first.
template <class Sample>
std::string raw_bytes(const Image<Sample>& image) {
    std::string bytes;
    for (int y = image.height() - 1; y >= 0; --y) {
        for (const Sample sample : image.row(y)) {
            for (int shift = 8 * static_cast<int>(sizeof(Sample)) - 8; shift >= 0; shift -= 8) {
                bytes += static_cast<char>(static_cast<unsigned>(sample) >> shift);
            }
        }
    }
    return bytes;
}

struct PngCase {
    int width;
    int height;
    int channels;
    const char* kind;        // color type as pngcheck prints it
    const char* conversion;  // ImageMagick's name of the raw format
};

constexpr std::array<PngCase, 6> kPngCases = {{{1, 1, 1, "grayscale", "GRAY"},
                                               {7, 300, 1, "grayscale", "GRAY"},
                                               {1, 9, 2, "grayscale+alpha", "GRAYA"},
                                               {333, 5, 3, "RGB", "RGB"},
                                               {31, 1, 4, "RGB+alpha", "RGBA"},
                                               {900, 700, 3, "RGB", "RGB"}}};

template <class Sample>
void expect_png_is_read(const PngCase& tested, const ImageMetadata& metadata) {
    const TemporaryFolder folder;
    const auto image = numbered<Sample>(tested.width, tested.height, tested.channels);
    write_png(folder.path() / "a.png", image.view(), metadata);
    const std::string checked = output_of("pngcheck -v a.png", folder);
    EXPECT_TRUE(contains(checked, "No errors detected")) << checked;
    const int depth = 8 * static_cast<int>(sizeof(Sample));
    const std::string bits = std::to_string(depth * image.channels());
    const std::string header = std::to_string(tested.width) + " x " +
                               std::to_string(tested.height) + " image, " + bits + "-bit";
    EXPECT_TRUE(contains(checked, header)) << header << "\n" << checked;
    EXPECT_TRUE(contains(checked, tested.kind)) << checked;
    for (const std::string chunk : {"sRGB", "gAMA", "cHRM"}) {
        EXPECT_EQ(contains(checked, "chunk " + chunk), metadata.color) << chunk;
    }
    output_of("convert a.png -depth " + std::to_string(depth) + " -endian MSB " +
                  tested.conversion + ":raw",
              folder);
    EXPECT_EQ(file_content(folder.path() / "raw"), raw_bytes(image));
}

TEST(OtherPrograms, PngcheckAndImageMagickReadOurPngs) {
    if (const std::string program = missing({"pngcheck", "convert"}); !program.empty()) {
        GTEST_SKIP() << "there is no " << program;
    }
    for (const PngCase& tested : kPngCases) {
        SCOPED_TRACE(testing::Message() << tested.width << " x " << tested.height);
        expect_png_is_read<std::uint8_t>(tested, {.color = true, .text = {{"Seed", "1"}}});
        expect_png_is_read<std::uint8_t>(tested, {});
        expect_png_is_read<std::uint16_t>(tested, {});
    }
}

TEST(OtherPrograms, OurTextsAreRead) {
    if (const std::string program = missing({"identify", "pngcheck"}); !program.empty()) {
        GTEST_SKIP() << "there is no " << program;
    }
    const TemporaryFolder folder;
    const ImageMetadata metadata{.color = false, .text = {{"Seed", "1234"}, {"Author", "Zoë"}}};
    write_png(folder.path() / "a.png", numbered<std::uint8_t>(2, 2, 3).view(), metadata);
    const std::string identified = output_of("identify -verbose a.png", folder);
    EXPECT_TRUE(contains(identified, "Seed: 1234")) << identified;
    const std::string checked = output_of("pngcheck -vt a.png", folder);
    EXPECT_TRUE(contains(checked, "keyword: Author")) << checked;
    EXPECT_TRUE(contains(checked, "UTF-8 text")) << checked;
}

// apngdis writes every frame to a PNG, and its delay to a text file.
TEST(OtherPrograms, ApngdisDisassemblesOurAnimations) {
    if (const std::string program = missing({"apngdis"}); !program.empty()) {
        GTEST_SKIP() << "there is no " << program;
    }
    const TemporaryFolder folder;
    constexpr int kFrames = 3;
    ApngMuxer muxer(kFrames, {30, 1});
    for (unsigned k = 1; k <= kFrames; ++k) {
        muxer.add(encode_png(numbered<std::uint8_t>(40, 27, 3, k).view()));
    }
    write_file(folder.path() / "a.png", muxer.finish());
    const std::string output = output_of("apngdis a.png frame", folder);
    for (unsigned k = 1; k <= kFrames; ++k) {
        const std::string name = fmt::format("frame{}", k);
        EXPECT_EQ(codes8(read_picture(folder.path() / (name + ".png"))),
                  with_opacity(numbered<std::uint8_t>(40, 27, 3, k)));
        EXPECT_EQ(file_content(folder.path() / (name + ".txt")), "delay=1/30\n");
    }
}

/// Writes layers of several types to a file of rows, or to a file of tiles with mip levels.
void write_layers(const std::filesystem::path& path, bool mip_levels) {
    Image<float> image(67, 35, 3);
    for (std::size_t k = 0; k < image.samples().size(); ++k) {
        image.samples()[k] = static_cast<float>(k % 200) / 16.0F - 3.0F;
    }
    const auto ids = numbered<std::uint32_t>(67, 35, 1);
    const std::vector<ExrChannel> channels = {{"albedo.R", SampleType::Half, image.view(), 0},
                                              {"albedo.G", SampleType::Half, image.view(), 1},
                                              {"albedo.B", SampleType::Half, image.view(), 2},
                                              {"height.Y", SampleType::Float, image.view(), 1},
                                              {"id.Y", SampleType::Uint32, ids.view()}};
    const ImageMetadata metadata{.color = true,
                                 .periodic = true,
                                 .frame_rate = FrameRate{30000, 1001},
                                 .text = {{"Seed", "1234"}}};
    write_exr(path, channels, metadata, {.mip_levels = mip_levels});
}

TEST(OtherPrograms, ExrheaderReadsOurAttributes) {
    if (const std::string program = missing({"exrheader"}); !program.empty()) {
        GTEST_SKIP() << "there is no " << program;
    }
    const TemporaryFolder folder;
    write_layers(folder.path() / "a.exr", false);
    const std::string output = output_of("exrheader a.exr", folder);
    for (const std::string part : {"albedo.R, 16-bit floating-point, sampling 1 1",
                                   "height.Y, 32-bit floating-point, sampling 1 1",
                                   "id.Y, 32-bit unsigned integer, sampling 1 1",
                                   "compression (type compression): zip",
                                   "dataWindow (type box2i): (0 0) - (66 34)",
                                   "wrapmodes (type string): \"periodic\"",
                                   "framesPerSecond (type rational): 30000/1001",
                                   "Seed (type string): \"1234\"",
                                   "red   (0.64 0.33)",
                                   "white (0.3127 0.329)"}) {
        EXPECT_TRUE(contains(output, part)) << part << "\n" << output;
    }
    EXPECT_FALSE(contains(output, "capDate")) << output;
    write_layers(folder.path() / "b.exr", true);
    const std::string tiled = output_of("exrheader b.exr", folder);
    EXPECT_TRUE(contains(tiled, "tile size 64 by 64 pixels")) << tiled;
    EXPECT_TRUE(contains(tiled, "mip-map")) << tiled;
}

TEST(OtherPrograms, OpenImageIoReadsOurExrs) {
    if (const std::string program = missing({"oiiotool"}); !program.empty()) {
        GTEST_SKIP() << "there is no " << program;
    }
    const TemporaryFolder folder;
    write_layers(folder.path() / "a.exr", false);
    write_layers(folder.path() / "b.exr", true);
    const std::string output = output_of("oiiotool --info -v a.exr", folder);
    EXPECT_TRUE(contains(output, "67 x   35, 5 channel")) << output;
    EXPECT_TRUE(contains(output, "wrapmodes: \"periodic\"")) << output;
    EXPECT_TRUE(contains(output, "framesPerSecond: 30000/1001")) << output;
    output_of("idiff a.exr b.exr", folder);  // the same pixels
    const std::string tiled = output_of("oiiotool --info -v b.exr", folder);
    EXPECT_TRUE(contains(tiled, "MIP-map levels: 67x35 33x17 16x8 8x4 4x2 2x1 1x1")) << tiled;
}

// A map in a channel "Y" is a gray image. oiiotool prints its samples as "Pixel (x, y): value".
TEST(OtherPrograms, OpenImageIoFindsOurValues) {
    if (const std::string program = missing({"oiiotool"}); !program.empty()) {
        GTEST_SKIP() << "there is no " << program;
    }
    const TemporaryFolder folder;
    Image<float> image(2, 2, 1);
    image.row(1)[0] = -2.5F;  // top left
    image.row(1)[1] = 1.0F;
    image.row(0)[0] = 700.0F;
    image.row(0)[1] = 0.25F;
    const ExrChannel channel{"Y", SampleType::Half, image.view()};
    write_exr(folder.path() / "a.exr", std::span(&channel, 1));
    const std::string output = output_of("oiiotool --dumpdata a.exr", folder);
    EXPECT_TRUE(contains(output, "Pixel (0, 0): -2.5")) << output;
    EXPECT_TRUE(contains(output, "Pixel (1, 0): 1.0")) << output;
    EXPECT_TRUE(contains(output, "Pixel (0, 1): 700.0")) << output;
    EXPECT_TRUE(contains(output, "Pixel (1, 1): 0.25")) << output;
}

// DWA compresses it to less than 1/1032 of its size, which deflate cannot do.
TEST(OtherPrograms, WeReadAFlatImageOfOpenImageIo) {
    if (const std::string program = missing({"oiiotool"}); !program.empty()) {
        GTEST_SKIP() << "there is no " << program;
    }
    const TemporaryFolder folder;
    output_of(
        "oiiotool --pattern constant:color=0.5,0.5,0.5 512x512 3 -d half --compression dwab -o "
        "a.exr",
        folder);
    ASSERT_LT(std::filesystem::file_size(folder.path() / "a.exr") * 1032, 512U * 512U * 6U);
    const Picture picture = read_picture(folder.path() / "a.exr");
    EXPECT_EQ(picture.width(), 512);
    EXPECT_NEAR(floats(picture.groups.front()).row(100)[100], 0.5F, 1e-3F);
}

// Compares only cases in which idiff follows its own table of exit codes. For a warning, and for
// images of different sizes, it may exit with 0.
TEST(OtherPrograms, IdiffComparesAsWeDo) {
    if (const std::string program = missing({"idiff"}); !program.empty()) {
        GTEST_SKIP() << "there is no " << program;
    }
    const TemporaryFolder folder;
    Image<std::uint8_t> image(4, 2, 3);
    write_png(folder.path() / "a.png", image.view());
    image.pixel(3, 1)[1] = 51;  // 0.2
    write_png(folder.path() / "b.png", image.view());
    for (const auto& [limit, file] : {std::pair("0.3", "b.png"),
                                      std::pair("0.1", "b.png"),
                                      std::pair("0", "a.png"),
                                      std::pair("0", "none.png")}) {
        const std::string idiff =
            fmt::format("cd {0} && idiff -warn {1} -fail {1} a.png {2} >out 2>&1",
                        folder.path().string(),
                        limit,
                        file);
        const int status = std::system(idiff.c_str());
        const Outcome ours = run_program(
            fmt::format("compare --warn {0} --fail {0} a.png {1}", limit, file), folder);
        EXPECT_EQ(ours.code, WEXITSTATUS(status)) << limit << " " << file;
    }
}

// One of eight pixels differs, in two of its three channels. idiff counts pixels, not samples.
TEST(OtherPrograms, IdiffAllowsPixelsAsWeDo) {
    if (const std::string program = missing({"idiff"}); !program.empty()) {
        GTEST_SKIP() << "there is no " << program;
    }
    const TemporaryFolder folder;
    Image<std::uint8_t> image(4, 2, 3);
    write_png(folder.path() / "a.png", image.view());
    image.pixel(3, 1)[1] = 51;  // 0.2
    image.pixel(3, 1)[2] = 51;
    write_png(folder.path() / "b.png", image.view());
    const std::vector<std::pair<std::string, std::string>> limits = {
        {"-fail 0.1 -failpercent 12", "--fail 0.1 --fail-percent 12"},
        {"-fail 0.1 -failpercent 13", "--fail 0.1 --fail-percent 13"},
        {"-fail 0.1 -failpercent 13 -hardfail 0.3", "--fail 0.1 --fail-percent 13 --hard-fail 0.3"},
        {"-fail 0.1 -failpercent 13 -hardfail 0.1", "--fail 0.1 --fail-percent 13 --hard-fail 0.1"},
        {"-hardfail 0.3", "--hard-fail 0.3"},
        {"-fail 0.1 -allowfailures 1", "--fail 0.1 --fail-pixels 1"},
        {"-fail 0.1 -allowfailures 1 -failpercent 1",
         "--fail 0.1 --fail-pixels 1 --fail-percent 1"},
        {"-fail 0.1 -allowfailures 0 -failpercent 13",
         "--fail 0.1 --fail-pixels 0 --fail-percent 13"}};
    for (const auto& [theirs, ours] : limits) {
        const std::string idiff = fmt::format(
            "cd {} && idiff -warn 1 {} a.png b.png >out 2>&1", folder.path().string(), theirs);
        const int status = std::system(idiff.c_str());
        const Outcome outcome =
            run_program(fmt::format("compare --warn 1 {} a.png b.png", ours), folder);
        EXPECT_EQ(outcome.code, WEXITSTATUS(status)) << theirs;
    }
}

}  // namespace
}  // namespace foam::texgen
