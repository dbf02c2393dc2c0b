// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "tests/bench/raster_peers/scene.h"

#include <functional>
#include <string>
#include <vector>

namespace foam::bench {

/// A library that fills cells and, if it can, strokes films over them (`fill_and_films`, otherwise
/// empty). Images have 8 bits per channel and are antialiased. They are drawn on one thread over
/// black.
struct Painter {
    std::string name;
    std::function<void(const Scene&)> fill;
    std::function<void(const Scene&)> fill_and_films;
    /// Returns the image that was drawn last. Rows are ordered from bottom to top.
    std::function<texgen::Image<std::uint8_t>()> image;
};

/// A library that computes the distance from each pixel of a mask to the nearest pixel whose value
/// is 0.
struct DistanceTransform {
    std::string name;
    std::function<void(const texgen::Image<std::uint8_t>& mask)> transform;
};

/// Returns the painters that were compiled in, for images of `side` x `side` pixels.
std::vector<Painter> painters(int side);
/// Returns the distance transforms that were compiled in, for images of `side` x `side` pixels.
std::vector<DistanceTransform> distance_transforms(int side);

// These functions are defined only if their library was found when CMake was configured.
std::vector<Painter> cairo_painters(int side);
Painter agg_painter(int side);
DistanceTransform opencv_transform(int side);

}  // namespace foam::bench
