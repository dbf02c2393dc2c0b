// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "texgen/image/image.h"
#include "texgen/image/picture.h"

#include <cstddef>
#include <cstdint>
#include <string>

namespace foam::texgen {

/// The allowed differences between two samples. The defaults are the same as in OpenImageIO's
/// idiff.
struct CompareLimits {
    double warn = 1e-6;  // a larger difference is a warning
    double fail = 1e-6;  // a larger difference is a failure
};

enum class Verdict { Same, Warning, Failure, OtherSize };

/// The differences between two pictures.
struct Comparison {
    Verdict verdict = Verdict::Same;
    double largest = 0.0;      // largest |a - b|; infinite if a sample is NaN in only one picture
    double mean = 0.0;         // mean of |a - b|
    std::size_t warnings = 0;  // number of samples beyond CompareLimits::warn
    std::size_t failures = 0;  // number of samples beyond CompareLimits::fail
    std::string channel;       // channel of the largest difference; empty if all are equal
    int x = 0;                 // column of the largest difference, from the left
    int y = 0;                 // row of the largest difference, from the top
};

/// Compares two pictures sample by sample. If extents or channel names differ, the verdict is
/// OtherSize and all other members keep their defaults.
Comparison compare(const Picture& a, const Picture& b, const CompareLimits& limits = {});

/// Returns a gray picture of the differences. A pixel shows the largest difference of its channels,
/// scaled so that the largest difference of the picture is white. Precondition: `compare` does not
/// return OtherSize.
Image<std::uint16_t> difference_picture(const Picture& a, const Picture& b);

}  // namespace foam::texgen
