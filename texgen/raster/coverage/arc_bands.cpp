// SPDX-License-Identifier: Apache-2.0

#include "texgen/raster/coverage/arc_bands.h"

#include <algorithm>
#include <bit>

// Bands and tiles are buckets as in the Reyes architecture (R. L. Cook, L. Carpenter and E.
// Catmull, "The Reyes image rendering architecture", 1987): the arcs are first assigned to parts of
// the image. Threads draw the bands; tiles only order the arcs of a band. A stable counting sort
// (D. E. Knuth, "The Art of Computer Programming", volume 3, 5.2) makes the lists in linear time
// and on all threads. An arc that overlaps several bands is in the list of each of them, so that
// threads draw bands without sharing any sums.

namespace foam::texgen {

namespace {

constexpr int kTileBits = 6;        // a tile is 2^6 columns wide
constexpr int kPartsPerThread = 4;  // parts of the counting sort, per thread

}  // namespace

ArcBands::ArcBands(const CellArcs& cells, int rows_per_band, int threads)
    : grid_(cells.grid),
      shear_(cells.shear),
      row_bits_(static_cast<int>(std::bit_width(static_cast<unsigned>(rows_per_band - 1)))),
      tiles_(static_cast<std::size_t>((grid_.width - 1) >> kTileBits) + 1) {
    const std::size_t all = cells.batches.size();
    const auto wanted = static_cast<std::size_t>(threads > 1 ? kPartsPerThread * threads : 1);
    const std::size_t parts = std::max(std::min(wanted, all), std::size_t{1});
    const auto batches_of = [&](std::size_t part) {
        const std::size_t begin = all * part / parts;
        return std::span(cells.batches).subspan(begin, all * (part + 1) / parts - begin);
    };
    entries_ = counting_sort<Entry>(
        static_cast<std::size_t>(count()) * tiles_,
        parts,
        threads,
        [&](std::size_t part, const auto& put) {
            visit_tiles(batches_of(part),
                        [&](const Entry& entry, std::size_t tile) { put(tile, entry); });
        });
}

int ArcBands::row_count(int band) const {
    return std::min(1 << row_bits_, grid_.height - first_row(band));
}

// Returns the tile, within its band, that contains the x of the lower end of an arc. On a torus the
// column is wrapped: outlines of bubbles are continued beyond the border of the torus, so arcs may
// be several periods to the left or right of the image. In the plane the column is clamped.
std::size_t ArcBands::tile_of(std::int32_t x) const {
    int column = pixel_of(x);
    if (grid_.view) {
        column = std::clamp(column, 0, grid_.width - 1);
    } else if (column < 0 || column >= grid_.width) {
        column = wrap(column, grid_.width);
    }
    return static_cast<std::size_t>(column >> kTileBits);
}

template <class Visit>
void ArcBands::visit_tiles(std::span<const std::vector<MonotoneArc>> batches,
                           const Visit& visit) const {
    const auto visit_copy = [&](const MonotoneArc& arc, SubpixelPoint translation) {
        const int bits = kSubpixelBits + row_bits_;
        const int low = std::max((arc.low.y + translation.y) >> bits, 0);
        const int high = std::min((arc.high.y + translation.y - 1) >> bits, count() - 1);
        const std::size_t tile = tile_of(arc.low.x + translation.x);
        for (int band = low; band <= high; ++band) {
            visit(Entry{&arc, translation}, static_cast<std::size_t>(band) * tiles_ + tile);
        }
    };
    const SubpixelPoint shift = shift_of(grid_);
    const std::int32_t period = grid_.height * kSubpixel;
    for (const std::vector<MonotoneArc>& batch : batches) {
        for (const MonotoneArc& arc : batch) {
            if (grid_.view) {
                visit_copy(arc, {});
                continue;
            }
            const std::int32_t high = arc.high.y + shift.y;
            for (int k = floor_div(arc.low.y + shift.y, period); k * period < high; ++k) {
                visit_copy(arc, {shift.x - k * shear_, shift.y - k * period});
            }
        }
    }
}

}  // namespace foam::texgen
