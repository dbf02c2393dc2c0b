// SPDX-License-Identifier: Apache-2.0

#include "texgen/raster/coverage/fill.h"

#include "core/parallel/parallel_for.h"
#include "texgen/raster/coverage/arc_bands.h"
#include "texgen/raster/coverage/coverage.h"
#include "texgen/raster/coverage/row_writer.h"

#include <fmt/core.h>

#include <algorithm>
#include <optional>
#include <span>
#include <stdexcept>
#include <vector>

namespace foam::texgen {

namespace {

// The image is filled in bands of rows, in parallel. For each band, the arcs that overlap it are
// added to a Coverage, which accumulates signed areas. A running sum along each row gives the mean
// of every pixel, in spans of equal pixels, which are converted and written span by span. All
// bubbles and films are summed in one pass: at first all pixels have the value of films, or in a
// patch the value of the ghost bubble, and each arc adds the difference of the values on its two
// sides.

// The intended number of bytes of the sums of a band. Arcs add to few of these sums, so that cache
// misses cost less than splitting arcs at the borders of more bands (README.md). The actual number
// may differ, because the number of rows of a band is limited to a range, and ArcBands rounds it up
// to a power of two.
constexpr std::size_t kBandBytes = std::size_t{1} << 21;
// The number of arcs by which prefetching is ahead of processing. Prefetching is needed because
// arcs are sorted by tile, so that successive arcs are not contiguous in memory.
constexpr std::size_t kPrefetchDistance = 6;
constexpr int kMinRows = 4;  // per band
constexpr int kMaxRows = 64;

// Returns the number of rows of a band. `sum_bytes` is the number of bytes of the sums of a pixel.
int rows_per_band(int width, std::size_t sum_bytes) {
    const std::size_t row_bytes = static_cast<std::size_t>(width) * sum_bytes;
    return std::clamp(static_cast<int>(kBandBytes / row_bytes), kMinRows, kMaxRows);
}

// Throws std::invalid_argument if a bubble has no value; kFilmSide needs none. `values` is the
// number of bubbles that have values.
void check_bubble(std::size_t bubble, std::size_t values) {
    if (bubble != kFilmSide && bubble >= values) {
        throw std::invalid_argument(
            fmt::format("there are values for {} bubbles, but the value of bubble {} is needed",
                        values,
                        bubble));
    }
}

// Throws std::invalid_argument unless every bubble beside an arc, and the ghost bubble of a patch,
// has a value. `values` is the number of bubbles that have values.
void check_values(const CellArcs& cells, std::size_t values) {
    if (cells.ghost) {
        check_bubble(index_of(*cells.ghost), values);
    }
    for (const std::vector<MonotoneArc>& batch : cells.batches) {
        for (const MonotoneArc& arc : batch) {
            check_bubble(arc.sides.left, values);
            check_bubble(arc.sides.right, values);
        }
    }
}

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
    check_values(cells, values.bubbles.size() / values.channels);
}

// Fills an image of `Channels` channels. ToPixels converts sums to pixels (row_writer.h).
template <std::size_t Channels, class ToPixels>
class Filler {
  public:
    using Sums = PixelSums<Channels>;
    using Step = typename Coverage<Channels>::Step;

    Filler(const CellArcs& cells,
           const CellValues& values,
           int threads,
           ImageView<std::uint16_t> image)
        : cells_(cells),
          values_(values),
          image_(image),
          threads_(thread_count(threads)),
          bands_(cells, rows_per_band(image.width(), sizeof(Sums)), threads_) {}

    // Fills all bands in parallel. A worker allocates its buffers once and reuses them for all
    // bands that it fills.
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
            : coverage(filler.image_.width(),
                       filler.bands_.row_count(0),
                       filler.cells_.grid.view ? RowKind::Line : RowKind::Ring) {}

        Coverage<Channels> coverage;
        RowSums<Channels> sums;
        RowWriter<Channels, ToPixels> writer;
    };

    void fill_band(int band, Worker& worker) const {
        const int first_row = bands_.first_row(band);
        const SubpixelPoint origin{0, first_row * kSubpixel};
        const std::span<const ArcBands::Entry> entries = bands_.entries(band);
        for (std::size_t k = 0; k < entries.size(); ++k) {
            const MonotoneArc* ahead =
                entries[std::min(k + kPrefetchDistance, entries.size() - 1)].arc;
            __builtin_prefetch(ahead);
            __builtin_prefetch(&ahead->sides);  // often in another cache line
            const MonotoneArc& arc = *entries[k].arc;
            worker.coverage.add(arc, entries[k].translation - origin, step_across(arc));
        }
        worker.coverage.finish();
        const Sums start = start_of_rows();
        const std::size_t row_samples = image_.row_samples();
        const std::span<std::uint16_t> rows(
            image_.row(first_row).data(),
            row_samples * static_cast<std::size_t>(bands_.row_count(band)));
        for (int row = 0; row < bands_.row_count(band); ++row) {
            const std::span<std::uint16_t> output =
                rows.subspan(row_samples * static_cast<std::size_t>(row));
            worker.writer.prefetch(output.first(row_samples));
            worker.coverage.take_row(row, start, worker.sums);
            worker.writer.write(worker.sums, static_cast<std::size_t>(image_.width()), output);
        }
    }

    std::span<const std::uint16_t, Channels> value_of(BubbleId bubble) const {
        return std::span<const std::uint16_t, Channels>(
            &values_.bubbles[index_of(bubble) * Channels], Channels);
    }

    // Returns the value of pixels before any arc is added. On a torus this is the value of films.
    // In a patch it is the value of the ghost bubble; within the foam, the outlines of the ghost
    // change it to the value of films.
    std::span<const std::uint16_t, Channels> base() const {
        return cells_.ghost ? value_of(*cells_.ghost)
                            : std::span(values_.film).template first<Channels>();
    }

    // Returns the sum of a pixel before any arc is added.
    Sums start_of_rows() const {
        Sums start{};
        for (std::size_t c = 0; c < Channels; ++c) {
            start[c] = kPixelArea * base()[c];
        }
        return start;
    }

    // Returns the value on a side of an arc minus the value of films. The result is 0 if there is a
    // film on this side.
    Sums difference_from_film(std::uint32_t side) const {
        Sums value{};
        if (side != kFilmSide) {
            for (std::size_t c = 0; c < Channels; ++c) {
                value[c] = values_.bubbles[side * Channels + c] - values_.film[c];
            }
        }
        return value;
    }

    Step step_across(const MonotoneArc& arc) const {
        const Sums left = difference_from_film(arc.sides.left);
        const Sums right = difference_from_film(arc.sides.right);
        Step step;
        for (std::size_t c = 0; c < Channels; ++c) {
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

    const CellArcs& cells_;
    const CellValues& values_;
    ImageView<std::uint16_t> image_;
    int threads_;
    ArcBands bands_;
};

// Checks the arguments and fills the image. ToPixels<channels> converts sums to pixels.
template <template <std::size_t> class ToPixels>
void fill(const CellArcs& cells,
          const CellValues& values,
          int threads,
          ImageView<std::uint16_t> image) {
    check(cells, values, image);
    switch (values.channels) {
        case 1:
            return Filler<1, ToPixels<1>>(cells, values, threads, image).fill();
        case 2:
            return Filler<2, ToPixels<2>>(cells, values, threads, image).fill();
        case 3:
            return Filler<3, ToPixels<3>>(cells, values, threads, image).fill();
        default:
            return Filler<4, ToPixels<4>>(cells, values, threads, image).fill();
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
