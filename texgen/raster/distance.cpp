#include "texgen/raster/distance.h"

#include "texgen/raster/bands.h"
#include "texgen/raster/outlines.h"
#include "texgen/raster/parallel_for.h"
#include "texgen/raster/patch_boundaries.h"
#include "texgen/raster/region_field.h"

#include <algorithm>
#include <bit>
#include <vector>

namespace foam::texgen {

namespace {

constexpr int kSide = DistanceTile::kSide;
constexpr int kRowsPerBand = 8 * kSide;

// A frame's regions as the grid sees them.
struct PixelRegions {
    const Frame& frame;
    const CellOutlines& cells;
    double scale;  // pixels per foam unit

    Boundaries of_patch(BubbleId bubble) const {
        return boundaries_of({frame, cells.grid, scale}, bubble);
    }

    // Relative to the first point of the bubble's outline; that was rounded to a subpixel, which
    // the arcs are not.
    Boundaries of_torus(BubbleId bubble) const {
        const Network& network = frame.network;
        const HalfEdgeId first = network.first(bubble);
        const Vec2& position = frame.positions[network.tail(first)];
        const SubpixelPoint snapped = snap(cells.grid, frame.torus, position);
        Vec2 tail = scale * position - Vec2(snapped.x, snapped.y) / kSubpixel;
        Boundaries boundaries;
        HalfEdgeId h = first;
        do {
            const FilmArc arc = frame.arc(h);
            boundaries.arcs.push_back({tail, {scale * arc.chord, arc.half_angle}});
            tail += boundaries.arcs.back().arc.chord;
            h = network.next(h);
        } while (h != first);
        boundaries.loop_ends.push_back(boundaries.arcs.size());
        return boundaries;
    }

    bool is_circle(BubbleId bubble) const {
        return index_of(bubble) >= frame.network.bubble_slots();
    }
};

// A rectangle of the image that holds a region; around a torus it is unwrapped. The mask has those
// of its rows that are in the band.
struct Window {
    int column = 0;  // of its lower left pixel
    int row = 0;
    int first_row = 0;  // where the mask begins, above `row`; a multiple of kSide

    SubpixelPoint corner() const { return {column * kSubpixel, row * kSubpixel}; }
};

// Paints the bands of a field, one after the other.
class FieldPainter {
  public:
    FieldPainter(const PixelRegions& regions,
                 const Bands& bands,
                 DistanceNeeds needs,
                 DistanceField& field)
        : regions_(regions), cells_(regions.cells), bands_(bands), needs_(needs), field_(field) {
        if (cells_.outside) {
            around_.place(
                regions_.of_patch(*cells_.outside), Vec2::Zero(), RegionField::Kind::Around);
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

    // Rows of a band begin with a multiple of kSide.
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
        measure(around_, {0, 0, begin_});
    }

    void paint_bubble(const Outline& outline, SubpixelPoint translation) {
        const Window window = open_window(outline, translation);
        if (mask_.columns() <= 0) {
            return;
        }
        const std::span<const SubpixelPoint> chain = cells_.chain(outline);
        const SubpixelPoint moved = translation - window.corner();
        mask_.fill(chain, moved - SubpixelPoint{0, window.first_row * kSubpixel});
        write_ids(window, static_cast<std::uint32_t>(index_of(outline.bubble)));
        const auto kind = regions_.is_circle(outline.bubble) ? RegionField::Kind::Circle
                                                             : RegionField::Kind::Bubble;
        if (cells_.outside) {
            bubble_.place(
                regions_.of_patch(outline.bubble), -Vec2(window.column, window.row), kind);
        } else {
            const SubpixelPoint first = chain.front() + moved;
            bubble_.place(
                regions_.of_torus(outline.bubble), Vec2(first.x, first.y) / kSubpixel, kind);
        }
        measure(bubble_, window);
    }

    // Around an outline, with an empty mask.
    Window open_window(const Outline& outline, SubpixelPoint translation) {
        const auto [left, right] = std::ranges::minmax_element(
            cells_.chain(outline), {}, [](SubpixelPoint point) { return point.x; });
        Window window{
            pixel_of(left->x + translation.x), pixel_of(outline.lowest + translation.y), 0};
        int end_column = pixel_of(right->x + translation.x) + 1;
        if (cells_.grid.view) {
            window.column = std::max(window.column, 0);
            end_column = std::min(end_column, cells_.grid.width);
        }
        const int wanted = std::max(begin_ - window.row, 0);
        const int end_row = std::min(pixel_of(outline.highest + translation.y) + 1, end_);
        window.first_row = wanted / kSide * kSide;
        mask_.reset(end_column - window.column,
                    end_row - window.row - window.first_row,
                    wanted - window.first_row);
        return window;
    }

    // Calls write(x, begin, end) for the pieces of a run of the window's columns, with the column
    // of the image that `begin` is in.
    template <class Write>
    void wrapped(int column, int count, const Write& write) const {
        int x = wrap(column, field_.ids.width());
        for (int done = 0; done < count;) {
            const int piece = std::min(count - done, field_.ids.width() - x);
            write(x, done, piece);
            done += piece;
            x = 0;
        }
    }

    void write_ids(const Window& window, std::uint32_t id) {
        for (int row = 0; row < mask_.rows(); ++row) {
            mask_.for_each_run(row, [&](int begin, int end) {
                const auto ids = field_.ids.row(window.row + window.first_row + row);
                wrapped(window.column + begin, end - begin, [&](int x, int, int count) {
                    std::fill_n(&ids[static_cast<std::size_t>(x)], count, id);
                });
            });
        }
    }

    void measure(RegionField& region, const Window& window) {
        const auto visit = [&](const RegionTile& at, std::span<const SideSearch::Side> sides) {
            RegionField::measure(at, sides, tile_);
            if (needs_.gradient || needs_.smooth) {
                tile_.normalize_gradients();
            }
            if (needs_.smooth) {
                region.measure_smooth(at, tile_);
            }
            write_tile(window, at);
        };
        region.for_each_tile(mask_, window.first_row, visit);
    }

    void write_tile(const Window& window, const RegionTile& at) {
        for (int k = 0; k < kSide; ++k) {
            const unsigned pixels = at.pixels[static_cast<std::size_t>(k)];
            const int row = window.row + window.first_row + at.row + k;
            for (unsigned rest = pixels; rest != 0;) {
                const int begin = std::countr_zero(rest);
                const int count = std::countr_one(rest >> begin);
                wrapped(window.column + at.column + begin, count, [&](int x, int done, int piece) {
                    write_run(row, x, k * kSide + begin + done, piece);
                });
                rest &= ~(((1U << count) - 1) << begin);
            }
        }
    }

    // Pixels of the tile, from one of them on, to the images.
    void write_run(int row, int x, int from, int count) {
        const Pixels pixels{
            row, x, static_cast<std::size_t>(from), static_cast<std::size_t>(count)};
        write(tile_.distance(), pixels, field_.distance);
        if (needs_.gradient) {
            write(tile_.gradient_x(), tile_.gradient_y(), pixels, field_.gradient);
        }
        if (needs_.smooth) {
            write(tile_.smooth(), pixels, field_.smooth);
            write(tile_.smooth_x(), tile_.smooth_y(), pixels, field_.smooth_gradient);
        }
    }

    struct Pixels {
        int row;
        int x;
        std::size_t from;  // in the tile
        std::size_t count;
    };

    static void write(const DistanceTile::Values& values, const Pixels& at, Image<float>& image) {
        std::copy_n(&values[at.from], at.count, image.pixel(at.x, at.row).data());
    }

    static void write(const DistanceTile::Values& xs,
                      const DistanceTile::Values& ys,
                      const Pixels& at,
                      Image<float>& image) {
        float* sample = image.pixel(at.x, at.row).data();
        for (std::size_t k = at.from; k < at.from + at.count; ++k) {
            *sample++ = xs[k];
            *sample++ = ys[k];
        }
    }

    const PixelRegions& regions_;
    const CellOutlines& cells_;
    const Bands& bands_;
    DistanceNeeds needs_;
    DistanceField& field_;
    int begin_ = 0;  // rows of the band
    int end_ = 0;
    CellMask mask_;
    RegionField bubble_;
    RegionField around_;  // the patch
    DistanceTile tile_;
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
                          const RasterGrid& grid,
                          DistanceNeeds needs,
                          int threads,
                          DistanceField& field) {
    const CellOutlines cells = outline_cells(frame, grid, 0.0, threads);
    const PixelRegions regions{frame, cells, pixels_per_unit(grid, frame.torus)};
    ask_for(true, grid, 1, field.ids);
    ask_for(true, grid, 1, field.distance);
    ask_for(needs.gradient, grid, 2, field.gradient);
    ask_for(needs.smooth, grid, 1, field.smooth);
    ask_for(needs.smooth, grid, 2, field.smooth_gradient);
    const Bands bands(cells, kRowsPerBand);
    std::vector<FieldPainter> painters(
        static_cast<std::size_t>(std::clamp(threads, 1, bands.count())),
        FieldPainter(regions, bands, needs, field));
    parallel_for(
        bands.count(), painters, [](FieldPainter& painter, int band) { painter.paint(band); });
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
