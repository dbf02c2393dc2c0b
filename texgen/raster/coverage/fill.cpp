// SPDX-License-Identifier: Apache-2.0

#include "texgen/raster/coverage/fill.h"

#include "core/parallel/parallel_for.h"
#include "texgen/raster/coverage/arc_bands.h"
#include "texgen/raster/coverage/coverage.h"
#include "texgen/raster/coverage/pixel_means.h"
#include "texgen/raster/coverage/row_writer.h"

#include <fmt/core.h>

#include <algorithm>
#include <optional>
#include <span>
#include <stdexcept>
#include <type_traits>
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
template <class Sample>
void check(const CellArcs& cells, const CellValues& values, ImageView<Sample> image) {
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

// Fills an image of `Channels` channels. ToSamples converts sums to pixels (pixel_means.h).
template <class Sums, std::size_t Channels, class Sample, class ToSamples>
class Filler {
  public:
    using BandCoverage = Coverage<Sums>;

    Filler(const CellArcs& cells,
           const CellValues& values,
           ToSamples to_samples,
           int threads,
           ImageView<Sample> image)
        : cells_(cells),
          values_(values),
          to_samples_(to_samples),
          image_(image),
          threads_(thread_count(threads)),
          bands_(
              cells, rows_per_band(image.width(), sizeof(typename BandCoverage::Sum)), threads_) {}

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
                       filler.cells_.grid.view ? RowKind::Line : RowKind::Ring),
              writer(filler.to_samples_) {}

        BandCoverage coverage;
        RowSums<typename Sums::Sum> sums;
        RowWriter<Sums, Channels, Sample, ToSamples> writer;
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
        const typename Sums::Sum start = start_of_rows();
        const std::size_t row_samples = image_.row_samples();
        const std::span<Sample> rows(
            image_.row(first_row).data(),
            row_samples * static_cast<std::size_t>(bands_.row_count(band)));
        for (int row = 0; row < bands_.row_count(band); ++row) {
            const std::span<Sample> output =
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
    typename Sums::Sum start_of_rows() const {
        typename Sums::Sum start{};
        for (std::size_t c = 0; c < Channels; ++c) {
            start[c] = Sums::start(base()[c]);
        }
        return start;
    }

    // Returns the value on a side of an arc minus the value of films. The result is 0 if there is a
    // film on this side.
    typename BandCoverage::Sum difference_from_film(std::uint32_t side) const {
        typename BandCoverage::Sum value{};
        if (side != kFilmSide) {
            for (std::size_t c = 0; c < Channels; ++c) {
                value[c] = Sums::of_value(values_.bubbles[side * Channels + c] - values_.film[c]);
            }
        }
        return value;
    }

    typename BandCoverage::Step step_across(const MonotoneArc& arc) const {
        const typename BandCoverage::Sum left = difference_from_film(arc.sides.left);
        const typename BandCoverage::Sum right = difference_from_film(arc.sides.right);
        typename BandCoverage::Step step;
        for (std::size_t c = 0; c < Channels; ++c) {
            step.across[c] = right[c] - left[c];
        }
        step.wraps = arc.sides.left_periods != 0 || arc.sides.right_periods != 0;
        if (step.wraps) {
            for (std::size_t c = 0; c < Channels; ++c) {
                step.period_correction[c] = Sums::of_value(arc.sides.right_periods) * right[c] -
                                            Sums::of_value(arc.sides.left_periods) * left[c];
            }
        }
        return step;
    }

    const CellArcs& cells_;
    const CellValues& values_;
    ToSamples to_samples_;
    ImageView<Sample> image_;
    int threads_;
    ArcBands bands_;
};

// Checks the arguments, then calls fill(channels) with the number of channels as a
// std::integral_constant.
template <class Sample, class Fill>
void fill_channels(const CellArcs& cells,
                   const CellValues& values,
                   ImageView<Sample> image,
                   const Fill& fill) {
    check(cells, values, image);
    switch (values.channels) {
        case 1:
            return fill(std::integral_constant<std::size_t, 1>{});
        case 2:
            return fill(std::integral_constant<std::size_t, 2>{});
        case 3:
            return fill(std::integral_constant<std::size_t, 3>{});
        default:
            return fill(std::integral_constant<std::size_t, 4>{});
    }
}

template <class Sums, std::size_t Channels, class Sample, class ToSamples>
void fill(const CellArcs& cells,
          const CellValues& values,
          const ToSamples& to_samples,
          int threads,
          ImageView<Sample> image) {
    Filler<Sums, Channels, Sample, ToSamples>(cells, values, to_samples, threads, image).fill();
}

}  // namespace

void fill_cells(const CellArcs& cells,
                const CellValues& values,
                int threads,
                ImageView<std::uint16_t> image) {
    const auto as_is = [](std::uint16_t value) { return value; };
    fill_channels(cells, values, image, [&](auto channels) {
        using Sums = ExactSums<channels>;
        const EncodedMeans<channels, Sums, decltype(as_is)> means(as_is);
        fill<Sums, channels>(cells, values, means, threads, image);
    });
}

void fill_straight(const CellArcs& cells,
                   const CellValues& values,
                   int threads,
                   ImageView<std::uint16_t> image) {
    fill_channels(cells, values, image, [&](auto channels) {
        const StraightMeans<channels> means;
        fill<ExactSums<channels>, channels>(cells, values, means, threads, image);
    });
}

void fill_cells(const CellArcs& cells,
                const CellValues& values,
                const Encoding<std::uint8_t>& encoding,
                int threads,
                ImageView<std::uint8_t> image) {
    const auto encode = [codes = encoding.data()](std::uint16_t value) { return codes[value]; };
    fill_channels(cells, values, image, [&](auto channels) {
        using Sums = SmallSums<channels>;
        const EncodedMeans<channels, Sums, decltype(encode)> means(encode);
        fill<Sums, channels>(cells, values, means, threads, image);
    });
}

}  // namespace foam::texgen
