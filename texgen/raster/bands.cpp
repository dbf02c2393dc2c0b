#include "texgen/raster/bands.h"

#include <algorithm>
#include <bit>

namespace foam::texgen {

namespace {

SubpixelPoint shift_of(const RasterGrid& grid) {
    return {-wrap(grid.shift_x, grid.width) * kSubpixel,
            -wrap(grid.shift_y, grid.height) * kSubpixel};
}

// Moves an outline by whole periods along x, so that its first point lies within the grid's
// columns.
SubpixelPoint into_columns(const RasterGrid& grid, SubpixelPoint first, SubpixelPoint moved) {
    const std::int32_t period = grid.width * kSubpixel;
    return {moved.x - floor_div(first.x + moved.x, period) * period, moved.y};
}

}  // namespace

Bands::Bands(const CellOutlines& cells, int rows_per_band)
    : grid_(cells.grid),
      row_bits_(static_cast<int>(std::bit_width(static_cast<unsigned>(rows_per_band - 1)))),
      ends_(static_cast<std::size_t>((grid_.height - 1) >> row_bits_) + 2) {
    Found found;
    for (std::size_t k = 0; k < cells.outlines.size(); ++k) {
        find_copies(cells, k, found);
    }
    sort(found);
}

int Bands::row_count(int band) const {
    return std::min(1 << row_bits_, grid_.height - first_row(band));
}

std::span<const Bands::Entry> Bands::entries(int band) const {
    const auto k = static_cast<std::size_t>(band);
    return std::span(entries_).subspan(ends_[k], ends_[k + 1] - ends_[k]);
}

// By bands, within each as they were found.
void Bands::sort(const Found& found) {
    for (const BandEntry& one : found) {
        ++ends_[one.band + 1];
    }
    for (std::size_t band = 1; band < ends_.size(); ++band) {
        ends_[band] += ends_[band - 1];
    }
    entries_.resize(ends_.back());
    std::vector<std::size_t> next(ends_.begin(), ends_.end() - 1);
    for (const BandEntry& one : found) {
        entries_[next[one.band]++] = one.entry;
    }
}

void Bands::find_copies(const CellOutlines& cells, std::size_t index, Found& found) const {
    const Outline& outline = cells.outlines[index];
    if (grid_.view) {
        find_bands(cells, {index, {}}, found);
        return;
    }
    const SubpixelPoint first_point = cells.chain(outline).front();
    const SubpixelPoint shift = shift_of(grid_);
    const int low = pixel_of(outline.lowest.y + shift.y);
    const int high = pixel_of(outline.highest.y + shift.y);
    for (int period = floor_div(low, grid_.height); period * grid_.height <= high; ++period) {
        const std::int32_t base = period * grid_.height * kSubpixel;
        const SubpixelPoint moved{shift.x - period * cells.shear, shift.y - base};
        const SubpixelPoint translation = into_columns(grid_, first_point, moved);
        find_bands(cells, {index, translation}, found);
    }
}

void Bands::find_bands(const CellOutlines& cells, const Entry& whole, Found& found) const {
    const Outline& outline = cells.outlines[whole.outline];
    const int low = std::max(band_of(outline.lowest.y + whole.translation.y), 0);
    const int high = std::min(band_of(outline.highest.y + whole.translation.y), count() - 1);
    for (int band = low; band <= high; ++band) {
        found.push_back({static_cast<std::size_t>(band), whole});
    }
}

}  // namespace foam::texgen
