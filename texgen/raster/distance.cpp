#include "texgen/raster/distance.h"

#include "texgen/raster/bands.h"
#include "texgen/raster/parallel_for.h"
#include "texgen/raster/pixel_regions.h"
#include "texgen/raster/region_field.h"

#include <algorithm>
#include <cstddef>
#include <vector>

namespace foam::texgen {

namespace {

constexpr int kTileRows = RegionField::kTileRows;
constexpr int kRowsPerBand = 8 * kTileRows;

// A rectangle of the image that holds a region; around a torus it is unwrapped.
struct Window {
    int column = 0;  // of its lower left pixel
    int row = 0;
    int first_row = 0;  // of those in the mask, above `row`; a multiple of kTileRows
    int x = 0;          // where its columns begin in the image

    SubpixelPoint corner() const { return {column * kSubpixel, row * kSubpixel}; }
};

// Paints the bands of a field, one after the other.
class FieldPainter {
  public:
    FieldPainter(const CellOutlines& cells,
                 const PixelRegions& regions,
                 const Bands& bands,
                 DistanceNeeds needs,
                 DistanceField& field)
        : cells_(cells), regions_(regions), bands_(bands), needs_(needs), field_(field) {
        if (cells_.outside) {
            regions_.place_ghost(around_);
        }
    }

    void paint(int band) {
        begin_ = bands_.first_row(band);
        end_ = begin_ + bands_.row_count(band);
        if (cells_.outside) {
            fill_around();
        }
        for (const Bands::Entry& entry : bands_.entries(band)) {
            const Outline& outline = cells_.outlines[entry.outline];
            if (outline.bubble != cells_.outside) {
                paint_bubble(outline, entry.translation);
            }
        }
        if (cells_.outside) {
            paint_around();
        }
    }

  private:
    std::uint32_t ghost() const { return static_cast<std::uint32_t>(index_of(*cells_.outside)); }

    void fill_around() {
        for (int row = begin_; row < end_; ++row) {
            std::ranges::fill(field_.ids.row(row), ghost());
        }
    }

    // A band begins at a multiple of kTileRows.
    void paint_around() {
        mask_.reset(field_.ids.width(), end_ - begin_);
        for (int row = begin_; row < end_; ++row) {
            const std::span<const std::uint32_t> ids = field_.ids.row(row);
            for (std::size_t x = 0; x < ids.size(); ++x) {
                if (ids[x] == ghost()) {
                    mask_.set(static_cast<int>(x), row - begin_);
                }
            }
        }
        measure(around_, {0, 0, begin_}, ghost());
    }

    void paint_bubble(const Outline& outline, SubpixelPoint translation) {
        const Window window = open_window(outline, translation);
        if (mask_.columns() <= 0) {
            return;
        }
        const SubpixelPoint up{0, window.first_row * kSubpixel};
        mask_.fill(cells_.chain(outline), translation - window.corner() - up);
        regions_.place(outline, translation, window.corner(), bubble_);
        measure(bubble_, window, static_cast<std::uint32_t>(index_of(outline.bubble)));
    }

    // Around an outline, with an empty mask of those of its rows that are in the band.
    Window open_window(const Outline& outline, SubpixelPoint translation) {
        PixelBox box = box_around(outline, translation);
        if (cells_.grid.view) {
            box.left = std::max(box.left, 0);
            box.right = std::min(box.right, cells_.grid.width);
        }
        box.top = std::min(box.top, end_);
        const int wanted = std::max(begin_ - box.bottom, 0);
        const int first_row = wanted / kTileRows * kTileRows;
        mask_.reset(box.columns(), box.rows() - first_row, wanted - first_row);
        return {box.left, box.bottom, first_row, wrap(box.left, cells_.grid.width)};
    }

    void measure(RegionField& region, const Window& window, std::uint32_t id) {
        region.measure(mask_, window.first_row, needs_, [&](const PixelBatch& batch) {
            for (const PixelBatch::Run& run : batch.runs()) {
                write_run(batch, run, window, id);
            }
        });
    }

    struct Pixels {
        int row;
        int x;
        std::size_t first;  // in the batch
        std::size_t count;
    };

    // Around a torus in two pieces or more.
    void write_run(const PixelBatch& batch,
                   const PixelBatch::Run& run,
                   const Window& window,
                   std::uint32_t id) {
        const auto width = static_cast<std::size_t>(field_.ids.width());
        Pixels at{window.row + run.row, window.x + run.column, run.first, run.count};
        while (at.x >= field_.ids.width()) {
            at.x -= field_.ids.width();
        }
        for (std::size_t left = run.count; left > 0; left -= at.count) {
            at.count = std::min(left, width - static_cast<std::size_t>(at.x));
            write_pixels(batch, at, id);
            at.first += at.count;
            at.x = 0;
        }
    }

    void write_pixels(const PixelBatch& batch, const Pixels& at, std::uint32_t id) {
        std::fill_n(field_.ids.pixel(at.x, at.row).data(), at.count, id);
        write(batch.distance(), at, field_.distance);
        if (needs_.gradient) {
            write(batch.gradient_x(), batch.gradient_y(), at, field_.gradient);
        }
        if (needs_.smooth) {
            write(batch.smooth(), at, field_.smooth);
            write(batch.smooth_x(), batch.smooth_y(), at, field_.smooth_gradient);
        }
    }

    static void write(const PixelBatch::Values& values, const Pixels& at, Image<float>& image) {
        std::copy_n(&values[at.first], at.count, image.pixel(at.x, at.row).data());
    }

    static void write(const PixelBatch::Values& xs,
                      const PixelBatch::Values& ys,
                      const Pixels& at,
                      Image<float>& image) {
        float* sample = image.pixel(at.x, at.row).data();
        for (std::size_t k = at.first; k < at.first + at.count; ++k) {
            *sample++ = xs[k];
            *sample++ = ys[k];
        }
    }

    const CellOutlines& cells_;
    const PixelRegions& regions_;
    const Bands& bands_;
    DistanceNeeds needs_;
    DistanceField& field_;
    int begin_ = 0;  // rows of the band
    int end_ = 0;
    CellMask mask_;
    RegionField bubble_;
    RegionField around_;  // the patch
};

template <class Sample>
void ask_for(bool needed, const RasterGrid& grid, int channels, Image<Sample>& image) {
    const bool fits = image.width() == grid.width && image.height() == grid.height;
    if (!needed) {
        image = {};
    } else if (!fits) {
        image = Image<Sample>(grid.width, grid.height, channels);
    }
}

}  // namespace

void write_distance_field(const Frame& frame,
                          const CellOutlines& cells,
                          DistanceNeeds needs,
                          int threads,
                          DistanceField& field) {
    const RasterGrid& grid = cells.grid;
    const PixelRegions regions(frame, cells);
    ask_for(true, grid, 1, field.ids);
    ask_for(true, grid, 1, field.distance);
    ask_for(needs.gradient, grid, 2, field.gradient);
    ask_for(needs.smooth, grid, 1, field.smooth);
    ask_for(needs.smooth, grid, 2, field.smooth_gradient);
    const Bands bands(cells, kRowsPerBand);
    std::vector<FieldPainter> painters(
        static_cast<std::size_t>(std::clamp(threads, 1, bands.count())),
        FieldPainter(cells, regions, bands, needs, field));
    parallel_for(
        bands.count(), painters, [](FieldPainter& painter, int band) { painter.paint(band); });
}

void write_distance_field(const Frame& frame,
                          const RasterGrid& grid,
                          DistanceNeeds needs,
                          int threads,
                          DistanceField& field) {
    write_distance_field(frame, outline_cells(frame, grid, threads), needs, threads, field);
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
