// SPDX-License-Identifier: Apache-2.0

#include "texgen/image/limit_check.h"

#include <fmt/core.h>

#include <algorithm>
#include <cassert>
#include <cmath>
#include <cstddef>

namespace foam::texgen {

namespace {

/// Returns the number of pixels above the limits.
std::size_t count_above(const PixelDifferences& all, const DifferenceLimits& limits) {
    const double sample = limits.sample_limit(!all.angles.empty());
    std::size_t count = 0;
    for (std::size_t k = 0; k < all.differences.size(); ++k) {
        const bool exceeds_angle =
            limits.angle && !all.angles.empty() && all.angles[k] > *limits.angle;
        count += all.differences[k] > sample || exceeds_angle ? 1U : 0U;
    }
    return count;
}

/// Returns the limits of a pixel in words, such as "0.01 or 2 degrees".
std::string limits_in_words(const DifferenceLimits& limits, bool has_normals) {
    const double sample = limits.sample_limit(has_normals);
    std::string words = std::isfinite(sample) ? fmt::format("{}", sample) : "";
    if (limits.angle && has_normals) {
        words += fmt::format("{}{} degrees", words.empty() ? "" : " or ", *limits.angle);
    }
    return words;
}

/// Returns one text for each limit that the differences exceed; none if they exceed no limit.
/// `above` is the number of pixels above the limits.
std::vector<std::string> reasons_of(const PixelDifferences& all,
                                    const DifferenceLimits& limits,
                                    std::size_t above,
                                    const Comparison& found) {
    std::vector<std::string> reasons;
    const std::size_t allowed = limits.allowed_of(found.pixels);
    if (above > allowed) {
        reasons.push_back(
            fmt::format("{} of {} pixels above {}{}",
                        above,
                        found.pixels,
                        limits_in_words(limits, !all.angles.empty()),
                        allowed > 0 ? fmt::format(" although only {} are allowed", allowed) : ""));
    }
    if (limits.hard && found.largest > *limits.hard) {
        reasons.push_back(
            fmt::format("largest difference {:.6g} above {}", found.largest, *limits.hard));
    }
    if (limits.rms && found.rms > *limits.rms) {
        reasons.push_back(fmt::format("rms {:.6g} above {}", found.rms, *limits.rms));
    }
    for (const auto& [percent, difference] : limits.percentiles) {
        const double percentile = percentile_of(all.differences, percent);
        if (percentile > difference) {
            reasons.push_back(
                fmt::format("percentile {} = {:.6g} above {}", percent, percentile, difference));
        }
    }
    return reasons;
}

}  // namespace

double percentile_of(std::span<const double> differences, double percent) {
    assert(!differences.empty() && percent > 0.0 && percent <= 100.0);
    // The multiplication comes first, because 99.9 * 1000 / 100 is exactly 999 in doubles. The
    // result of 99.9 / 100 * 1000 is larger, so std::ceil would return 1000.
    const double rank = std::ceil(percent * static_cast<double>(differences.size()) / 100.0);
    const auto index = std::min(static_cast<std::size_t>(rank), differences.size()) - 1;
    std::vector<double> sorted(differences.begin(), differences.end());
    const auto nth = sorted.begin() + static_cast<std::ptrdiff_t>(index);
    std::ranges::nth_element(sorted, nth);
    return *nth;
}

void judge(const PixelDifferences& differences, const CompareLimits& limits, Comparison& found) {
    found.pixels = differences.differences.size();
    found.percentile = percentile_of(differences.differences, kReportedPercentile);
    found.warning_pixels = count_above(differences, limits.warn);
    found.failure_pixels = count_above(differences, limits.fail);
    found.verdict = Verdict::Failure;
    found.reasons = reasons_of(differences, limits.fail, found.failure_pixels, found);
    if (found.reasons.empty()) {
        found.verdict = Verdict::Warning;
        found.reasons = reasons_of(differences, limits.warn, found.warning_pixels, found);
    }
    if (found.reasons.empty()) {
        found.verdict = Verdict::Same;
    }
}

}  // namespace foam::texgen
