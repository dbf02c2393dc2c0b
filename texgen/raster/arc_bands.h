#pragma once

#include "core/parallel/counting_sort.h"
#include "texgen/raster/cell_arcs.h"

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace foam::texgen {

/// The rows of an image, cut into bands that are filled one by one, and for each band the arcs that
/// reach into it; around a torus, and shifted as the grid says. Within a band they go from left to
/// right by tiles, so that what one of them adds to is mostly still in a cache for the next.
class ArcBands {
  public:
    /// A copy of an arc: shifted, and on a torus moved up and down by whole periods; y counts from
    /// the image's row 0.
    struct Entry {
        const CellArc* arc = nullptr;
        SubpixelPoint translation;
    };

    /// Borrows the arcs. The rows are rounded up to a power of two. The same for any number of
    /// threads.
    ArcBands(const CellArcs& cells, int rows_per_band, int threads);

    int count() const { return ((grid_.height - 1) >> row_bits_) + 1; }
    int first_row(int band) const { return band << row_bits_; }
    int row_count(int band) const;
    std::span<const Entry> entries(int band) const {
        const std::size_t first = static_cast<std::size_t>(band) * tiles_;
        return entries_.of(first, first + tiles_);
    }

  private:
    using Batches = std::span<const std::vector<CellArc>>;

    // Calls visit(entry, tile) for all copies of the arcs, by the tiles of all bands.
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
