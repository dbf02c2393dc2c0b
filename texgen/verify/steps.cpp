// SPDX-License-Identifier: Apache-2.0

#include "texgen/verify/steps.h"

#include "core/geometry/max_or_nan.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

namespace foam::texgen {

namespace {

constexpr double kInfinite = std::numeric_limits<double>::infinity();

// Returns the sum of the differences of two sequences of samples. Precondition: they have the same
// length.
template <class Sample>
double sum_of_differences(std::span<const Sample> a,
                          std::span<const Sample> b,
                          Difference difference) {
    double sum = 0.0;
    if (difference == Difference::Ids) {
        for (std::size_t k = 0; k < a.size(); ++k) {
            sum += a[k] != b[k] ? 1.0 : 0.0;
        }
        return sum;
    }
    for (std::size_t k = 0; k < a.size(); ++k) {
        sum += std::abs(static_cast<double>(a[k]) - static_cast<double>(b[k]));
    }
    return sum;
}

// Adds to steps[x] the sum of the differences between column x and column x - 1. Column 0 is
// compared with the last column.
template <class Sample>
void add_column_steps(const Image<Sample>& image,
                      Difference difference,
                      std::vector<double>& steps) {
    const auto channels = static_cast<std::size_t>(image.channels());
    for (int y = 0; y < image.height(); ++y) {
        const std::span<const Sample> row = image.row(y);
        std::span<const Sample> before = row.last(channels);
        for (std::size_t x = 0; x < steps.size(); ++x) {
            const std::span<const Sample> pixel = row.subspan(x * channels, channels);
            steps[x] += sum_of_differences(before, pixel, difference);
            before = pixel;
        }
    }
}

// Adds to steps[y] the sum of the differences between row y and row y - 1. Row 0 is compared with
// the last row.
template <class Sample>
void add_row_steps(const Image<Sample>& image, Difference difference, std::vector<double>& steps) {
    std::span<const Sample> before = image.row(image.height() - 1);
    for (int y = 0; y < image.height(); ++y) {
        steps[static_cast<std::size_t>(y)] += sum_of_differences(before, image.row(y), difference);
        before = image.row(y);
    }
}

// Returns the seam for sums of differences. Each sum is over `samples` samples. The first sum is
// the difference across the border, the others are the differences within the image.
Seam seam_of(const std::vector<double>& sums, double samples) {
    Seam seam{sums.front() / samples, 0.0};
    for (std::size_t k = 1; k < sums.size(); ++k) {
        seam.largest_within = max_or_nan(seam.largest_within, sums[k] / samples);
    }
    return seam;
}

// Returns the number of channels of all groups.
int channel_count(std::span<const ChannelGroup* const> groups) {
    int channels = 0;
    for (const ChannelGroup* group : groups) {
        channels += group->channels();
    }
    return channels;
}

// Returns the sum of the differences of all samples, or infinity if the groups differ in type or
// size.
double group_difference(const ChannelGroup& a, const ChannelGroup& b, Difference difference) {
    return std::visit(
        [&](const auto& left) {
            using SameImage = std::remove_cvref_t<decltype(left)>;
            const auto* right = std::get_if<SameImage>(&b.samples);
            if (right == nullptr || left.width() != right->width() ||
                left.samples().size() != right->samples().size()) {
                return kInfinite;
            }
            return sum_of_differences(left.samples(), right->samples(), difference);
        },
        a.samples);
}

}  // namespace

double Seam::ratio() const {
    if (across == 0.0) {
        return 0.0;
    }
    const bool is_comparable =
        largest_within > 0.0 && std::isfinite(largest_within) && std::isfinite(across);
    return is_comparable ? across / largest_within : kInfinite;
}

void WorstSeam::add(const Seam& one, int number) {
    const bool is_worse = one.across > seam.across || std::isnan(one.across);
    if (frame == 0 || (is_worse && !std::isnan(seam.across))) {
        seam.across = one.across;
        frame = number;
    }
    seam.largest_within = max_or_nan(seam.largest_within, one.largest_within);
}

TileSeams tile_seams(std::span<const ChannelGroup* const> groups, Difference difference) {
    if (groups.empty()) {
        return {};
    }
    const int width = groups.front()->width();
    const int height = groups.front()->height();
    std::vector<double> columns(static_cast<std::size_t>(width), 0.0);
    std::vector<double> rows(static_cast<std::size_t>(height), 0.0);
    for (const ChannelGroup* group : groups) {
        std::visit(
            [&](const auto& image) {
                add_column_steps(image, difference, columns);
                add_row_steps(image, difference, rows);
            },
            group->samples);
    }
    const int channels = channel_count(groups);
    return {seam_of(columns, static_cast<double>(height) * channels),
            seam_of(rows, static_cast<double>(width) * channels)};
}

double step_between(std::span<const ChannelGroup* const> a,
                    std::span<const ChannelGroup* const> b,
                    Difference difference) {
    if (a.size() != b.size() || a.empty()) {
        return kInfinite;
    }
    double sum = 0.0;
    for (std::size_t k = 0; k < a.size(); ++k) {
        sum += group_difference(*a[k], *b[k], difference);
    }
    const ChannelGroup& first = *a.front();
    return sum / (static_cast<double>(first.width()) * first.height() * channel_count(a));
}

}  // namespace foam::texgen
