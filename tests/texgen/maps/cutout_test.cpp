// SPDX-License-Identifier: Apache-2.0

// Tests of albedo in a patch, whose surroundings are transparent.
#include "tests/support/albedo_image.h"
#include "tests/support/sample_foams.h"
#include "texgen/image/color.h"
#include "texgen/image/colormap.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <numbers>

namespace foam::texgen {
namespace {

using Image8 = Image<std::uint8_t>;

RasterGrid grid_of(int size, double scale) {
    return {size, size, 0, 0, View{Vec2::Zero(), scale}};
}

AlbedoOptions options() {
    AlbedoOptions options;
    options.colormap = "magma";
    options.pressure_low = 0.0;
    options.pressure_high = 2.0;
    options.film_color = "#f0d0ff";
    options.film_width = 2.5;
    return options;
}

// Returns a patch with a hole, and a lone bubble beside it.
Frame patch_frame() {
    Foam foam = test::patch_foam(60, 3, "POLYGON((0 0, 9 0, 9 9, 0 9), (4 4, 4 8, 8 8, 8 4))");
    foam.lone_bubbles.push_back({900, {-5.6, -5.6}, 1.5});
    return snapshot(foam, 1);
}

Image8 patch_image(int threads = 1) {
    return test::albedo_image(patch_frame(), grid_of(256, 18.0), options(), threads);
}

TEST(Cutout, ATorusHasThreeChannelsAndAPatchFour) {
    EXPECT_EQ(
        test::albedo_image(test::fitted_frame(test::single_bubble(), 8, 8), {8, 8, 0, 0}, {}, 1)
            .channels(),
        3);
    EXPECT_EQ(patch_image().channels(), 4);
}

// A circle of radius 40 pixels with a film of 2.5 pixels is opaque up to the radius 41.25. Its area
// is pi 41.25², up to the rounding of the opacity of some 300 pixels to 8 bits.
TEST(Cutout, OpacityIsThePartOfAPixelThatIsCovered) {
    const Frame frame = snapshot(test::circles({{0, {0.0, 0.0}, std::numbers::pi}}), 1);
    const Image8 image = test::albedo_image(frame, grid_of(96, 40.0), options(), 1);
    double area = 0.0;
    for (int y = 0; y < 96; ++y) {
        for (int x = 0; x < 96; ++x) {
            area += image.pixel(x, y)[3] / 255.0;
            const double distance = std::hypot(x - 47.5, y - 47.5);
            if (std::abs(distance - 41.25) > 0.75) {
                ASSERT_EQ(image.pixel(x, y)[3], distance < 41.25 ? 255 : 0) << x << " " << y;
            }
        }
    }
    EXPECT_NEAR(area / (std::numbers::pi * 41.25 * 41.25), 1.0, 1e-4);
}

// Every pixel of the edge that has any opacity has the color of the film, not mixed with a
// background.
TEST(Cutout, TheEdgeHasTheColorOfTheFilm) {
    const Frame frame = snapshot(test::circles({{0, {0.0, 0.0}, std::numbers::pi}}), 1);
    const Image8 image = test::albedo_image(frame, grid_of(96, 40.0), options(), 1);
    const Srgb8 film = parse_color(options().film_color);
    for (int y = 0; y < 96; ++y) {
        for (int x = 0; x < 96; ++x) {
            const auto pixel = image.pixel(x, y);
            if (pixel[3] > 0 && std::hypot(x - 47.5, y - 47.5) > 40.75) {
                ASSERT_EQ((Srgb8{pixel[0], pixel[1], pixel[2]}), film) << x << " " << y;
            }
        }
    }
}

TEST(Cutout, ALoneBubbleHasTheColorOfItsPressure) {
    Foam foam = test::circles({{0, {0.0, 0.0}, 2.0}});
    foam.film_tension = 0.7;
    AlbedoOptions seed = options();
    seed.pressure_unit = PressureUnit::Seed;
    const double pressure = 1.0 / std::sqrt(2.0 / std::numbers::pi);  // (T / r) / T
    const Srgb8 expected = to_srgb8(find_colormap("magma").at(0.5 * pressure));
    const Image8 image = test::albedo_image(snapshot(foam, 1), grid_of(40, 20.0), seed, 1);
    const auto pixel = image.pixel(20, 20);
    EXPECT_EQ((Srgb8{pixel[0], pixel[1], pixel[2]}), expected);
    EXPECT_EQ(pixel[3], 255);
}

TEST(Cutout, DoesNotDependOnThreads) {
    const Image8 one = patch_image(1);
    EXPECT_EQ(one, patch_image(2));
    EXPECT_EQ(one, patch_image(3));
}

// A pixel of a mip map: linear light of red, green and blue, and the opacity. The light is either
// straight, as in a texture, or premultiplied.
using Pixel = std::array<double, 4>;

struct Mip {
    int size = 0;
    std::vector<Pixel> pixels;

    const Pixel& at(int x, int y) const {
        return pixels[static_cast<std::size_t>(y) * static_cast<std::size_t>(size) +
                      static_cast<std::size_t>(x)];
    }
};

// Returns an image as level 0 of its mip map. If `bled` is false, the color of fully transparent
// pixels is replaced by black.
Mip mip_of(const Image8& image, bool premultiplied, bool bled) {
    Mip mip{image.width(), {}};
    for (int y = 0; y < image.height(); ++y) {
        for (int x = 0; x < image.width(); ++x) {
            const auto sample = image.pixel(x, y);
            const double opacity = sample[3] / 255.0;
            const double weight = premultiplied ? opacity : (bled || sample[3] > 0 ? 1.0 : 0.0);
            mip.pixels.push_back({weight * srgb_to_linear(sample[0] / 255.0),
                                  weight * srgb_to_linear(sample[1] / 255.0),
                                  weight * srgb_to_linear(sample[2] / 255.0),
                                  opacity});
        }
    }
    return mip;
}

Mip halved(const Mip& fine) {
    Mip coarse{fine.size / 2, {}};
    for (int y = 0; y < coarse.size; ++y) {
        for (int x = 0; x < coarse.size; ++x) {
            Pixel mean{};
            for (int k = 0; k < 4; ++k) {
                const Pixel& part = fine.at(2 * x + k % 2, 2 * y + k / 2);
                for (std::size_t c = 0; c < 4; ++c) {
                    mean[c] += 0.25 * part[c];
                }
            }
            coarse.pixels.push_back(mean);
        }
    }
    return coarse;
}

// Compares a straight color and a premultiplied color, each drawn over a background of gray light,
// `ground`. Returns their largest difference in any channel, in steps of 8-bit sRGB.
double fringe(const Pixel& straight, const Pixel& premultiplied, double ground) {
    double largest = 0.0;
    const double under = (1.0 - straight[3]) * ground;
    for (std::size_t c = 0; c < 3; ++c) {
        const double difference = linear_to_srgb(straight[3] * straight[c] + under) -
                                  linear_to_srgb(premultiplied[c] + under);
        largest = std::max(largest, 255.0 * std::abs(difference));
    }
    return largest;
}

// Returns the largest fringe of each level of the mip map, from level 1 on.
std::vector<double> mip_fringes(const Image8& image, double ground, bool bled) {
    Mip straight = mip_of(image, false, bled);
    Mip premultiplied = mip_of(image, true, bled);
    std::vector<double> all;
    while (straight.size > 4) {
        straight = halved(straight);
        premultiplied = halved(premultiplied);
        double largest = 0.0;
        for (std::size_t k = 0; k < straight.pixels.size(); ++k) {
            largest =
                std::max(largest, fringe(straight.pixels[k], premultiplied.pixels[k], ground));
        }
        all.push_back(largest);
    }
    return all;
}

// Returns the bilinear interpolation between the pixel (x, y) and its neighbors to the right,
// above, and above right.
Pixel bilinear(const Mip& mip, int x, int y, double u, double v) {
    Pixel mixed{};
    for (int k = 0; k < 4; ++k) {
        const double weight = (k % 2 == 0 ? 1.0 - u : u) * (k / 2 == 0 ? 1.0 - v : v);
        const Pixel& part = mip.at(x + k % 2, y + k / 2);
        for (std::size_t c = 0; c < 4; ++c) {
            mixed[c] += weight * part[c];
        }
    }
    return mixed;
}

// Returns the largest fringe if the image is magnified, so that colors are interpolated between
// pixels.
double largest_bilinear_fringe(const Image8& image, double ground, bool bled) {
    const Mip straight = mip_of(image, false, bled);
    const Mip premultiplied = mip_of(image, true, bled);
    double largest = 0.0;
    for (int k = 0; k < 4 * (image.width() - 1) * (image.height() - 1); ++k) {
        const int x = (k / 4) % (image.width() - 1);
        const int y = (k / 4) / (image.width() - 1);
        const double u = k % 2 == 0 ? 0.25 : 0.75;
        const double v = k / 2 % 2 == 0 ? 0.25 : 0.75;
        const Pixel a = bilinear(straight, x, y, u, v);
        largest = std::max(largest, fringe(a, bilinear(premultiplied, x, y, u, v), ground));
    }
    return largest;
}

// Levels 1 and 2 have almost no fringe. In further levels, pixels of little opacity have the same
// weight in the mean of straight colors as opaque pixels, so there is a fringe. It is smaller than
// without bleeding.
TEST(Cutout, MipMapsShowNoFringe) {
    const Image8 image = patch_image();
    for (const double ground : {0.0, 1.0}) {
        const std::vector<double> fringes = mip_fringes(image, ground, true);
        const std::vector<double> without = mip_fringes(image, ground, false);
        ASSERT_EQ(fringes.size(), 6U);
        EXPECT_LT(fringes[0], 0.5) << ground;
        EXPECT_LT(fringes[1], 5.0) << ground;
        EXPECT_GT(without[0], 20.0) << ground;
        for (std::size_t level = 2; level < fringes.size(); ++level) {
            EXPECT_LT(fringes[level], without[level]) << ground << ' ' << level;
        }
    }
}

TEST(Cutout, MagnifyingShowsNoFringe) {
    const Image8 image = patch_image();
    for (const double ground : {0.0, 1.0}) {
        EXPECT_LT(largest_bilinear_fringe(image, ground, true), 0.5) << ground;
        EXPECT_GT(largest_bilinear_fringe(image, ground, false), 15.0) << ground;
    }
}

}  // namespace
}  // namespace foam::texgen
