#include "texgen/raster/fill.h"

#include "texgen/raster/bands.h"
#include "texgen/raster/coverage.h"
#include "texgen/raster/parallel_for.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cstring>
#include <limits>
#include <span>
#include <stdexcept>
#include <type_traits>

namespace foam::texgen {

namespace {

// Of the sums of a band, few are touched. Bands of 4 MB, at 2048 x 2048 with 10,000 bubbles, took
// 48 ms, of 1 MB 53 ms, of 1/4 MB 59 ms: what is cut and begun for each costs more than caches
// miss.
constexpr std::size_t kBandBytes = std::size_t{1} << 22;
constexpr int kFewestRows = 4;
constexpr int kMostRows = 64;

int rows_per_band(int width, std::size_t sum_bytes) {
    const std::size_t row_bytes = static_cast<std::size_t>(width) * sum_bytes;
    return std::clamp(static_cast<int>(kBandBytes / row_bytes), kFewestRows, kMostRows);
}

template <class Sample>
void check(const CellOutlines& cells, const CellValues& values, ImageView<Sample> image) {
    if (image.width() != cells.grid.width || image.height() != cells.grid.height) {
        throw std::invalid_argument("the image must have the size of the raster grid");
    }
    if (values.channels < 1 || values.channels > kMaxChannels ||
        values.channels != static_cast<std::size_t>(image.channels())) {
        throw std::invalid_argument("the image must have the channels of the values, 1 to 4");
    }
    const auto has_value = [&](BubbleId bubble) {
        return (index_of(bubble) + 1) * values.channels <= values.cells.size();
    };
    const bool complete = (!cells.outside || has_value(*cells.outside)) &&
                          std::all_of(cells.outlines.begin(),
                                      cells.outlines.end(),
                                      [&](const Outline& o) { return has_value(o.bubble); });
    if (!complete) {
        throw std::invalid_argument("every bubble needs a value");
    }
}

template <std::size_t Bytes>
using UnsignedOfSize = std::conditional_t<
    Bytes == 1,
    std::uint8_t,
    std::conditional_t<Bytes == 2,
                       std::uint16_t,
                       std::conditional_t<Bytes == 4, std::uint32_t, std::uint64_t>>>;

// Sums as Coverage counts them, of 16-bit values.
constexpr double kFull = std::int64_t{1} << kCoverageBits;
constexpr std::int64_t kLargest = std::numeric_limits<std::uint16_t>::max();

// Outlines of an invalid foam may overlap: a mean may then lie out of range.
std::uint16_t rounded_mean(double sum) {
    constexpr double kHalf = 0.5;  // makes truncation the nearest
    const auto mean = static_cast<std::int32_t>(sum * (1.0 / kFull) + kHalf);
    return static_cast<std::uint16_t>(std::clamp<std::int32_t>(mean, 0, kLargest));
}

// Each mean, encoded.
template <class Encode>
struct Means {
    Encode encode;

    template <std::size_t Channels>
    auto samples_of(const typename Coverage<Channels>::Sum& sum) const {
        std::array<decltype(encode(std::uint16_t{})), Channels> samples{};
        for (std::size_t c = 0; c < Channels; ++c) {
            samples[c] = encode(rounded_mean(sum[c]));
        }
        return samples;
    }
};

// The last mean, and the others over it.
struct StraightMeans {
    template <std::size_t Channels>
    std::array<std::uint16_t, Channels> samples_of(
        const typename Coverage<Channels>::Sum& sum) const {
        std::array<std::uint16_t, Channels> samples{};
        const auto opacity = static_cast<std::int64_t>(sum[Channels - 1]);
        if (opacity <= 0) {
            return samples;
        }
        for (std::size_t c = 0; c + 1 < Channels; ++c) {
            const auto whole = static_cast<std::int64_t>(sum[c]);
            const std::int64_t color = (whole * kLargest + opacity / 2) / opacity;
            samples[c] = static_cast<std::uint16_t>(std::clamp<std::int64_t>(color, 0, kLargest));
        }
        samples[Channels - 1] = rounded_mean(sum[Channels - 1]);
        return samples;
    }
};

// Turns the sums along a row into samples. A pixel is kept in one machine word: it is stored at a
// stroke, and where three channels leave a part of the word over, that spills into the next pixel,
// whose turn is yet to come.
template <std::size_t Channels, class Sample, class ToSamples>
class RowWriter {
  public:
    using Sum = typename Coverage<Channels>::Sum;

    // `base` is the value that the sums are counted from.
    RowWriter(std::span<const std::uint16_t, Channels> base,
              const ToSamples& to_samples,
              std::span<Sample> row)
        : to_samples_(to_samples), row_(row.data()), width_(row.size() / Channels) {
        for (std::size_t c = 0; c < Channels; ++c) {
            sum_[c] = base[c] * kFull;
        }
    }

    void add(const Sum& difference) {
        Sum sum = difference;  // reads all before it writes any, to take several at once
        for (std::size_t c = 0; c < sum.size(); ++c) {
            sum[c] += sum_[c];
        }
        sum_ = sum;
        const auto samples = to_samples_.template samples_of<Channels>(sum_);
        pixel_ = 0;
        for (std::size_t c = 0; c < Channels; ++c) {
            pixel_ |= std::uint64_t{samples[c]} << shift(c);
        }
    }

    void write(std::size_t from, std::size_t to) {
        if (to - from >= 2 * kBlockPixels) {
            from = write_blocks(from, to);
        }
        const auto word = static_cast<Word>(pixel_);
        for (std::size_t x = from; x < std::min(to, width_ - 1); ++x) {
            std::memcpy(row_ + x * Channels, &word, sizeof(word));
        }
        if (from < to && to == width_) {
            std::memcpy(row_ + (to - 1) * Channels, &word, Channels * sizeof(Sample));
        }
    }

  private:
    static constexpr std::size_t kSlots = std::bit_ceil(Channels);
    using Word = UnsignedOfSize<kSlots * sizeof(Sample)>;
    static constexpr std::size_t kBlockPixels = 8;

    // Long stretches, several pixels at a stroke. Returns where it ended.
    std::size_t write_blocks(std::size_t from, std::size_t to) {
        std::array<Sample, kBlockPixels * Channels + kSlots - Channels> block{};
        const auto word = static_cast<Word>(pixel_);
        for (std::size_t k = 0; k < kBlockPixels; ++k) {
            std::memcpy(&block[k * Channels], &word, sizeof(word));
        }
        for (; from + kBlockPixels <= to; from += kBlockPixels) {
            std::memcpy(
                row_ + from * Channels, block.data(), kBlockPixels * Channels * sizeof(Sample));
        }
        return from;
    }

    // Where a channel stands in the word so that it is the c-th in memory.
    static constexpr std::size_t shift(std::size_t c) {
        const std::size_t slot = std::endian::native == std::endian::little ? c : kSlots - 1 - c;
        return 8 * sizeof(Sample) * slot;
    }

    const ToSamples& to_samples_;
    Sample* row_;
    std::size_t width_;
    Sum sum_{};
    std::uint64_t pixel_ = 0;
};

// Fills with `Channels` channels; ToSamples makes the samples of a pixel of its sums.
template <std::size_t Channels, class Sample, class ToSamples>
class Filler {
  public:
    using BandCoverage = Coverage<Channels>;

    Filler(const CellOutlines& cells,
           const CellValues& values,
           ToSamples to_samples,
           ImageView<Sample> image)
        : cells_(cells),
          values_(values),
          to_samples_(to_samples),
          image_(image),
          bands_(cells,
                 rows_per_band(image.width(), sizeof(typename BandCoverage::Sum)),
                 Bands::Entries::Stretches) {}

    // Each worker has one buffer for all its bands.
    void fill(int threads) const {
        const int workers = std::clamp(threads, 1, bands_.count());
        const RowKind kind = cells_.grid.view ? RowKind::Line : RowKind::Ring;
        std::vector<BandCoverage> buffers;
        buffers.reserve(static_cast<std::size_t>(workers));
        for (int k = 0; k < workers; ++k) {
            buffers.emplace_back(image_.width(), bands_.row_count(0), kind);
        }
        parallel_for(bands_.count(), buffers, [&](BandCoverage& coverage, int band) {
            fill_band(band, coverage);
        });
    }

  private:
    void fill_band(int band, BandCoverage& coverage) const {
        const int first_row = bands_.first_row(band);
        const SubpixelPoint origin{0, first_row * kSubpixel};
        for (const Bands::Entry& entry : bands_.entries(band)) {
            const Outline& outline = cells_.outlines[entry.outline];
            coverage.add(cells_.chain(outline),
                         entry.begin,
                         entry.end,
                         entry.translation - origin,
                         over_film(outline.bubble));
        }
        for (int row = 0; row < bands_.row_count(band); ++row) {
            RowWriter<Channels, Sample, ToSamples> writer(
                base(), to_samples_, image_.row(first_row + row));
            coverage.take_row(row, writer);
        }
    }

    std::span<const std::uint16_t, Channels> value_of(BubbleId bubble) const {
        return std::span<const std::uint16_t, Channels>(&values_.cells[index_of(bubble) * Channels],
                                                        Channels);
    }

    // What a pixel shows that no outline touches. The outlines of what is around a patch leave out
    // where that is not.
    std::span<const std::uint16_t, Channels> base() const {
        return cells_.outside ? value_of(*cells_.outside)
                              : std::span(values_.film).template first<Channels>();
    }

    // The value of a cell less that of films, which lie under everything.
    typename BandCoverage::Value over_film(BubbleId bubble) const {
        typename BandCoverage::Value value{};
        for (std::size_t c = 0; c < Channels; ++c) {
            value[c] = std::int32_t{value_of(bubble)[c]} - values_.film[c];
        }
        return value;
    }

    const CellOutlines& cells_;
    const CellValues& values_;
    ToSamples to_samples_;
    ImageView<Sample> image_;
    Bands bands_;
};

template <class Sample, class ToSamples>
void fill(const CellOutlines& cells,
          const CellValues& values,
          const ToSamples& to_samples,
          int threads,
          ImageView<Sample> image) {
    check(cells, values, image);
    switch (values.channels) {
        case 1:
            return Filler<1, Sample, ToSamples>(cells, values, to_samples, image).fill(threads);
        case 2:
            return Filler<2, Sample, ToSamples>(cells, values, to_samples, image).fill(threads);
        case 3:
            return Filler<3, Sample, ToSamples>(cells, values, to_samples, image).fill(threads);
        default:
            return Filler<4, Sample, ToSamples>(cells, values, to_samples, image).fill(threads);
    }
}

}  // namespace

void fill_cells(const CellOutlines& cells,
                const CellValues& values,
                int threads,
                ImageView<std::uint16_t> image) {
    const auto as_is = [](std::uint16_t value) { return value; };
    fill(cells, values, Means<decltype(as_is)>{as_is}, threads, image);
}

void fill_straight(const CellOutlines& cells,
                   const CellValues& values,
                   int threads,
                   ImageView<std::uint16_t> image) {
    fill(cells, values, StraightMeans{}, threads, image);
}

void fill_cells(const CellOutlines& cells,
                const CellValues& values,
                const Encoding<std::uint8_t>& encoding,
                int threads,
                ImageView<std::uint8_t> image) {
    const auto encode = [&](std::uint16_t value) { return encoding[value]; };
    fill(cells, values, Means<decltype(encode)>{encode}, threads, image);
}

}  // namespace foam::texgen
