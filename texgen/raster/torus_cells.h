#pragma once

#include "core/parallel/counting_sort.h"
#include "texgen/raster/cell_group.h"
#include "texgen/raster/coords/pixel_frame.h"
#include "texgen/raster/film_steps.h"

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>

namespace foam::texgen {

/// The bubbles of a frame on a torus in the order of the plane, ready to be gone around. Borrows
/// the frame.
class TorusCells {
  public:
    /// Rows of a band, but for the last one. Bands, as the order, are of the unshifted grid.
    static constexpr int kBandRows = 128;

    /// The same for any number of threads. Throws std::invalid_argument as pixels_per_unit does.
    TorusCells(const Frame& frame, const RasterGrid& grid, int threads);

    TorusCells(const TorusCells&) = delete;
    TorusCells& operator=(const TorusCells&) = delete;

    int bands() const { return (grid_.height - 1) / kBandRows + 1; }
    /// Those of which the first side begins within a band; neighbours mostly follow each other.
    std::span<const TorusBubble> bubbles(int band) const;
    /// By their index.
    const FilmStep* films() const { return films_.get(); }

    /// How far a copy one period up lies to the right; subpixels.
    std::int32_t shear() const { return pixels_.shear; }

  private:
    struct Start {
        TorusBubble bubble;
        std::size_t square = 0;
    };

    Buckets<TorusBubble> ordered_bubbles(int threads) const;
    void find_starts(std::size_t first, std::span<Start> starts) const;

    RasterGrid grid_;
    PixelFrame pixels_;
    std::size_t square_columns_;
    std::vector<SubpixelPoint> junctions_;
    std::unique_ptr<FilmStep[]> films_;
    Buckets<TorusBubble> bubbles_;  // by squares of the grid, row by row
};

}  // namespace foam::texgen
