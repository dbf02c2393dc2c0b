#include "texgen/raster/distance.h"

#include "texgen/raster/bands.h"
#include "texgen/raster/parallel_for.h"
#include "texgen/raster/patch_boundaries.h"
#include "texgen/raster/region_field.h"

#include <algorithm>
#include <cstddef>
#include <vector>

namespace foam::texgen {

namespace {

constexpr int kTileRows = RegionField::kTileRows;
constexpr int kRowsPerBand = 8 * kTileRows;
constexpr double kShortestSide = 1e-9;  // pixels; a shorter side has no direction to speak of
constexpr int kFilmsPerTask = 4096;

// The films of a frame as the grid sees them; each arc is relative to its tail.
class PixelFilms {
  public:
    PixelFilms(const Frame& frame, double scale, int threads) : arcs_(frame.network.film_slots()) {
        const auto count = static_cast<int>(arcs_.size());
        parallel_for((count + kFilmsPerTask - 1) / kFilmsPerTask, threads, [&](int task) {
            const int end = std::min((task + 1) * kFilmsPerTask, count);
            for (int k = task * kFilmsPerTask; k < end; ++k) {
                const auto film = static_cast<std::size_t>(k);
                const FilmArc& arc = frame.arcs[id_at<FilmId>(film)];
                arcs_[film] = field_arc({scale * arc.chord, arc.half_angle}, Vec2::Zero());
            }
        });
    }

    const FieldArc& of(FilmId film) const { return arcs_[index_of(film)]; }

  private:
    std::vector<FieldArc> arcs_;
};

// A frame's regions as the grid sees them.
class PixelRegions {
  public:
    PixelRegions(const Frame& frame, const CellOutlines& cells, int threads)
        : frame_(frame),
          cells_(cells),
          scale_(pixels_per_unit(cells.grid, frame.torus)),
          films_(frame, scale_, threads) {}

    // The boundaries of a region, relative to a pixel's corner.
    void place(const Outline& outline,
               SubpixelPoint translation,
               SubpixelPoint corner,
               RegionField& field) const {
        if (cells_.outside) {
            place_in_plane(outline.bubble, Vec2(corner.x, corner.y) / kSubpixel, field);
        } else {
            const SubpixelPoint first = cells_.chain(outline).front() + translation - corner;
            place_on_torus(outline.bubble, Vec2(first.x, first.y) / kSubpixel, field);
        }
    }

    void place_ghost(RegionField& field) const {
        place_in_plane(*cells_.outside, Vec2::Zero(), field);
    }

  private:
    void place_in_plane(BubbleId bubble, const Vec2& corner, RegionField& field) const {
        const bool is_circle = index_of(bubble) >= frame_.network.bubble_slots();
        field.clear(bubble == *cells_.outside ? RegionField::Kind::Around
                    : is_circle               ? RegionField::Kind::Circle
                                              : RegionField::Kind::Bubble);
        const Boundaries boundaries = boundaries_of({frame_, cells_.grid, scale_}, bubble);
        std::size_t k = 0;
        for (const std::size_t end : boundaries.loop_ends) {
            for (; k < end; ++k) {
                const ArcLoops::Arc& side = boundaries.arcs[k];
                if (side.arc.chord.norm() > kShortestSide) {
                    field.add_side(field_arc(side.arc, side.tail - corner));
                }
            }
            field.close_boundary();
        }
    }

    // The outline begins at `first`; that was rounded to a subpixel, which the arcs are not.
    void place_on_torus(BubbleId bubble, const Vec2& first, RegionField& field) const {
        field.clear(RegionField::Kind::Bubble);
        const Network& network = frame_.network;
        const HalfEdgeId begin = network.first(bubble);
        const Vec2& position = frame_.positions[network.tail(begin)];
        const SubpixelPoint snapped = snap(cells_.grid, frame_.torus, position);
        Vec2 tail = first + scale_ * position - Vec2(snapped.x, snapped.y) / kSubpixel;
        HalfEdgeId h = begin;
        do {
            const FieldArc& film = films_.of(film_of(h));
            FieldArc side = is_forward(h) ? film : reversed(film);
            const Vec2 half = 0.5 * side.chord * side.direction;
            side.middle = tail + half;
            if (side.chord > kShortestSide) {
                field.add_side(side);
            }
            tail += 2.0 * half;
            h = network.next(h);
        } while (h != begin);
        field.close_boundary();
    }

    const Frame& frame_;
    const CellOutlines& cells_;
    double scale_;  // pixels per foam unit
    PixelFilms films_;
};

// A rectangle of the image that holds a region; around a torus it is unwrapped.
struct Window {
    int column = 0;  // of its lower left pixel
    int row = 0;
    int first_row = 0;  // of those in the mask, above `row`; a multiple of kTileRows

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
        PixelBox box = box_around(cells_, outline, translation);
        if (cells_.grid.view) {
            box.left = std::max(box.left, 0);
            box.right = std::min(box.right, cells_.grid.width);
        }
        box.top = std::min(box.top, end_);
        const int wanted = std::max(begin_ - box.bottom, 0);
        const int first_row = wanted / kTileRows * kTileRows;
        mask_.reset(box.columns(), box.rows() - first_row, wanted - first_row);
        return {box.left, box.bottom, first_row};
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
        Pixels at{window.row + run.row,
                  wrap(window.column + run.column, field_.ids.width()),
                  run.first,
                  run.count};
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
    const PixelRegions regions(frame, cells, threads);
    ask_for(true, grid, 1, field.ids);
    ask_for(true, grid, 1, field.distance);
    ask_for(needs.gradient, grid, 2, field.gradient);
    ask_for(needs.smooth, grid, 1, field.smooth);
    ask_for(needs.smooth, grid, 2, field.smooth_gradient);
    const Bands bands(cells, kRowsPerBand, Bands::Entries::Outlines);
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
    write_distance_field(frame, outline_cells(frame, grid, 0.0, threads), needs, threads, field);
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
