#include "texgen/raster/patch_field.h"

#include "core/parallel/parallel_for.h"
#include "texgen/raster/bands.h"
#include "texgen/raster/field_rows.h"
#include "texgen/raster/field_writer.h"
#include "texgen/raster/patch_regions.h"
#include "texgen/raster/region_field.h"

#include <algorithm>
#include <cstddef>
#include <vector>

namespace foam::texgen {

namespace {

constexpr int kRowsPerBand = 8 * RegionField::kTileRows;

// Paints bands, bubble by bubble, and what is around the patch.
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
        const FieldRows rows = rows_of(bands_, band);
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

    void paint_bubble(const Outline& outline, const FieldRows& rows) {
        PixelBox box = box_around(outline, {});
        box.left = std::max(box.left, 0);
        box.right = std::min(box.right, cells_.grid.width);
        if (box.columns() <= 0) {
            return;
        }
        const FieldWindow window(box, rows);
        window.reset(mask_);
        mask_.fill(cells_.chain(outline), SubpixelPoint{} - window.mask_corner());
        regions_.place(outline.bubble, window.corner(), bubble_);
        measure(bubble_,
                {mask_, window.first_row, box.rows()},
                {box.left, box.bottom},
                static_cast<std::uint32_t>(index_of(outline.bubble)));
    }

    // A band begins at a multiple of kTileRows.
    void paint_around(const FieldRows& rows) {
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

}  // namespace

void write_patch_field(const Frame& frame,
                       const RasterGrid& grid,
                       DistanceNeeds needs,
                       int threads,
                       DistanceField& field) {
    const CellOutlines cells = outline_cells(frame, grid, threads);
    const PatchRegions regions(frame, grid);
    const Bands bands(cells, kRowsPerBand);
    std::vector<PatchPainter> painters(
        static_cast<std::size_t>(std::clamp(threads, 1, bands.count())),
        PatchPainter(cells, regions, bands, needs, field));
    parallel_for(bands.count(), painters, [](PatchPainter& own, int band) { own.paint(band); });
}

}  // namespace foam::texgen
