// SPDX-License-Identifier: Apache-2.0

#include "texgen/raster/coverage/fill.h"

#include "core/parallel/parallel_for.h"
#include "texgen/image/cache_line.h"
#include "texgen/raster/coverage/arc_bands.h"
#include "texgen/raster/coverage/coverage.h"
#include "texgen/raster/coverage/paint_span.h"

#include <fmt/core.h>

#include <algorithm>
#include <optional>
#include <span>
#include <stdexcept>
#include <vector>

// At first all pixels have the value of films, or in a patch the value of the ghost bubble. In the
// rows that it crosses, each arc then changes everything that is to the right of it. The change is
// the value on the right side of the arc minus the value on its left side. The areas are
// accumulated as in the rasterizers that coverage.cpp names. These rasterizers accumulate the
// coverage of one shape. Accumulating changes of values instead is our own method. A pixel gets the
// mean of all bubbles and films in it, exact except for rounding (fill.h). The usual alternative
// blends shapes one after the other (T. Porter and T. Duff, "Compositing digital images", 1984). It
// knows only how much of a pixel each shape covers, not where. Its means are therefore wrong where
// two shapes share an edge.

namespace foam::texgen {

namespace {

constexpr int kRowsPerBand = 64;  // see README.md
// Each arc is prefetched this many arcs before it is processed. The arcs of a band are visited by
// columns (arc_bands.h), an order in which they are not contiguous in memory.
constexpr std::size_t kPrefetchDistance = 6;

// Throws std::invalid_argument if the arguments of fill_cells do not match.
void check(const CellArcs& cells, const CellValues& values, ImageView<std::uint16_t> image) {
    if (image.width() != cells.grid.width || image.height() != cells.grid.height) {
        throw std::invalid_argument("the image must have the size of the raster grid");
    }
    if (values.channels < 1 || values.channels > kMaxChannels ||
        values.channels != static_cast<std::size_t>(image.channels())) {
        throw std::invalid_argument(
            "the image must have as many channels as the values, from 1 to 4");
    }
    const auto check_side = [count = values.bubbles.size() / values.channels](std::size_t bubble) {
        if (bubble != kFilmSide && bubble >= count) {
            throw std::invalid_argument(
                fmt::format("there are values for {} bubbles, but the value of bubble {} is needed",
                            count,
                            bubble));
        }
    };
    if (cells.ghost) {
        check_side(index_of(*cells.ghost));
    }
    for (const std::vector<MonotoneArc>& batch : cells.batches) {
        for (const MonotoneArc& arc : batch) {
            check_side(arc.sides.left);
            check_side(arc.sides.right);
        }
    }
}

// Returns the value of each bubble minus the value of films, and after all bubbles a 0, which is
// the difference for kFilmSide.
template <std::size_t Channels>
std::vector<PixelSums<Channels>> differences_from_film(const CellValues& values) {
    std::vector<PixelSums<Channels>> differences(values.bubbles.size() / Channels + 1);
    for (std::size_t k = 0; k + 1 < differences.size(); ++k) {
        for (std::size_t c = 0; c < Channels; ++c) {
            differences[k][c] = values.bubbles[k * Channels + c] - values.film[c];
        }
    }
    return differences;
}

// Fills an image of `Channels` channels. ToPixel converts the sums of a pixel to its samples.
template <std::size_t Channels, class ToPixel>
class Filler {
  public:
    using Sums = PixelSums<Channels>;
    using Step = typename Coverage<Channels>::Step;

    Filler(const CellArcs& cells,
           const CellValues& values,
           int threads,
           ImageView<std::uint16_t> image)
        : image_(image),
          threads_(thread_count(threads)),
          row_kind_(cells.grid.view ? RowKind::Line : RowKind::Ring),
          bands_(cells, kRowsPerBand, threads_),
          differences_(differences_from_film<Channels>(values)) {
        const Sums& base = difference(cells.ghost ? arc_side(*cells.ghost) : kFilmSide);
        for (std::size_t c = 0; c < Channels; ++c) {
            start_[c] = kPixelArea * (values.film[c] + base[c]);
        }
    }

    // Fills all bands in parallel. A worker reuses its buffers for all bands that it fills.
    void fill() const {
        const int workers = std::min(threads_, bands_.count());
        std::vector<std::optional<Worker>> all(static_cast<std::size_t>(workers));
        parallel_for(bands_.count(), all, [&](std::optional<Worker>& worker, int band) {
            if (!worker) {
                worker.emplace(*this);
            }
            fill_band(band, *worker);
        });
    }

  private:
    struct Worker {
        explicit Worker(const Filler& filler)
            : coverage(filler.image_.width(), filler.bands_.row_count(0), filler.row_kind_),
              padded_row(filler.image_.row_samples() + kBlockBytes / sizeof(std::uint16_t)) {}

        Coverage<Channels> coverage;
        // A row of the image, followed by room for the bytes that paint_span writes beyond it.
        std::vector<std::uint16_t> padded_row;
    };

    void fill_band(int band, Worker& worker) const {
        const int first_row = bands_.first_row(band);
        const SubpixelPoint origin{0, first_row * kSubpixel};
        const std::span<const ArcBands::Entry> entries = bands_.entries(band);
        worker.coverage.clear();
        for (std::size_t k = 0; k < entries.size(); ++k) {
            const MonotoneArc* ahead =
                entries[std::min(k + kPrefetchDistance, entries.size() - 1)].arc;
            __builtin_prefetch(ahead);
            __builtin_prefetch(&ahead->sides);  // often in another cache line
            const MonotoneArc& arc = *entries[k].arc;
            worker.coverage.add(arc, entries[k].translation - origin, step_across(arc));
        }
        worker.coverage.finish();
        const int rows = bands_.row_count(band);
        for (int row = 0; row < rows; ++row) {
            const std::span<std::uint16_t> output = image_.row(first_row + row);
            prefetch(output);
            // paint_span may write up to kBlockBytes beyond the end of a row. These bytes may be in
            // the higher rows of the same band, which are written later, but not in another band.
            const bool has_room =
                static_cast<std::size_t>(rows - 1 - row) * output.size_bytes() >= kBlockBytes;
            const std::span<std::uint16_t> to = has_room ? output : worker.padded_row;
            worker.coverage.take_row(
                row,
                start_,
                [bytes = reinterpret_cast<std::uint8_t*>(to.data())](
                    std::size_t begin, std::size_t end, const Sums& sums) {
                    paint_span<Channels * sizeof(std::uint16_t)>(
                        begin, end, ToPixel::template pixel<Channels>(sums), bytes);
                });
            if (!has_room) {
                std::copy_n(to.begin(), output.size(), output.begin());
            }
        }
    }

    // Prefetches a row of the image. If this is done before sums are computed, the stores do not
    // stall on one cache miss after the other.
    static void prefetch(std::span<const std::uint16_t> row) {
        for (std::size_t k = 0; k < row.size(); k += kLineBytes / sizeof(row[k])) {
            __builtin_prefetch(&row[k], 1);
        }
    }

    // Returns the value on a side of an arc minus the value of films.
    const Sums& difference(std::uint32_t side) const {
        return differences_[std::min<std::size_t>(side, differences_.size() - 1)];
    }

    Step step_across(const MonotoneArc& arc) const {
        const Sums& left = difference(arc.sides.left);
        const Sums& right = difference(arc.sides.right);
        Step step;
        for (std::size_t c = 0; c < left.size(); ++c) {
            step.across[c] = right[c] - left[c];
        }
        step.wraps = arc.sides.left_periods != 0 || arc.sides.right_periods != 0;
        if (step.wraps) {
            for (std::size_t c = 0; c < Channels; ++c) {
                step.period_correction[c] =
                    arc.sides.right_periods * right[c] - arc.sides.left_periods * left[c];
            }
        }
        return step;
    }

    ImageView<std::uint16_t> image_;
    int threads_;
    RowKind row_kind_;
    ArcBands bands_;
    std::vector<Sums> differences_;
    Sums start_{};  // the sum of a pixel before any arc is added
};

// Checks the arguments and fills the image. ToPixel converts the sums of a pixel to its samples.
template <class ToPixel>
void fill(const CellArcs& cells,
          const CellValues& values,
          int threads,
          ImageView<std::uint16_t> image) {
    check(cells, values, image);
    switch (values.channels) {
        case 1:
            return Filler<1, ToPixel>(cells, values, threads, image).fill();
        case 2:
            return Filler<2, ToPixel>(cells, values, threads, image).fill();
        case 3:
            return Filler<3, ToPixel>(cells, values, threads, image).fill();
        default:
            return Filler<4, ToPixel>(cells, values, threads, image).fill();
    }
}

}  // namespace

void fill_cells(const CellArcs& cells,
                const CellValues& values,
                int threads,
                ImageView<std::uint16_t> image) {
    fill<RoundedMeans>(cells, values, threads, image);
}

void fill_straight(const CellArcs& cells,
                   const CellValues& values,
                   int threads,
                   ImageView<std::uint16_t> image) {
    fill<StraightMeans>(cells, values, threads, image);
}

}  // namespace foam::texgen
