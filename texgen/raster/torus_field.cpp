#include "texgen/raster/torus_field.h"

#include "core/parallel/parallel_for.h"
#include "texgen/raster/cell_place.h"
#include "texgen/raster/field_rows.h"
#include "texgen/raster/field_writer.h"
#include "texgen/raster/kept_cells.h"
#include "texgen/raster/small_cell.h"
#include "texgen/raster/torus_cells.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <utility>
#include <vector>

namespace foam::texgen {

namespace {

constexpr int kBandRows = TorusCells::kBandRows;

// The cells of a band that do not lie within its rows.
struct Beyond {
    KeptCells below;  // but within half a band of its lower end
    KeptCells above;
    KeptCells others;
};

FieldRows rows_from(int row) {
    return {row, row + kBandRows};
}

// In the unshifted grid, where its first side begins within the rows.
PixelBox box_in_grid(const TorusCell& cell, int height) {
    const std::int32_t period = height * kSubpixel;
    return box_around(cell.extent, {0, cell.extent.first.y < period ? 0 : -period});
}

// Paints cells one by one. Keeps its working memory from one to the next.
class CellPainter {
  public:
    CellPainter(const TorusCells& cells,
                const RasterGrid& grid,
                DistanceNeeds needs,
                DistanceField& field)
        : cells_(cells), grid_(grid), needs_(needs), writer_(needs, field) {}

    // The bubbles of a band that lie within its rows. While those of a group are painted, what the
    // next ones are made of is on its way.
    void paint_within(int band, Beyond& beyond) {
        std::span<const TorusBubble> bubbles = cells_.bubbles(band);
        CellGroup* group = groups_.data();
        CellGroup* next = group + 1;
        for (next->begin(bubbles, cells_.films()); !bubbles.empty();) {
            std::swap(group, next);
            const std::span<const TorusCell> cells = group->cells();
            bubbles = bubbles.subspan(cells.size());
            next->begin(bubbles, cells_.films());
            for (const TorusCell& cell : cells) {
                paint_within(band, cell, beyond);
                next->advance();
            }
        }
    }

    // A cell, in all its copies.
    void paint(const TorusCell& cell) {
        for_each_copy(grid_, cells_.shear(), cell.extent, [&](SubpixelPoint by) {
            paint(cell, by, {0, grid_.height});
        });
    }

    // What of a copy lies in some rows of the image.
    void paint(const TorusCell& cell, SubpixelPoint by, const FieldRows& rows) {
        const FieldWindow window(box_around(cell.extent, by), rows);
        const PixelBox& box = window.box;
        const ImagePlace place{wrap(box.left, grid_.width), box.bottom};
        const auto id = static_cast<std::uint32_t>(index_of(cell.bubble));
        const CellPlace at{by, window.corner(), window.mask_corner()};
        writer_.expect(place, box.columns(), window.wanted.begin, window.wanted.end);
        if (small_.place(cell.sides, at, {box.columns(), box.rows(), window.wanted})) {
            writer_.write(small_.measure(needs_), place, id);
            return;
        }
        window.reset(mask_);
        place_cell(cell.sides, at, crossings_, mask_, region_);
        region_.measure({mask_, window.first_row, box.rows()},
                        needs_,
                        [&](const PixelBatch& batch) { writer_.write(batch, place, id); });
    }

  private:
    void paint_within(int band, const TorusCell& cell, Beyond& beyond) {
        const PixelBox box = box_in_grid(cell, grid_.height);
        const int begin = band * kBandRows;
        if (FieldRows{0, grid_.height}.hold(box)) {
            if (rows_from(begin).hold(box)) {
                return paint(cell);
            }
            if (rows_from(begin - kBandRows / 2).hold(box)) {
                return beyond.below.add(cell);
            }
            if (rows_from(begin + kBandRows / 2).hold(box)) {
                return beyond.above.add(cell);
            }
        }
        beyond.others.add(cell);
    }

    const TorusCells& cells_;
    const RasterGrid& grid_;
    DistanceNeeds needs_;
    FieldWriter writer_;
    std::array<CellGroup, 2> groups_;
    SmallCell small_;
    RowCrossings crossings_;
    CellMask mask_;
    RegionField region_;
};

}  // namespace

// Where bubbles of an invalid foam lie over each other, the last one shows: the order in which they
// are painted must not depend on threads, nor on the shift. So no two threads ever paint the same
// rows, and bands are those of the unshifted grid. First go the bubbles that lie within a band,
// then those within half of one and half of the next, then the large ones and those at the border.
void write_torus_field(const Frame& frame,
                       const RasterGrid& grid,
                       DistanceNeeds needs,
                       int threads,
                       DistanceField& field) {
    const TorusCells cells(frame, grid, threads);
    std::vector<CellPainter> painters(
        static_cast<std::size_t>(std::clamp(threads, 1, cells.bands())),
        CellPainter(cells, grid, needs, field));
    std::vector<Beyond> beyond(static_cast<std::size_t>(cells.bands()));
    parallel_for(cells.bands(), painters, [&](CellPainter& own, int band) {
        own.paint_within(band, beyond[static_cast<std::size_t>(band)]);
    });
    parallel_for(cells.bands() - 1, painters, [&](CellPainter& own, int band) {
        const auto paint = [&](const TorusCell& cell) { own.paint(cell); };
        const auto lower = static_cast<std::size_t>(band);
        beyond[lower].above.visit(paint);
        beyond[lower + 1].below.visit(paint);
    });
    std::vector<TorusCell> others;
    std::vector<RegionExtent> extents;
    for (const Beyond& of_band : beyond) {
        of_band.others.visit([&](const TorusCell& cell) {
            others.push_back(cell);
            extents.push_back(cell.extent);
        });
    }
    const Bands bands(grid, cells.shear(), extents, kBandRows);
    parallel_for(bands.count(), painters, [&](CellPainter& own, int band) {
        for (const Bands::Entry& entry : bands.entries(band)) {
            own.paint(others[entry.region], entry.translation, rows_of(bands, band));
        }
    });
}

}  // namespace foam::texgen
