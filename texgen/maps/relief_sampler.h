// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "core/geometry/vec2.h"
#include "texgen/maps/pixel_neighbors.h"
#include "texgen/maps/relief.h"
#include "texgen/maps/relief_points.h"
#include "texgen/maps/visible_sky.h"

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace foam::texgen {

/// Computes the relief at points within pixels. Borrows everything that it is constructed from.
class ReliefSampler {
  public:
    /// `slopes` are the slopes of the relief at the centers of pixels.
    ReliefSampler(const Relief& relief,
                  const PixelSlopes& slopes,
                  const SkyLookup& sky,
                  const PixelNeighbors& neighbors);

    /// Chooses the pixels at which `write` computes the relief. `pixels` are their indices
    /// (PixelNeighbors).
    void choose(std::span<const std::uint32_t> pixels);
    /// Writes the relief at one point of each chosen pixel. `offset`, the same for all pixels, is
    /// the position of the point relative to the center of its pixel, in pixels. Precondition: the
    /// spans of `to` have as many elements as there are chosen pixels.
    void write(const Vec2& offset, const ReliefPoints<float>& to) const;

  private:
    /// The numbers from which the relief near the centers of the chosen pixels is computed. Each
    /// array has one number per pixel.
    struct Pixels {
        std::vector<float> unit;      // Relief::unit
        std::vector<float> distance;  // the smooth distance in pixels
        std::vector<float> x;         // the gradient of the smooth distance
        std::vector<float> y;
        std::vector<float> xx;  // the second derivatives of the smooth distance
        std::vector<float> xy;
        std::vector<float> yy;
        std::vector<float> grain_x;  // the slope of the grain
        std::vector<float> grain_y;

        void resize(std::size_t count);
    };
    void set_distance(std::size_t k, std::size_t pixel);
    void set_grain(std::size_t k, std::size_t pixel);

    const Relief& relief_;
    const PixelSlopes& slopes_;
    SkyLookup sky_;
    const PixelNeighbors& neighbors_;
    Pixels chosen_;
};

}  // namespace foam::texgen
