// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "core/parallel/counting_sort.h"
#include "texgen/raster/arcs/monotone_arc.h"

#include <cstdint>
#include <span>
#include <vector>

namespace foam::texgen {

/// The rows of an image, divided into bands, and for each band a list of the arcs that overlap it.
/// On a torus, arcs are moved by the shift of the grid (shift_of) and wrapped in y. The arcs of a
/// band are sorted by tile, that is, by the range of columns that contains the lower end of the
/// arc. When a band is drawn (Coverage), successive arcs therefore change nearby pixels, most of
/// which are already in the processor's cache.
class ArcBands {
  public:
    /// A copy of an arc, moved by a translation to its position in the image. On a torus, the
    /// translation is the shift of the grid plus a number of periods up or down; in the plane it is
    /// zero.
    struct Entry {
        const MonotoneArc* arc = nullptr;
        SubpixelPoint translation;
    };

    /// Sorts the arcs of `cells`, which must outlive this object. `rows_per_band` is rounded up to
    /// a power of two. The result does not depend on the number of threads.
    ArcBands(const CellArcs& cells, int rows_per_band, int threads);

    /// Returns the number of bands.
    int count() const { return ((grid_.height - 1) >> row_bits_) + 1; }
    /// Return the lowest row of a band, and the number of its rows.
    int first_row(int band) const { return band << row_bits_; }
    int row_count(int band) const;
    /// Returns the copies of arcs that overlap a band, sorted by tile.
    std::span<const Entry> entries(int band) const {
        const std::size_t first = static_cast<std::size_t>(band) * tiles_;
        return entries_.items_of(first, first + tiles_);
    }

  private:
    // Calls visit(entry, tile) for each copy of an arc and each band that the copy overlaps. `tile`
    // numbers the tiles of all bands: from left to right within a band, and from band to band.
    template <class Visit>
    void visit_tiles(std::span<const std::vector<MonotoneArc>> batches, const Visit& visit) const;
    std::size_t tile_of(std::int32_t x) const;

    RasterGrid grid_;
    std::int32_t shear_;
    int row_bits_;            // a band has 2^row_bits_ rows; the last band may have fewer
    std::size_t tiles_;       // tiles per band
    Buckets<Entry> entries_;  // one bucket per tile, for the tiles of all bands
};

}  // namespace foam::texgen
