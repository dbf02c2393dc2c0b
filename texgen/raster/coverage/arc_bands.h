#pragma once

#include "core/parallel/counting_sort.h"
#include "texgen/raster/arcs/monotone_arc.h"

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace foam::texgen {

/// The rows of an image, divided into bands, and the arcs that reach into each band, shifted by the
/// grid and wrapped around the torus. Within a band arcs are sorted by tiles from left to right, so
/// that the sums that one of them adds to are mostly cached for the next.
class ArcBands {
  public:
    /// A copy of an arc: shifted, and on a torus moved up or down by whole periods. Its y is
    /// relative to row 0 of the image.
    struct Entry {
        const MonotoneArc* arc = nullptr;
        SubpixelPoint translation;
    };

    /// Borrows the arcs. `rows_per_band` is rounded up to a power of two. The result is the same
    /// for any number of threads.
    ArcBands(const CellArcs& cells, int rows_per_band, int threads);

    int count() const { return ((grid_.height - 1) >> row_bits_) + 1; }
    int first_row(int band) const { return band << row_bits_; }
    int row_count(int band) const;
    std::span<const Entry> entries(int band) const {
        const std::size_t first = static_cast<std::size_t>(band) * tiles_;
        return entries_.of(first, first + tiles_);
    }

  private:
    using Batches = std::span<const std::vector<MonotoneArc>>;

    // Calls visit(entry, tile) for all copies of the arcs; tiles are numbered through all bands.
    template <class Visit>
    void visit_tiles(Batches batches, const Visit& visit) const;
    template <class Visit>
    void visit_copies(Batches batches, const Visit& visit) const;
    template <class Visit>
    void visit_bands(const Entry& entry, const Visit& visit) const;
    std::size_t tile_of(const Entry& entry) const;

    RasterGrid grid_;
    std::int32_t shear_;
    int row_bits_;
    std::size_t tiles_;       // of a band
    Buckets<Entry> entries_;  // by the tiles of all bands
};

}  // namespace foam::texgen
