#include "texgen/image/compare.h"

#include "tests/texgen/temporary_folder.h"
#include "texgen/image/exr.h"
#include "texgen/image/file_io.h"
#include "texgen/image/png.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <vector>

namespace foam::texgen {
namespace {

/// 3 x 2 pixels of one channel; the first number is that of the lower left.
Picture grey(const std::vector<double>& numbers, const std::string& name = "Y") {
    Image<double> image(3, 2, 1);
    std::ranges::copy(numbers, image.samples().begin());
    return {{{name, image}}};
}

// By hand: 0.5 and 0.25 apart in two of six samples.
TEST(Compare, MeasuresWhatIsApart) {
    const Picture a = grey({0, 0, 0, 1, 1, 1});
    const Picture b = grey({0, 0.25, 0, 1, 1, 0.5});
    const Comparison found = compare(a, b, {.warn = 0.1, .fail = 0.3});
    EXPECT_EQ(found.verdict, Verdict::Failure);
    EXPECT_EQ(found.largest, 0.5);
    EXPECT_EQ(found.mean, 0.75 / 6.0);
    EXPECT_EQ(found.warnings, 2U);
    EXPECT_EQ(found.failures, 1U);
    EXPECT_EQ(found.channel, "Y");
    EXPECT_EQ(found.x, 2);
    EXPECT_EQ(found.y, 0);
}

// A limit is still allowed.
TEST(Compare, LimitsDecide) {
    const Picture a = grey({0, 0, 0, 0, 0, 0});
    const Picture b = grey({0.5, 0, 0, 0, 0, 0});
    EXPECT_EQ(compare(a, a).verdict, Verdict::Same);
    EXPECT_EQ(compare(a, b).verdict, Verdict::Failure);
    EXPECT_EQ(compare(a, b, {.warn = 0.5, .fail = 0.5}).verdict, Verdict::Same);
    EXPECT_EQ(compare(a, b, {.warn = 0.1, .fail = 0.5}).verdict, Verdict::Warning);
    EXPECT_EQ(compare(a, b, {.warn = 0.1, .fail = 0.4}).verdict, Verdict::Failure);
}

TEST(Compare, OtherFormsAreNotCompared) {
    const Picture a = grey({0, 0, 0, 0, 0, 0});
    const Picture narrow = {{{"Y", Image<double>(2, 2, 1)}}};
    Picture two = a;
    two.channels.push_back({"Z", a.channels[0].numbers});
    for (const Picture& b : {narrow, two, grey({0, 0, 0, 0, 0, 0}, "R")}) {
        EXPECT_EQ(compare(a, b).verdict, Verdict::OtherSize);
    }
}

TEST(Compare, WhatIsNoNumberIsApartFromNumbersOnly) {
    const double nan = std::nan("");
    const double infinity = std::numeric_limits<double>::infinity();
    const Picture a = grey({nan, infinity, 0, 0, 0, 0});
    EXPECT_EQ(compare(a, a).verdict, Verdict::Same);
    const Comparison found = compare(a, grey({0, infinity, 0, 0, 0, 0}), {.fail = 1e30});
    EXPECT_EQ(found.verdict, Verdict::Failure);
    EXPECT_EQ(found.largest, infinity);
}

TEST(Compare, TheDifferencePictureShowsTheLargestAsWhite) {
    const Picture a = grey({0, 0, 0, 1, 1, 1});
    const Image<std::uint16_t> shown = difference_picture(a, grey({0, 0.25, 0, 1, 1, 0.5}));
    EXPECT_EQ(shown.row(0)[1], 32768);
    EXPECT_EQ(shown.row(1)[2], 65535);
    EXPECT_EQ(shown.row(0)[0], 0);
    const Image<std::uint16_t> black = difference_picture(a, a);
    EXPECT_EQ(std::ranges::count(black.samples(), 0), 6);
}

// One picture as PNG of both depths and as EXR: 51 of 255 is 0.2.
TEST(Picture, FormatsAreReadAlike) {
    const TemporaryFolder folder;
    Image<std::uint8_t> coarse(1, 1, 3);
    std::ranges::copy(std::vector{0, 51, 255}, coarse.samples().begin());
    Image<std::uint16_t> fine(1, 1, 3);
    std::ranges::copy(std::vector{0, 13107, 65535}, fine.samples().begin());
    Image<float> whole(1, 1, 3);
    std::ranges::copy(std::vector{0.0F, 0.2F, 1.0F}, whole.samples().begin());
    write_png(folder.path() / "coarse.png", coarse.view());
    write_png(folder.path() / "fine.png", fine.view());
    const std::vector<ExrChannel> channels = {{"R", ExrType::Float, whole.view(), 0},
                                              {"G", ExrType::Float, whole.view(), 1},
                                              {"B", ExrType::Float, whole.view(), 2}};
    write_exr(folder.path() / "whole.exr", channels);
    const Picture a = read_picture(folder.path() / "coarse.png");
    EXPECT_EQ(a.channels[0].name, "B");
    EXPECT_EQ(a.channels[1].numbers.samples()[0], 0.2);
    EXPECT_EQ(compare(a, read_picture(folder.path() / "fine.png")).largest, 0.0);
    EXPECT_EQ(compare(a, read_picture(folder.path() / "whole.exr")).verdict, Verdict::Same);
    EXPECT_THROW(read_picture(folder.path() / "a.jpg"), InputError);
    EXPECT_THROW(read_picture(folder.path() / "none.png"), InputError);
}

}  // namespace
}  // namespace foam::texgen
