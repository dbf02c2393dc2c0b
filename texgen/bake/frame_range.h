#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace foam::texgen {

/// The largest frame number a range may name.
constexpr int kLastFrame = 1'000'000;

/// The frames of a range as the film world writes it, in its order, each once:
///
///     5        one frame                     1-10     first to last
///     1-10x2   every second: 1 3 5 7 9       1-10y3   all but every third: 2 3 5 6 8 9
///     10-1     backwards                     1-3,7    a list of ranges
///
/// Throws std::invalid_argument for anything else, for frames outside 1 to kLastFrame and for a
/// range that leaves no frame.
std::vector<int> parse_frame_range(std::string_view text);

/// A short range that parse_frame_range reads as these frames: runs of equal steps become `a-bxs`.
std::string format_frame_range(std::span<const int> frames);

}  // namespace foam::texgen
