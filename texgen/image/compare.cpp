// SPDX-License-Identifier: Apache-2.0

#include "texgen/image/compare.h"

#include "texgen/image/limit_check.h"
#include "texgen/image/normal_angles.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>
#include <span>
#include <string_view>
#include <vector>

namespace foam::texgen {

namespace {

constexpr double kWhite = 65535.0;

/// Returns |a - b|; 0 if both are NaN, and infinity if only one is NaN.
double absolute_difference(double a, double b) {
    if (a == b || (std::isnan(a) && std::isnan(b))) {
        return 0.0;
    }
    const double distance = std::abs(a - b);
    return std::isnan(distance) ? std::numeric_limits<double>::infinity() : distance;
}

/// Calls visit(channel name, x, y, difference) for every sample. y counts from the bottom row.
template <class Visit>
void visit_differences(const Picture& a, const Picture& b, const Visit& visit) {
    const std::vector<PictureChannel> left = channels_of(a);
    const std::vector<PictureChannel> right = channels_of(b);
    std::vector<double> left_row(static_cast<std::size_t>(a.width()));
    std::vector<double> right_row(left_row.size());
    for (std::size_t k = 0; k < left.size(); ++k) {
        for (int y = 0; y < a.height(); ++y) {
            read_numbers(left[k], y, left_row);
            read_numbers(right[k], y, right_row);
            for (int x = 0; x < a.width(); ++x) {
                const auto at = static_cast<std::size_t>(x);
                visit(left[k].name, x, y, absolute_difference(left_row[at], right_row[at]));
            }
        }
    }
}

/// The limits above which the difference of one sample counts as a warning or as a failure.
struct SampleLimits {
    double warn;
    double fail;
};

/// Compares the samples of two pictures and writes the statistics of their differences to `found`.
/// Returns, for each pixel, the largest difference of its channels.
Image<double> measure_samples(const Picture& a,
                              const Picture& b,
                              const SampleLimits& limits,
                              Comparison& found) {
    Image<double> pixels(a.width(), a.height(), 1);
    double sum = 0.0;
    double sum_of_squares = 0.0;
    std::size_t count = 0;
    visit_differences(a, b, [&](std::string_view channel, int x, int y, double difference) {
        sum += difference;
        sum_of_squares += difference * difference;
        ++count;
        found.warnings += difference > limits.warn ? 1U : 0U;
        found.failures += difference > limits.fail ? 1U : 0U;
        double& pixel = pixels.pixel(x, y)[0];
        pixel = std::max(pixel, difference);
        if (difference > found.largest) {
            found.largest = difference;
            found.channel = channel;
            found.x = x;
            found.y = a.height() - 1 - y;
        }
    });
    found.mean = sum / static_cast<double>(count);
    found.rms = std::sqrt(sum_of_squares / static_cast<double>(count));
    return pixels;
}

/// Writes the largest angle to `found`, and the position of the pixel that has this angle. `angles`
/// is the result of normal_angles.
void note_largest_angle(std::span<const double> angles, int width, int height, Comparison& found) {
    const auto largest = std::ranges::max_element(angles);
    const auto index = static_cast<int>(largest - angles.begin());
    found.angle = *largest;
    found.angle_x = index % width;
    found.angle_y = height - 1 - index / width;
}

}  // namespace

bool have_same_layout(const Picture& a, const Picture& b) {
    return a.width() == b.width() && a.height() == b.height() &&
           std::ranges::equal(
               channels_of(a), channels_of(b), {}, &PictureChannel::name, &PictureChannel::name);
}

Comparison compare(const Picture& a,
                   const Picture& b,
                   const CompareLimits& limits,
                   PixelContent content) {
    Comparison found;
    if (!have_same_layout(a, b)) {
        found.verdict = Verdict::DifferentLayout;
        return found;
    }
    const bool has_normals = content == PixelContent::Normals && can_hold_normals(a);
    const SampleLimits sample_limits{limits.warn.sample_limit(has_normals),
                                     limits.fail.sample_limit(has_normals)};
    const Image<double> differences = measure_samples(a, b, sample_limits, found);
    const std::vector<double> angles = has_normals ? normal_angles(a, b) : std::vector<double>();
    if (has_normals) {
        note_largest_angle(angles, a.width(), a.height(), found);
    }
    judge({differences.samples(), angles}, limits, found);
    return found;
}

Image<std::uint16_t> difference_picture(const Picture& a, const Picture& b) {
    assert(have_same_layout(a, b));
    Image<double> maxima(a.width(), a.height(), 1);
    double largest = 0.0;
    visit_differences(a, b, [&](std::string_view, int x, int y, double difference) {
        const double finite = std::min(difference, std::numeric_limits<double>::max());
        maxima.pixel(x, y)[0] = std::max(maxima.pixel(x, y)[0], finite);
        largest = std::max(largest, finite);
    });
    Image<std::uint16_t> picture(a.width(), a.height(), 1);
    std::ranges::transform(maxima.samples(), picture.samples().begin(), [&](double difference) {
        return static_cast<std::uint16_t>(largest > 0.0 ? difference / largest * kWhite + 0.5
                                                        : 0.0);
    });
    return picture;
}

}  // namespace foam::texgen
