// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "core/foam/frame.h"
#include "texgen/raster/coords/raster_grid.h"

#include <limits>
#include <memory>
#include <vector>

namespace foam::test {

/// What a brute-force rasterizer makes of a frame: for each pixel (rows upward) the part of it that
/// each bubble shows, by point samples. Shares no code with the rasterizer.
/// Of a patch, what lies around it and lone bubbles follow as in CellValues.
struct SampledCoverage {
    int width = 0;
    int height = 0;
    std::vector<std::vector<double>> parts;  // per pixel, per bubble, in [0, 1]
};

/// Where the samples of a pixel that an edge crosses lie.
enum class Samples {
    Lattice,  // of Fibonacci: 17,711, whose error along an edge is about 17711^-3/4 = 0.0007
    Grid,     // 64 x 64, in error by up to 1/128 along an edge that is level or upright
};

/// A sample belongs to the bubble on its side of the film that is nearest to it, unless that is
/// nearer than half of film_width (pixels). Precondition: square pixels; corners of less than 180
/// degrees.
SampledCoverage sample_coverage(const Frame& frame,
                                int width,
                                int height,
                                double film_width,
                                Samples samples = Samples::Lattice);

/// The same of a part of the plane.
SampledCoverage sample_coverage(
    const Frame& frame, const texgen::View& view, int width, int height, double film_width);

/// All films of a frame, as pixels see them: where the nearest one is.
class NearestFilms {
  public:
    NearestFilms(const Frame& frame, int width);  // of the image, pixels
    NearestFilms(const Frame& frame, const texgen::View& view, int width, int height);
    ~NearestFilms();
    NearestFilms(const NearestFilms&) = delete;
    NearestFilms& operator=(const NearestFilms&) = delete;

    struct Nearest {
        double distance = std::numeric_limits<double>::infinity();  // pixels
        BubbleId bubble{};  // on the point's side, unless it is beyond the film's ends
    };
    Nearest at(const Vec2& pixel) const;

  private:
    struct Films;
    std::unique_ptr<const Films> films_;
};

}  // namespace foam::test
