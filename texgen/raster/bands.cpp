#include "texgen/raster/bands.h"

#include <algorithm>
#include <bit>

namespace foam::texgen {

namespace {

std::vector<RegionExtent> extents_of(const CellOutlines& cells) {
    std::vector<RegionExtent> extents;
    extents.reserve(cells.outlines.size());
    for (const Outline& outline : cells.outlines) {
        extents.push_back({cells.chain(outline).front(), outline.lowest, outline.highest});
    }
    return extents;
}

}  // namespace

PixelBox box_around(const RegionExtent& region, SubpixelPoint translation) {
    const SubpixelPoint low = region.lowest + translation;
    const SubpixelPoint high = region.highest + translation;
    return {pixel_of(low.x), pixel_of(high.x) + 1, pixel_of(low.y), pixel_of(high.y) + 1};
}

Bands::Bands(const CellOutlines& cells, int rows_per_band)
    : Bands(cells.grid, cells.shear, extents_of(cells), rows_per_band) {}

Bands::Bands(const RasterGrid& grid,
             std::int32_t shear,
             std::span<const RegionExtent> regions,
             int rows_per_band)
    : grid_(grid),
      shear_(shear),
      row_bits_(static_cast<int>(std::bit_width(static_cast<unsigned>(rows_per_band - 1)))),
      ends_(static_cast<std::size_t>((grid_.height - 1) >> row_bits_) + 2) {
    const auto visit_all = [&](const auto& visit) {
        for (std::size_t k = 0; k < regions.size(); ++k) {
            for_each_copy(grid_, shear_, regions[k], [&](SubpixelPoint by) {
                visit_bands({static_cast<std::uint32_t>(k), by}, regions[k], visit);
            });
        }
    };
    visit_all([&](const Entry&, std::size_t band) { ++ends_[band + 1]; });
    for (std::size_t band = 1; band < ends_.size(); ++band) {
        ends_[band] += ends_[band - 1];
    }
    entries_.resize(ends_.back());
    std::vector<std::size_t> next(ends_.begin(), ends_.end() - 1);
    visit_all([&](const Entry& entry, std::size_t band) { entries_[next[band]++] = entry; });
}

int Bands::row_count(int band) const {
    return std::min(1 << row_bits_, grid_.height - first_row(band));
}

std::span<const Bands::Entry> Bands::entries(int band) const {
    const auto k = static_cast<std::size_t>(band);
    return std::span(entries_).subspan(ends_[k], ends_[k + 1] - ends_[k]);
}

template <class Visit>
void Bands::visit_bands(const Entry& entry, const RegionExtent& region, const Visit& visit) const {
    const int low = std::max(band_of(region.lowest.y + entry.translation.y), 0);
    const int high = std::min(band_of(region.highest.y + entry.translation.y), count() - 1);
    for (int band = low; band <= high; ++band) {
        visit(entry, static_cast<std::size_t>(band));
    }
}

}  // namespace foam::texgen
