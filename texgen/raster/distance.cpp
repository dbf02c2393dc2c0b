#include "texgen/raster/distance.h"

#include "texgen/raster/bands.h"
#include "texgen/raster/cell_place.h"
#include "texgen/raster/field_writer.h"
#include "texgen/raster/parallel_for.h"
#include "texgen/raster/patch_regions.h"
#include "texgen/raster/region_field.h"
#include "texgen/raster/small_cell.h"
#include "texgen/raster/torus_cells.h"

#include <algorithm>
#include <cstddef>
#include <vector>

namespace foam::texgen {

namespace {

constexpr int kTileRows = RegionField::kTileRows;
constexpr int kRowsPerBand = 8 * kTileRows;
constexpr std::size_t kAhead = 3;  // bubbles, whose sides are fetched beforehand

// The rows of a band.
struct Rows {
    int begin = 0;
    int end = 0;

    Rows(const Bands& bands, int band)
        : begin(bands.first_row(band)), end(begin + bands.row_count(band)) {}
};

// A rectangle of the image that holds a region, or what of it is in a band; around a torus it is
// unwrapped.
struct Window {
    PixelBox box;
    int first_row = 0;       // of those in the mask, above the box's; a multiple of kTileRows
    SmallMask::Rows wanted;  // of the box

    Window(const PixelBox& around, const Rows& rows)
        : box(around),
          wanted{std::max(rows.begin - box.bottom, 0), std::min(box.top, rows.end) - box.bottom} {
        first_row = wanted.begin / kTileRows * kTileRows;
    }

    void reset(CellMask& mask) const {
        mask.reset(box.columns(), wanted.end - first_row, wanted.begin - first_row);
    }
    SubpixelPoint corner() const { return {box.left * kSubpixel, box.bottom * kSubpixel}; }
    SubpixelPoint mask_corner() const { return corner() + SubpixelPoint{0, first_row * kSubpixel}; }
};

// Paints the bands of a field of a torus, one after the other.
class TorusPainter {
  public:
    TorusPainter(const TorusCells& cells,
                 const Bands& bands,
                 DistanceNeeds needs,
                 DistanceField& field)
        : cells_(cells), bands_(bands), needs_(needs), field_(field), writer_(needs, field) {}

    void paint(int band) {
        const std::span<const Bands::Entry> entries = bands_.entries(band);
        for (std::size_t k = 0; k < entries.size(); ++k) {
            cells_.expect(entries[std::min(k + kAhead, entries.size() - 1)].region);
            paint_bubble(entries[k], Rows(bands_, band));
        }
    }

  private:
    void paint_bubble(const Bands::Entry& entry, const Rows& rows) {
        const SubpixelPoint by = entry.translation;
        const Window window(box_around(cells_.extents()[entry.region], by), rows);
        const auto id = static_cast<std::uint32_t>(index_of(cells_.bubbles()[entry.region]));
        const PixelBox& box = window.box;
        const ImagePlace place{wrap(box.left, field_.ids.width()), box.bottom};
        writer_.expect(place, box.columns(), window.wanted.begin, window.wanted.end);
        const BubbleSides sides = cells_.sides(entry.region);
        const CellPlace at{by, window.corner(), window.mask_corner()};
        if (small_.place(sides, at, {box.columns(), box.rows(), window.wanted})) {
            writer_.write(small_.measure(needs_), place, id);
            return;
        }
        window.reset(mask_);
        place_cell(sides, at, crossings_, mask_, bubble_);
        bubble_.measure({mask_, window.first_row, box.rows()},
                        needs_,
                        [&](const PixelBatch& batch) { writer_.write(batch, place, id); });
    }

    const TorusCells& cells_;
    const Bands& bands_;
    DistanceNeeds needs_;
    DistanceField& field_;
    FieldWriter writer_;
    SmallCell small_;
    RowCrossings crossings_;
    CellMask mask_;
    RegionField bubble_;
};

// The same of a patch, and of what is around it.
class PatchPainter {
  public:
    PatchPainter(const CellOutlines& cells,
                 const PatchRegions& regions,
                 const Bands& bands,
                 DistanceNeeds needs,
                 DistanceField& field)
        : cells_(cells),
          regions_(regions),
          bands_(bands),
          needs_(needs),
          field_(field),
          writer_(needs, field) {
        regions_.place(*cells_.outside, {}, around_);
    }

    void paint(int band) {
        const Rows rows(bands_, band);
        for (int row = rows.begin; row < rows.end; ++row) {
            std::ranges::fill(field_.ids.row(row), ghost());
        }
        for (const Bands::Entry& entry : bands_.entries(band)) {
            const Outline& outline = cells_.outlines[entry.region];
            if (outline.bubble != cells_.outside) {
                paint_bubble(outline, rows);
            }
        }
        paint_around(rows);
    }

  private:
    std::uint32_t ghost() const { return static_cast<std::uint32_t>(index_of(*cells_.outside)); }

    void paint_bubble(const Outline& outline, const Rows& rows) {
        PixelBox box = box_around(outline, {});
        box.left = std::max(box.left, 0);
        box.right = std::min(box.right, cells_.grid.width);
        if (box.columns() <= 0) {
            return;
        }
        const Window window(box, rows);
        window.reset(mask_);
        mask_.fill(cells_.chain(outline), SubpixelPoint{} - window.mask_corner());
        regions_.place(outline.bubble, window.corner(), bubble_);
        measure(bubble_,
                {mask_, window.first_row, box.rows()},
                {box.left, box.bottom},
                static_cast<std::uint32_t>(index_of(outline.bubble)));
    }

    // A band begins at a multiple of kTileRows.
    void paint_around(const Rows& rows) {
        mask_.reset(field_.ids.width(), rows.end - rows.begin);
        for (int row = rows.begin; row < rows.end; ++row) {
            const std::span<const std::uint32_t> ids = field_.ids.row(row);
            for (std::size_t x = 0; x < ids.size(); ++x) {
                if (ids[x] == ghost()) {
                    mask_.set(static_cast<int>(x), row - rows.begin);
                }
            }
        }
        measure(around_, {mask_, rows.begin, field_.ids.height()}, {}, ghost());
    }

    void measure(RegionField& region,
                 const RegionField::Pixels& pixels,
                 ImagePlace place,
                 std::uint32_t id) {
        region.measure(
            pixels, needs_, [&](const PixelBatch& batch) { writer_.write(batch, place, id); });
    }

    const CellOutlines& cells_;
    const PatchRegions& regions_;
    const Bands& bands_;
    DistanceNeeds needs_;
    DistanceField& field_;
    FieldWriter writer_;
    CellMask mask_;
    RegionField bubble_;
    RegionField around_;
};

template <class Painter>
void paint_all(const Bands& bands, const Painter& painter, int threads) {
    std::vector<Painter> painters(static_cast<std::size_t>(std::clamp(threads, 1, bands.count())),
                                  painter);
    parallel_for(bands.count(), painters, [](Painter& own, int band) { own.paint(band); });
}

template <class Sample>
void ask_for(bool needed, const RasterGrid& grid, int channels, Image<Sample>& image) {
    const bool fits = image.width() == grid.width && image.height() == grid.height;
    if (!needed) {
        image = {};
    } else if (!fits) {
        image = Image<Sample>(grid.width, grid.height, channels);
    }
}

void ask_for(DistanceNeeds needs, const RasterGrid& grid, DistanceField& field) {
    ask_for(true, grid, 1, field.ids);
    ask_for(true, grid, 1, field.distance);
    ask_for(needs.gradient, grid, 2, field.gradient);
    ask_for(needs.smooth, grid, 1, field.smooth);
    ask_for(needs.smooth, grid, 2, field.smooth_gradient);
}

}  // namespace

void write_distance_field(const Frame& frame,
                          const RasterGrid& grid,
                          DistanceNeeds needs,
                          int threads,
                          DistanceField& field) {
    if (frame.torus.is_plane()) {
        const CellOutlines cells = outline_cells(frame, grid, threads);
        const PatchRegions regions(frame, grid);
        const Bands bands(cells, kRowsPerBand);
        ask_for(needs, grid, field);
        paint_all(bands, PatchPainter(cells, regions, bands, needs, field), threads);
    } else {
        const TorusCells cells(frame, grid, threads);
        const Bands bands(grid, cells.shear(), cells.extents(), kRowsPerBand);
        ask_for(needs, grid, field);
        paint_all(bands, TorusPainter(cells, bands, needs, field), threads);
    }
}

DistanceField distance_field(const Frame& frame,
                             const RasterGrid& grid,
                             DistanceNeeds needs,
                             int threads) {
    DistanceField field;
    write_distance_field(frame, grid, needs, threads, field);
    return field;
}

}  // namespace foam::texgen
