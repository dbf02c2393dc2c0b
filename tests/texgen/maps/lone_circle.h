// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "tests/support/sample_foams.h"
#include "texgen/maps/albedo_options.h"
#include "texgen/maps/frame_layers.h"

#include <numbers>

namespace foam::texgen::test {

inline constexpr int kCircleImage = 64;  // width and height of the image, pixels

/// A frame of one lone bubble of radius 1 and identity 7 in the middle of a square image. The mean
/// bubble of the frame is this bubble.
struct LoneCircle {
    explicit LoneCircle(double radius_in_pixels)
        : layers({frame,
                  record,
                  nullptr,
                  {.gradient = true, .smooth = SmoothImages::DistanceAndGradient}},
                 {kCircleImage, kCircleImage, 0, 0, View{Vec2::Zero(), radius_in_pixels}},
                 1) {}

    Frame frame = snapshot(foam::test::circles({{7, {0.0, 0.0}, std::numbers::pi}}), 1);
    FoamRecord record;
    FrameLayers layers;
};

/// Returns the center of a pixel relative to the middle of the image.
inline Vec2 from_middle(int x, int y) {
    return Vec2(x + 0.5 - 0.5 * kCircleImage, y + 0.5 - 0.5 * kCircleImage);
}

/// Calls visit(x, y, from_middle(x, y)) for every pixel whose center is at least one pixel inside a
/// circle in the middle of the image.
template <class Visit>
void for_each_inside(double radius, const Visit& visit) {
    for (int y = 0; y < kCircleImage; ++y) {
        for (int x = 0; x < kCircleImage; ++x) {
            if (from_middle(x, y).norm() < radius - 1.0) {
                visit(x, y, from_middle(x, y));
            }
        }
    }
}

inline double sum_of(const Image<float>& image) {
    double sum = 0.0;
    for (const float sample : image.samples()) {
        sum += static_cast<double>(sample);
    }
    return sum;
}

// Returns the options for a film width in pixels.
inline AlbedoOptions films_of(double pixels) {
    AlbedoOptions options;
    options.film_width = pixels;
    return options;
}

}  // namespace foam::texgen::test
