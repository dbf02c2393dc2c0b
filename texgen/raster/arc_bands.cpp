#include "texgen/raster/arc_bands.h"

#include <algorithm>
#include <bit>

namespace foam::texgen {

namespace {

constexpr int kTileBits = 6;  // of columns

}  // namespace

ArcBands::ArcBands(const CellArcs& cells, int rows_per_band)
    : grid_(cells.grid),
      row_bits_(static_cast<int>(std::bit_width(static_cast<unsigned>(rows_per_band - 1)))),
      tiles_(static_cast<std::size_t>((grid_.width - 1) >> kTileBits) + 1),
      ends_(static_cast<std::size_t>(count()) * tiles_ + 1) {
    visit_copies(cells, [&](const Entry& entry, std::size_t band) {
        ++ends_[band * tiles_ + tile_of(entry) + 1];
    });
    for (std::size_t k = 1; k < ends_.size(); ++k) {
        ends_[k] += ends_[k - 1];
    }
    entries_.resize(ends_.back());
    std::vector<std::size_t> next(ends_.begin(), ends_.end() - 1);
    visit_copies(cells, [&](const Entry& entry, std::size_t band) {
        entries_[next[band * tiles_ + tile_of(entry)]++] = entry;
    });
}

int ArcBands::row_count(int band) const {
    return std::min(1 << row_bits_, grid_.height - first_row(band));
}

std::span<const ArcBands::Entry> ArcBands::entries(int band) const {
    const std::size_t k = static_cast<std::size_t>(band) * tiles_;
    return std::span(entries_).subspan(ends_[k], ends_[k + tiles_] - ends_[k]);
}

// By its lower end; arcs of unwrapped outlines lie some periods to the left or right.
std::size_t ArcBands::tile_of(const Entry& entry) const {
    int column = pixel_of(entry.arc->low.x + entry.translation.x);
    if (grid_.view) {
        column = std::clamp(column, 0, grid_.width - 1);
    } else if (column < 0 || column >= grid_.width) {
        column = wrap(column, grid_.width);
    }
    return static_cast<std::size_t>(column >> kTileBits);
}

template <class Visit>
void ArcBands::visit_copies(const CellArcs& cells, const Visit& visit) const {
    const SubpixelPoint shift{-wrap(grid_.shift_x, grid_.width) * kSubpixel,
                              -wrap(grid_.shift_y, grid_.height) * kSubpixel};
    const std::int32_t period = grid_.height * kSubpixel;
    for (const std::vector<CellArc>& batch : cells.batches) {
        for (const CellArc& arc : batch) {
            if (grid_.view) {
                visit_bands({&arc, {}}, visit);
                continue;
            }
            const std::int32_t high = arc.high.y + shift.y;
            for (int k = floor_div(arc.low.y + shift.y, period); k * period < high; ++k) {
                visit_bands({&arc, {shift.x - k * cells.shear, shift.y - k * period}}, visit);
            }
        }
    }
}

template <class Visit>
void ArcBands::visit_bands(const Entry& entry, const Visit& visit) const {
    const int bits = kSubpixelBits + row_bits_;
    const int low = std::max((entry.arc->low.y + entry.translation.y) >> bits, 0);
    const int high = std::min((entry.arc->high.y + entry.translation.y - 1) >> bits, count() - 1);
    for (int band = low; band <= high; ++band) {
        visit(entry, static_cast<std::size_t>(band));
    }
}

}  // namespace foam::texgen
