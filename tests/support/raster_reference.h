// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "core/foam/frame.h"
#include "texgen/raster/coords/raster_grid.h"

#include <limits>
#include <memory>
#include <vector>

namespace foam::test {

/// The image of a frame as a brute-force rasterizer computes it: for each pixel, the fraction of
/// its area that each bubble covers, estimated by point samples. Uses no code of texgen/raster,
/// except the type View. Rows are ordered from bottom to top. In a patch, the ghost bubble and the
/// lone bubbles follow the other bubbles, as in CellValues.
struct SampledCoverage {
    int width = 0;
    int height = 0;
    std::vector<std::vector<double>> parts;  // from 0 to 1, by pixel and bubble
};

/// The positions of the samples in a pixel that an edge crosses.
enum class Samples {
    // A Fibonacci lattice of 17,711 points. The error at an edge is about 17711^(-3/4) = 0.0007.
    Lattice,
    // A grid of 64 x 64 points. The error at a horizontal or vertical edge is up to 1/128.
    Grid,
};

/// Samples a foam on a torus. A sample belongs to the bubble on its side of the nearest film, or to
/// no bubble if that film is nearer than half of `film_width` (pixels). Precondition: pixels are
/// square, and the angles of all bubbles at their junctions are less than 180 degrees.
SampledCoverage sample_coverage(const Frame& frame,
                                int width,
                                int height,
                                double film_width,
                                Samples samples = Samples::Lattice);

/// Samples the part of a patch in the view, with Samples::Lattice. Precondition: the angles of all
/// bubbles at their junctions are less than 180 degrees.
SampledCoverage sample_coverage(
    const Frame& frame, const texgen::View& view, int width, int height, double film_width);

/// Finds the nearest film of a point of an image by comparing all films of a frame.
class NearestFilms {
  public:
    /// Prepares the search for a torus. `width` is the width of the image in pixels.
    NearestFilms(const Frame& frame, int width);
    /// Prepares the search for a patch. `width` and `height` are the size of the image in pixels.
    NearestFilms(const Frame& frame, const texgen::View& view, int width, int height);
    ~NearestFilms();
    NearestFilms(const NearestFilms&) = delete;
    NearestFilms& operator=(const NearestFilms&) = delete;

    struct Nearest {
        double distance = std::numeric_limits<double>::infinity();  // pixels
        // The bubble on the point's side of the film. If the nearest point of the film is one of
        // its ends, the bubble on the left of the film.
        BubbleId bubble{};
    };
    /// Returns the nearest film of a point, given in pixels.
    Nearest at(const Vec2& pixel) const;

  private:
    struct Films;
    std::unique_ptr<const Films> films_;
};

}  // namespace foam::test
