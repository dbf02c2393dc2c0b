// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "core/parallel/counting_sort.h"
#include "texgen/raster/arcs/monotone_arc.h"

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace foam::texgen {

/// The rows of an image, divided into bands, and the arcs that overlap each band. Arcs are moved
/// by the shift of the grid and wrapped around the torus. Within a band, arcs are sorted by tiles
/// from left to right, so that the sums to which an arc adds are mostly cached for the next arc.
class ArcBands {
  public:
    /// A copy of an arc, shifted, and on a torus moved up or down by whole periods. Its y is
    /// relative to row 0 of the image.
    struct Entry {
        const MonotoneArc* arc = nullptr;
        SubpixelPoint translation;
    };

    /// Sorts the arcs, which are borrowed. `rows_per_band` is rounded up to a power of two. The
    /// result is the same for any number of threads.
    ArcBands(const CellArcs& cells, int rows_per_band, int threads);

    /// Returns the number of bands.
    int count() const { return ((grid_.height - 1) >> row_bits_) + 1; }
    int first_row(int band) const { return band << row_bits_; }
    int row_count(int band) const;
    /// Returns the copies of arcs that overlap a band, sorted by tiles.
    std::span<const Entry> entries(int band) const {
        const std::size_t first = static_cast<std::size_t>(band) * tiles_;
        return entries_.of(first, first + tiles_);
    }

  private:
    using Batches = std::span<const std::vector<MonotoneArc>>;

    // Calls visit(entry, tile) for each copy of an arc and each band that it overlaps. Tiles are
    // numbered consecutively through all bands.
    template <class Visit>
    void visit_tiles(Batches batches, const Visit& visit) const;
    // Both call visit(entry, band) for each band that a copy overlaps: visit_copies for all copies
    // of all arcs, visit_bands for one copy.
    template <class Visit>
    void visit_copies(Batches batches, const Visit& visit) const;
    template <class Visit>
    void visit_bands(const Entry& entry, const Visit& visit) const;
    std::size_t tile_of(const Entry& entry) const;

    RasterGrid grid_;
    std::int32_t shear_;
    int row_bits_;
    std::size_t tiles_;       // tiles per band
    Buckets<Entry> entries_;  // one bucket per tile of all bands
};

}  // namespace foam::texgen
