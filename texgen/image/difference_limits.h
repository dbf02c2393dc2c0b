// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

namespace foam::texgen {

/// The limit of the difference of a sample if no other limit replaces it
/// (DifferenceLimits::sample_limit). OpenImageIO's program idiff has the same default.
inline constexpr double kDefaultSampleLimit = 1e-6;

/// A limit on a percentile of the differences of all pixels: at least `percent` percent of the
/// pixels must differ by at most `difference`.
struct PercentileLimit {
    double percent = 100.0;  // above 0, at most 100
    double difference = 0.0;

    friend bool operator==(const PercentileLimit&, const PercentileLimit&) = default;
};

/// The limits of the differences between two pictures. Codes (SampleType) are scaled so that the
/// largest code is 1; other samples are not scaled (read_numbers). The difference of a pixel is the
/// largest difference of its samples. A pixel is above the limits if its difference exceeds the
/// limit of samples (sample_limit), or if the angle between its normals exceeds `angle`. As in
/// idiff, some pixels may be above the limits: `allowed_percent` percent of the pixels or
/// `allowed_pixels` pixels, whichever number is larger.
struct DifferenceLimits {
    std::optional<double> sample{};  // limit of the difference of a sample; see sample_limit
    std::optional<double> angle{};   // degrees; only pictures of normals have angles
    double allowed_percent = 0.0;
    std::int64_t allowed_pixels = 0;
    std::optional<double> hard{};  // limit of Comparison::largest
    std::optional<double> rms{};   // limit of Comparison::rms
    std::vector<PercentileLimit> percentiles{};

    /// Returns the limit of the difference of a sample:
    /// - `sample`, if it is given;
    /// - infinity, if `sample` is not given, but `rms`, `percentiles` or `angle` is, because
    ///   kDefaultSampleLimit would forbid differences that the given limit allows;
    /// - kDefaultSampleLimit, if none of these limits is given.
    ///
    /// `angle` counts only if `has_normals` is true.
    double sample_limit(bool has_normals) const;

    /// Returns how many of `pixels` pixels may be above the limits.
    std::size_t allowed_of(std::size_t pixels) const;
};

/// The limits above which two pictures differ enough for a warning, and for a failure.
struct CompareLimits {
    DifferenceLimits warn{};
    DifferenceLimits fail{};
};

}  // namespace foam::texgen
