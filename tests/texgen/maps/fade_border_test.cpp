// SPDX-License-Identifier: Apache-2.0

#include "texgen/maps/fade_border.h"

#include "tests/support/sample_foams.h"
#include "tests/texgen/maps/map_subjects.h"
#include "texgen/maps/all_maps.h"
#include "texgen/maps/cross_fade.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <numeric>
#include <string>
#include <variant>
#include <vector>

namespace foam::texgen {
namespace {

constexpr int kSize = 128;
constexpr int kBubbles = 24;

// Two foams on the same torus, and what the test draws of their cross-fade.
struct Fading {
    Frame out = snapshot(foam::test::polydisperse_foam(kBubbles, 5), 1);
    Frame in = snapshot(foam::test::polydisperse_foam(kBubbles, 9), 1);
    FoamRecord record = test::torus_subject().record;
    std::vector<double> growth = std::vector<double>(in.bubbles.size(), 0.0);

    MapImage draw(const std::string& map,
                  const MapOptions& options = {},
                  const RasterGrid& grid = test::torus_grid(kSize),
                  int threads = 1) const {
        const CrossFade fade{out, in, growth};
        const DistanceNeeds needs = distance_needs(std::vector{map}, options);
        ShownLayers shown{FrameLayers({out, record, &out, needs, &fade}, grid, threads),
                          FrameLayers({in, record, &in, needs, &fade}, grid, threads)};
        return texgen::draw(find_map(map), shown, options);
    }
};

// Growths of all kinds: a third of the bubbles is not visible, a third is complete, and the others
// grow.
Fading in_the_middle() {
    Fading fading;
    for (std::size_t k = 0; k < fading.growth.size(); ++k) {
        fading.growth[k] = std::clamp(static_cast<double>(k * 7 % kBubbles) / 8.0 - 1.0, 0.0, 1.0);
    }
    return fading;
}

Image<float> numbers_of(const MapImage& image) {
    return std::get<NumberPixels>(image).pixels;
}

MapOptions films_of_width(double width, FilmProfile profile) {
    MapOptions options;
    options.albedo.film_width = width;
    options.albedo.film_profile = profile;
    return options;
}

// Returns true if all pixels that are at most `reach` rows and columns away have the same label.
bool is_interior(const Image<std::uint32_t>& labels, int x, int y, int reach) {
    for (int dy = -reach; dy <= reach; ++dy) {
        for (int dx = -reach; dx <= reach; ++dx) {
            if (labels.pixel(wrap(x + dx, kSize), wrap(y + dy, kSize))[0] !=
                labels.pixel(x, y)[0]) {
                return false;
            }
        }
    }
    return true;
}

// Returns the bubble that every pixel shows: bubbles of the foam that fades in have larger labels.
Image<std::uint32_t> shown_bubbles(const Fading& fading) {
    Fading marked = fading;
    for (FrameBubble& bubble : marked.in.bubbles) {
        bubble.identity += 1000;
    }
    return std::get<IdPixels>(marked.draw("id")).pixels;
}

// No film of one foam crosses a bubble of the other foam: films are only between shown bubbles.
TEST(FadeBorder, NoPlaceShowsTheFilmsOfTwoFoams) {
    const Fading fading = in_the_middle();
    const Image<std::uint32_t> labels = shown_bubbles(fading);
    for (const FilmProfile profile : {FilmProfile::Even, FilmProfile::Wet}) {
        const Image<float> films = numbers_of(fading.draw("film", films_of_width(3.0, profile)));
        int interior = 0;
        for (int y = 0; y < kSize; ++y) {
            for (int x = 0; x < kSize; ++x) {
                if (is_interior(labels, x, y, 5)) {
                    ++interior;
                    EXPECT_EQ(films.pixel(x, y)[0], 0.0F) << x << ", " << y;
                }
            }
        }
        EXPECT_GT(interior, kSize * kSize / 10);
    }
}

// Wherever the shown bubble changes from a pixel to the next, there is a film.
TEST(FadeBorder, FilmsSeparateAllShownBubbles) {
    const Fading fading = in_the_middle();
    const Image<std::uint32_t> labels = shown_bubbles(fading);
    for (const FilmProfile profile : {FilmProfile::Even, FilmProfile::Wet}) {
        const Image<float> films = numbers_of(fading.draw("film", films_of_width(4.0, profile)));
        for (int y = 0; y < kSize; ++y) {
            for (int x = 0; x + 1 < kSize; ++x) {
                if (labels.pixel(x, y)[0] != labels.pixel(x + 1, y)[0]) {
                    EXPECT_GT(std::max(films.pixel(x, y)[0], films.pixel(x + 1, y)[0]), 0.5F)
                        << x << ", " << y << ": " << labels.pixel(x, y)[0] << " beside "
                        << labels.pixel(x + 1, y)[0];
                }
            }
        }
    }
}

TEST(FadeBorder, BothFoamsAreShown) {
    const Fading fading = in_the_middle();
    const Image<std::uint32_t> labels = shown_bubbles(fading);
    const auto of_new = std::ranges::count_if(labels.samples(), [](auto id) { return id > 1000; });
    EXPECT_GT(of_new, kSize * kSize / 4);
    EXPECT_LT(of_new, kSize * kSize * 3 / 4);
}

class FadeBorderOfMap : public testing::TestWithParam<std::string> {};

TEST_P(FadeBorderOfMap, StartsAndEndsWithAWholeFoam) {
    Fading fading;
    const auto expect_same = [&](const Frame& frame) {
        const MapOptions options;
        const DistanceNeeds needs = distance_needs(std::vector{GetParam()}, options);
        FrameLayers layers({frame, fading.record, &frame, needs}, test::torus_grid(kSize), 1);
        const MapImage expected = find_map(GetParam()).draw(layers, options);
        std::visit(
            [&](const auto& image) {
                const auto drawn = fading.draw(GetParam());
                EXPECT_EQ(std::get<std::remove_cvref_t<decltype(image)>>(drawn).pixels,
                          image.pixels);
            },
            expected);
    };
    expect_same(fading.out);
    fading.growth.assign(fading.growth.size(), 1.0);
    expect_same(fading.in);
}

TEST_P(FadeBorderOfMap, AShiftIsCyclicToTheBit) {
    const Fading fading = in_the_middle();
    const MapImage still = fading.draw(GetParam());
    const MapImage moved = fading.draw(GetParam(), {}, test::torus_grid(kSize, 37, 91), 2);
    std::visit(
        [&](const auto& image) {
            const auto& other = std::get<std::remove_cvref_t<decltype(image)>>(moved).pixels;
            int differing = 0;
            for (int y = 0; y < kSize; ++y) {
                for (int x = 0; x < kSize; ++x) {
                    differing +=
                        std::ranges::equal(other.pixel(x, y),
                                           image.pixels.pixel((x + 37) % kSize, (y + 91) % kSize))
                            ? 0
                            : 1;
                }
            }
            EXPECT_EQ(differing, 0);
        },
        still);
}

INSTANTIATE_TEST_SUITE_P(Maps,
                         FadeBorderOfMap,
                         testing::Values("albedo",
                                         "lit",
                                         "film",
                                         "distance",
                                         "height",
                                         "normal",
                                         "id",
                                         "motion",
                                         "pressure",
                                         "thin_film"),
                         [](const auto& map) { return map.param; });

// A growing bubble of the radius R shows about a circle of the radius growth R.
TEST(FadeBorder, ABubbleGrowsFromAPoint) {
    Fading fading;
    const auto shown_area = [&](double growth) {
        fading.growth.assign(fading.growth.size(), 0.0);
        fading.growth[3] = growth;
        const Image<std::uint32_t> labels = shown_bubbles(fading);
        return static_cast<double>(
                   std::ranges::count_if(labels.samples(), [](auto id) { return id > 1000; })) *
               fading.in.domain.area() / (kSize * kSize);
    };
    const double whole = fading.in.bubbles[id_at<BubbleId>(3)].area;
    EXPECT_NEAR(shown_area(1.0), whole, 0.05 * whole);
    EXPECT_LT(shown_area(0.1), 0.03 * whole);
    double before = 0.0;
    for (const double growth : {0.3, 0.5, 0.7, 0.9}) {
        const double area = shown_area(growth);
        EXPECT_GT(area, before);
        EXPECT_NEAR(area, growth * growth * whole, 0.15 * whole) << growth;
        before = area;
    }
}

// A film of width 2 whose center line is 1.25 pixels away covers a quarter of the pixel.
TEST(FadeBorder, LinesCoverPartsOfPixels) {
    EXPECT_FLOAT_EQ(line_coverage(0.0, 2.0), 1.0F);
    EXPECT_FLOAT_EQ(line_coverage(1.25, 2.0), 0.25F);
    EXPECT_FLOAT_EQ(line_coverage(-1.25, 2.0), 0.25F);
    EXPECT_FLOAT_EQ(line_coverage(0.0, 0.25), 0.25F);
    EXPECT_FLOAT_EQ(line_coverage(1.5, 2.0), 0.0F);
}

}  // namespace
}  // namespace foam::texgen
