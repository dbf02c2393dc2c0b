#pragma once

#include "texgen/image/image.h"
#include "texgen/image/picture.h"

#include <cstddef>
#include <cstdint>
#include <string>

namespace foam::texgen {

/// How far samples may lie apart; the defaults are idiff's.
struct CompareLimits {
    double warn = 1e-6;  // warns of a sample that lies farther apart than this
    double fail = 1e-6;  // and fails for one beyond this
};

enum class Verdict { Same, Warning, Failure, OtherSize };

/// What two pictures have apart.
struct Comparison {
    Verdict verdict = Verdict::Same;
    double largest = 0.0;      // |a - b| over all samples; infinite where only one is a number
    double mean = 0.0;         // of |a - b|
    std::size_t warnings = 0;  // samples beyond the limit
    std::size_t failures = 0;
    std::string channel;  // of the largest
    int x = 0;            // from the left
    int y = 0;            // from the top
};

/// Compares sample by sample. Pictures of different extents, or with channels of different names,
/// are OtherSize and nothing else is said of them.
Comparison compare(const Picture& a, const Picture& b, const CompareLimits& limits = {});

/// The largest difference of every pixel over its channels as a grey picture, the largest of all as
/// white; black where there is none. Takes pictures that are not OtherSize.
Image<std::uint16_t> difference_picture(const Picture& a, const Picture& b);

}  // namespace foam::texgen
