#pragma once

#include "texgen/raster/coords/pixel_frame.h"
#include "texgen/raster/distance/distance_arc.h"
#include "texgen/raster/distance/region.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace foam::texgen {

/// The bubbles of a frame on a torus as a grid sees them. Borrows both.
///
/// Bubbles and films are sorted by the square of the unshifted grid in which they begin, row by
/// row: what a boundary is made of is then close together in memory.
class TorusRegions {
  public:
    TorusRegions(const Frame& frame, const RasterGrid& grid, int threads);

    const std::vector<Region>& regions() const { return regions_; }

    /// Appends the boundary of a region, moved by an offset.
    void trace(std::size_t region, SubpixelPoint offset, Boundary& boundary) const;

    /// Returns the distance in subpixels by which a copy one period up is moved to the right.
    std::int32_t shear() const { return pixels_.shear; }

  private:
    // What the boundaries on both sides of a film need of it, in one cache line. Pairs are of the
    // forward side and of the other one.
    struct alignas(64) Film {
        PixelArc shape;  // of the forward side
        std::array<SubpixelPoint, 2> tails;
        std::array<std::uint32_t, 2> next{};  // sides: twice the position of a film, plus 1 if it
                                              // is the other side
        SubpixelPoint lift;  // from the head's junction to its copy that the tail sees
    };
    static_assert(sizeof(Film) == 64);

    // The start of a counter-clockwise traversal of a bubble.
    struct Start {
        std::uint32_t side = 0;
        Vec2 tail{0.0, 0.0};  // without rounding, pixels
    };

    std::vector<std::uint32_t> sorted(const std::vector<JunctionId>& begins, int threads) const;
    void place_films(int threads);
    void place_bubbles(int threads);
    std::uint32_t side_of(HalfEdgeId side) const {
        return 2 * positions_[index_of(film_of(side))] + (is_forward(side) ? 0 : 1);
    }

    PixelFrame pixels_;
    std::vector<SubpixelPoint> junctions_;
    std::vector<std::uint32_t> positions_;  // of films, by their index
    std::vector<Film> films_;
    std::vector<Start> starts_;  // of the regions
    std::vector<Region> regions_;
};

}  // namespace foam::texgen
