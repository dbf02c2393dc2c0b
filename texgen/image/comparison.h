// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace foam::texgen {

/// The result of a comparison. Same: no limit of a warning is exceeded. Warning: a limit of a
/// warning is exceeded, but no limit of a failure. Failure: a limit of a failure is exceeded.
/// DifferentLayout: the pictures differ in width, height or channel names. Unreadable: a picture
/// could not be read; the function `compare` never returns it.
enum class Verdict { Same, Warning, Failure, DifferentLayout, Unreadable };

/// The percentile of the differences of pixels that a Comparison reports.
inline constexpr double kReportedPercentile = 99.9;

/// The differences between two pictures. The difference of a pixel is the largest difference of its
/// samples. Columns x are counted from the left, rows y from the top.
struct Comparison {
    Verdict verdict = Verdict::Same;
    double largest = 0.0;      // largest |a - b|; infinite if only one of two samples is NaN
    double mean = 0.0;         // mean of |a - b| over all samples
    double rms = 0.0;          // root mean square of |a - b| over all samples
    double percentile = 0.0;   // smallest difference that kReportedPercentile % of the pixels keep
    std::size_t warnings = 0;  // number of samples above the limit of samples for warnings
    std::size_t failures = 0;  // number of samples above the limit of samples for failures
    std::string channel{};     // channel of the largest difference; empty if all samples are equal
    int x = 0;                 // column of the largest difference
    int y = 0;                 // row of the largest difference
    std::size_t pixels = 0;    // number of pixels
    std::size_t warning_pixels = 0;  // number of pixels above the limits for warnings
    std::size_t failure_pixels = 0;  // number of pixels above the limits for failures
    std::optional<double> angle{};   // largest angle between normals, degrees; only for Normals
    int angle_x = 0;                 // column of the largest angle
    int angle_y = 0;                 // row of the largest angle
    /// The limits that the verdict is due to, in words, such as "rms 0.02 above 0.01". Empty for
    /// Same and DifferentLayout.
    std::vector<std::string> reasons{};
};

}  // namespace foam::texgen
