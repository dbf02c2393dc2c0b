// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "tests/bench/raster_peers/scene.h"

#include <functional>
#include <string>
#include <vector>

namespace foam::bench {

/// Another program that fills cells, and strokes films over them if it can; 8 bits a channel,
/// antialiased, one thread. Images begin black.
struct Painter {
    std::string name;
    std::function<void(const Scene&)> fill;
    std::function<void(const Scene&)> fill_and_films;
    /// What was drawn last; rows upward.
    std::function<texgen::Image<std::uint8_t>()> image;
};

/// Another program that finds the distance from each pixel of a mask to the nearest that is 0.
struct DistanceTransform {
    std::string name;
    std::function<void(const texgen::Image<std::uint8_t>& mask)> transform;
};

/// Those that were built in, for images of this side.
std::vector<Painter> painters(int side);
std::vector<DistanceTransform> distance_transforms(int side);

std::vector<Painter> cairo_painters(int side);
Painter agg_painter(int side);
DistanceTransform opencv_transform(int side);

}  // namespace foam::bench
