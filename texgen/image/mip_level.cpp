// SPDX-License-Identifier: Apache-2.0

#include "texgen/image/mip_level.h"

#include "core/parallel/simd_level.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

// A box filter for images of any width and height. Along an axis, the larger level has m pixels and
// the smaller level has n pixels. A pixel of the smaller level therefore covers m / n pixels of the
// larger level. This quotient is 2 if m is even, and 1 if m is 1. It is more than 2 and at most 3
// if m is any other odd number. The mean weights every covered pixel by the covered fraction of its
// area. The filter is separable, so means are computed first along rows and then across rows.
// Images of 32-bit integers contain ids, which cannot be averaged. A pixel of such an image
// therefore gets the id at the center of the covered area.

namespace foam::texgen {

namespace {

int half_of(int extent) {
    return std::max(1, extent / 2);
}

/// The interval that a pixel of the smaller level covers along one axis of the larger level.
struct Footprint {
    // These numbers have 64 bits, because their products may exceed 32 bits.
    std::int64_t larger_extent;   // number of pixels of the larger level along the axis
    std::int64_t smaller_extent;  // number of pixels of the smaller level along the axis
    std::int64_t pixel;           // index of the pixel in the smaller level

    /// The pixels of the larger level that the interval overlaps are first(), ..., last() - 1.
    int first() const { return static_cast<int>(pixel * larger_extent / smaller_extent); }
    int last() const {
        return static_cast<int>(((pixel + 1) * larger_extent + smaller_extent - 1) /
                                smaller_extent);
    }

    /// Returns the fraction of the interval that is in a pixel of the larger level; `larger` is the
    /// index of this pixel. The fractions of all pixels that the interval overlaps add up to 1.
    /// Here the unit of length is a pixel of the larger level divided by `smaller_extent`, so that
    /// the ends of all intervals are integers. Precondition: first() <= larger < last().
    double weight(int larger) const {
        const std::int64_t begin = std::max(pixel * larger_extent, larger * smaller_extent);
        const std::int64_t end =
            std::min((pixel + 1) * larger_extent, (larger + 1) * smaller_extent);
        return static_cast<double>(end - begin) / static_cast<double>(larger_extent);
    }
    /// Returns the pixel of the larger level that contains the middle of the interval.
    int middle() const {
        return static_cast<int>((2 * pixel + 1) * larger_extent / (2 * smaller_extent));
    }
};

/// Computes the mean over each interval of row y of the larger level and adds it, multiplied by
/// `weight`, to `sums`. `sums` has one element per pixel of a row of the smaller level.
void add_means(
    ImageView<const float> pixels, int channel, int y, double weight, std::vector<double>& sums) {
    const int width = static_cast<int>(sums.size());
    for (int x = 0; x < width; ++x) {
        const Footprint covered{pixels.width(), width, x};
        double mean = 0.0;
        for (int larger = covered.first(); larger < covered.last(); ++larger) {
            mean +=
                covered.weight(larger) * pixels.pixel(larger, y)[static_cast<std::size_t>(channel)];
        }
        sums[static_cast<std::size_t>(x)] += weight * mean;
    }
}

// Computes the means over squares of 2 x 2 pixels, with the roundings of the general case.
Image<float> halved(ImageView<const float> pixels) {
    Image<float> level(pixels.width() / 2, pixels.height() / 2, 1);
    for (int y = 0; y < level.height(); ++y) {
        at_simd_level([first = pixels.row(2 * y).data(),
                       second = pixels.row(2 * y + 1).data(),
                       to = level.row(y)] {
            for (std::size_t x = 0; x < to.size(); ++x) {
                const double first_sum = static_cast<double>(first[2 * x]) + first[2 * x + 1];
                const double second_sum = static_cast<double>(second[2 * x]) + second[2 * x + 1];
                to[x] = static_cast<float>(0.25 * (first_sum + second_sum));
            }
        });
    }
    return level;
}

}  // namespace

Image<float> mean_level(ImageView<const float> pixels, int channel) {
    if (pixels.channels() == 1 && pixels.width() % 2 == 0 && pixels.height() % 2 == 0) {
        return halved(pixels);
    }
    Image<float> level(half_of(pixels.width()), half_of(pixels.height()), 1);
    std::vector<double> sums;
    for (int y = 0; y < level.height(); ++y) {
        const Footprint covered{pixels.height(), level.height(), y};
        sums.assign(static_cast<std::size_t>(level.width()), 0.0);
        for (int larger = covered.first(); larger < covered.last(); ++larger) {
            add_means(pixels, channel, larger, covered.weight(larger), sums);
        }
        std::transform(sums.begin(), sums.end(), level.row(y).begin(), [](double sum) {
            return static_cast<float>(sum);
        });
    }
    return level;
}

Image<std::uint32_t> central_level(ImageView<const std::uint32_t> pixels, int channel) {
    Image<std::uint32_t> level(half_of(pixels.width()), half_of(pixels.height()), 1);
    for (int y = 0; y < level.height(); ++y) {
        const int from_y = Footprint{pixels.height(), level.height(), y}.middle();
        for (int x = 0; x < level.width(); ++x) {
            const int from_x = Footprint{pixels.width(), level.width(), x}.middle();
            level.row(y)[static_cast<std::size_t>(x)] =
                pixels.pixel(from_x, from_y)[static_cast<std::size_t>(channel)];
        }
    }
    return level;
}

}  // namespace foam::texgen
