// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "texgen/image/image.h"
#include "texgen/image/picture.h"

#include <cstddef>
#include <cstdint>
#include <string>

namespace foam::texgen {

/// The allowed differences between two samples. Codes (SampleType) are scaled so that the largest
/// code is 1; other samples are not scaled (read_numbers). The defaults are the defaults of
/// OpenImageIO's program idiff.
struct CompareLimits {
    double warn = 1e-6;  // a larger difference is a warning
    double fail = 1e-6;  // a larger difference is a failure
};

/// The result of a comparison. Same: no difference is above a limit. Warning: a difference is above
/// `warn`, but none is above `fail`. Failure: a difference is above `fail`. DifferentLayout: the
/// pictures differ in width, height or channel names.
enum class Verdict { Same, Warning, Failure, DifferentLayout };

/// The differences between two pictures.
struct Comparison {
    Verdict verdict = Verdict::Same;
    double largest = 0.0;      // largest |a - b|; infinite if only one of two samples is NaN
    double mean = 0.0;         // mean of |a - b| over all samples
    std::size_t warnings = 0;  // number of samples whose difference exceeds CompareLimits::warn
    std::size_t failures = 0;  // number of samples whose difference exceeds CompareLimits::fail
    std::string channel;       // channel of the largest difference; empty if all samples are equal
    int x = 0;                 // column of the largest difference, from the left
    int y = 0;                 // row of the largest difference, from the top
};

/// Compares two pictures sample by sample. If widths, heights or channel names differ, the verdict
/// is DifferentLayout and all other members keep their defaults.
Comparison compare(const Picture& a, const Picture& b, const CompareLimits& limits = {});

/// Returns a gray picture of the differences. A pixel shows the largest difference among its
/// channels. The largest difference in the whole picture is white. Precondition: the verdict of
/// `compare` is not DifferentLayout.
Image<std::uint16_t> difference_picture(const Picture& a, const Picture& b);

}  // namespace foam::texgen
