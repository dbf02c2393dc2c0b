// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace foam::texgen {

/// The result of a comparison.
enum class Verdict {
    Same,             // no limit of CompareLimits is exceeded
    Warning,          // a limit for warnings is exceeded, but no limit for failures
    Failure,          // a limit for failures is exceeded
    DifferentLayout,  // the pictures differ in width, height or channel names
    Unreadable,       // a picture could not be read; the function `compare` never returns this
};

/// The percentile that Comparison::percentile reports.
inline constexpr double kReportedPercentile = 99.9;

/// The differences between two pictures. The difference of a pixel is the largest difference of its
/// samples. Columns x are counted from the left, rows y from the top.
struct Comparison {
    Verdict verdict = Verdict::Same;
    double largest = 0.0;     // largest |a - b|; infinite if only one of two samples is NaN
    double mean = 0.0;        // mean of |a - b| over all samples
    double rms = 0.0;         // root mean square of |a - b| over all samples
    double percentile = 0.0;  // percentile_of(differences of the pixels, kReportedPercentile)
    // `warnings` counts the samples whose difference exceeds the sample limit for warnings,
    // `failures` those whose difference exceeds the sample limit for failures
    // (DifferenceLimits::sample_limit).
    std::size_t warnings = 0;
    std::size_t failures = 0;
    std::string channel{};   // channel of the largest difference; empty if all samples are equal
    int x = 0;               // column of the largest difference
    int y = 0;               // row of the largest difference
    std::size_t pixels = 0;  // number of pixels
    // `warning_pixels` counts the pixels above the limits for warnings, `failure_pixels` those
    // above the limits for failures (DifferenceLimits).
    std::size_t warning_pixels = 0;
    std::size_t failure_pixels = 0;
    // Largest angle between normals, degrees; nullopt if pixels are not compared as normals.
    std::optional<double> angle{};
    int angle_x = 0;  // column of the largest angle
    int angle_y = 0;  // row of the largest angle
    /// The exceeded limits in words, such as "rms 0.02 above 0.01". For the verdict Failure, only
    /// limits for failures are listed; for the verdict Warning, limits for warnings. For all other
    /// verdicts the list is empty.
    std::vector<std::string> reasons{};
};

}  // namespace foam::texgen
