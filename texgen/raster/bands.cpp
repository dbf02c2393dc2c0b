#include "texgen/raster/bands.h"

#include <algorithm>

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
    : rows_(rows_per_band),
      grid_(cells.grid),
      ends_(static_cast<std::size_t>((grid_.height + rows_ - 1) / rows_) + 1) {
    for_each_entry(cells, [&](std::size_t band, const Entry&) { ++ends_[band + 1]; });
    for (std::size_t band = 1; band < ends_.size(); ++band) {
        ends_[band] += ends_[band - 1];
    }
    entries_.resize(ends_.back());
    std::vector<std::size_t> next(ends_.begin(), ends_.end() - 1);
    for_each_entry(cells,
                   [&](std::size_t band, const Entry& entry) { entries_[next[band]++] = entry; });
}

int Bands::row_count(int band) const {
    return std::min(rows_, grid_.height - first_row(band));
}

std::span<const Bands::Entry> Bands::entries(int band) const {
    const auto k = static_cast<std::size_t>(band);
    return std::span(entries_).subspan(ends_[k], ends_[k + 1] - ends_[k]);
}

template <class Visit>
void Bands::for_each_entry(const CellOutlines& cells, Visit visit) const {
    for (std::size_t k = 0; k < cells.outlines.size(); ++k) {
        const Outline& outline = cells.outlines[k];
        if (grid_.view) {
            visit_rows(k, outline, {}, visit);
            continue;
        }
        const SubpixelPoint first_point = cells.chain(outline).front();
        const SubpixelPoint shift = shift_of(grid_);
        const int low = pixel_of(outline.lowest + shift.y);
        const int high = pixel_of(outline.highest + shift.y);
        for (int period = floor_div(low, grid_.height); period * grid_.height <= high; ++period) {
            const std::int32_t base = period * grid_.height * kSubpixel;
            const SubpixelPoint moved{shift.x - period * cells.shear, shift.y - base};
            visit_rows(k, outline, into_columns(grid_, first_point, moved), visit);
        }
    }
}

template <class Visit>
void Bands::visit_rows(std::size_t index,
                       const Outline& outline,
                       SubpixelPoint translation,
                       Visit visit) const {
    const int low = std::max(pixel_of(outline.lowest + translation.y), 0);
    const int high = std::min(pixel_of(outline.highest + translation.y), grid_.height - 1);
    if (low > high) {
        return;
    }
    for (int band = low / rows_; band <= high / rows_; ++band) {
        visit(static_cast<std::size_t>(band), Entry{index, translation});
    }
}

}  // namespace foam::texgen
