// SPDX-License-Identifier: Apache-2.0

#include "texgen/verify/compare_images.h"

#include "tests/support/temporary_folder.h"
#include "tests/texgen/pictures.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <string>
#include <vector>

namespace foam::texgen {
namespace {

class CompareImages : public testing::Test {
  protected:
    std::filesystem::path path(const std::string& name) const { return folder_.path() / name; }

    /// Writes a PNG of one pixel that names its map, if `map` is not empty.
    void write(const std::string& name, std::uint8_t red, const std::string& map) {
        Image<std::uint8_t> image(1, 1, 3);
        image.samples()[0] = red;
        image.samples()[2] = 255;
        ImageMetadata metadata;
        if (!map.empty()) {
            metadata.text = {{"Map", map}};
        }
        write_png(path(name), image.view(), metadata);
    }

    /// Writes an EXR with the layers "normal" (three channels) and "height". All samples are
    /// `value`, except for a 1 in normal.Z.
    void write_layers(const std::string& name, float value) {
        Image<float> image(1, 1, 1);
        image.samples()[0] = value;
        Image<float> one(1, 1, 1);
        one.samples()[0] = 1.0F;
        const std::array<ExrChannel, 4> channels = {
            {{"normal.X", SampleType::Float, image.view()},
             {"normal.Y", SampleType::Float, image.view()},
             {"normal.Z", SampleType::Float, one.view()},
             {"height.Y", SampleType::Float, image.view()}}};
        write_exr(path(name), channels);
    }

    ComparedImage compared(const ImagePair& pair, const CompareOptions& options = {}) {
        const std::vector<ComparedImage> images = compare_pair(pair, options);
        EXPECT_EQ(images.size(), 1U);
        return images.front();
    }

    TemporaryFolder folder_;
};

// The name of the map is that of the option, else that of the manifest, else that of the texts.
TEST_F(CompareImages, FindTheMap) {
    write("a.png", 128, "height");
    write("b.png", 128, "");
    const ImagePair pair{path("a.png"), path("b.png")};
    EXPECT_EQ(compared(pair).map, "height");
    EXPECT_EQ(compared({path("b.png"), path("a.png")}).map, "height");
    EXPECT_EQ(compared({path("b.png"), path("b.png")}).map, "");
    EXPECT_EQ(compared({pair.a, pair.b, Presence::Both, "area"}).map, "area");
    EXPECT_EQ(compared({pair.a, pair.b, Presence::Both, "area"}, {.map = "normal"}).map, "normal");
}

TEST_F(CompareImages, UseTheLimitsOfTheMap) {
    write("a.png", 128, "height");
    write("b.png", 138, "height");
    const CompareOptions options{.limits_of = [](std::string_view map) {
        const double limit = map == "height" ? 0.5 : 0.0;
        return CompareLimits{{.sample = limit}, {.sample = limit}};
    }};
    EXPECT_EQ(compared({path("a.png"), path("b.png")}, options).verdict, Verdict::Same);
    CompareOptions other = options;
    other.map = "area";
    EXPECT_EQ(compared({path("a.png"), path("b.png")}, other).verdict, Verdict::Failure);
}

TEST_F(CompareImages, MeasureAnglesOfNormalMapsOnly) {
    write("normal.png", 128, "normal_dx");
    write("area.png", 128, "area");
    const ImagePair normals{path("normal.png"), path("normal.png")};
    EXPECT_EQ(compared(normals).found.angle, 0.0);
    EXPECT_FALSE(compared({path("area.png"), path("area.png")}).found.angle.has_value());
}

TEST_F(CompareImages, LayersAreComparedOneByOne) {
    write_layers("a.exr", 0.0F);
    write_layers("b.exr", 0.5F);
    const std::vector<ComparedImage> images =
        compare_pair({path("a.exr"), path("b.exr")}, {.limits_of = [](std::string_view map) {
                         const double limit = map == "height" ? 0.6 : 0.4;
                         return CompareLimits{{.sample = limit}, {.sample = limit}};
                     }});
    ASSERT_EQ(images.size(), 2U);
    EXPECT_EQ(images[0].layer, "height");
    EXPECT_EQ(images[0].verdict, Verdict::Same);
    EXPECT_EQ(images[1].map, "normal");
    EXPECT_EQ(images[1].verdict, Verdict::Failure);
    EXPECT_NEAR(images[1].found.angle.value(), 35.264, 1e-3);  // acos(1 / sqrt(1.5))
    EXPECT_EQ(worst_verdict(images), Verdict::Failure);
}

// A layer that is not a map of colors, such as a packed image, has no primaries.
TEST_F(CompareImages, ConvertColorsToTheSamePrimaries) {
    const auto write_red = [&](const std::string& name,
                               const std::string& prefix,
                               const std::vector<float>& red,
                               Primaries primaries) {
        Image<float> image(1, 1, 3);
        std::ranges::copy(red, image.samples().begin());
        write_exr(path(name),
                  std::vector<ExrChannel>{{prefix + "R", SampleType::Float, image.view(), 0},
                                          {prefix + "G", SampleType::Float, image.view(), 1},
                                          {prefix + "B", SampleType::Float, image.view(), 2}},
                  {.color = true, .primaries = primaries});
    };
    const std::vector<float> in_acescg = {0.613097F, 0.070194F, 0.020616F};
    for (const std::string prefix : {"", "albedo.", "ORM."}) {
        write_red("srgb.exr", prefix, {1.0F, 0.0F, 0.0F}, Primaries::Srgb);
        write_red("acescg.exr", prefix, in_acescg, Primaries::AcesCg);
        const ComparedImage image = compared({path("srgb.exr"), path("acescg.exr")});
        EXPECT_EQ(image.found.largest < 1e-5, prefix != "ORM.") << prefix;
    }
}

TEST_F(CompareImages, MissingAndUnreadableImagesAreResults) {
    write("a.png", 1, "");
    write_file(path("torn.png"), Bytes(10));
    EXPECT_EQ(compared({path("a.png"), path("b.png"), Presence::OnlyA}).verdict, Verdict::Failure);
    const ComparedImage torn = compared({path("a.png"), path("torn.png")});
    EXPECT_EQ(torn.verdict, Verdict::Unreadable);
    EXPECT_NE(torn.error.find("torn.png': malformed PNG"), std::string::npos) << torn.error;
    EXPECT_EQ(compared({path("a.png"), path("none.png")}).verdict, Verdict::Unreadable);
}

TEST_F(CompareImages, WriteThePictureOfTheDifferences) {
    write("a.png", 0, "");
    write("b.png", 9, "");
    const CompareOptions options{.difference = path("d.png")};
    compared({path("a.png"), path("b.png")}, options);
    EXPECT_EQ(codes16(read_picture(path("d.png"))).samples()[0], 65535);
}

TEST(WorstVerdict, IsTheLargest) {
    EXPECT_EQ(worst_verdict({}), Verdict::Same);
    std::vector<ComparedImage> images(2);
    images[0].verdict = Verdict::DifferentLayout;
    images[1].verdict = Verdict::Warning;
    EXPECT_EQ(worst_verdict(images), Verdict::DifferentLayout);
}

}  // namespace
}  // namespace foam::texgen
