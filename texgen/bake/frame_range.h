// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace foam::texgen {

/// The largest frame number that a range may contain.
constexpr int kLastFrame = 1'000'000;

/// Parses a frame range in the notation of programs for movie production. Returns the frames in the
/// order of the range, each once:
///
///     5        one frame                     1-10     first to last
///     1-10x2   every second: 1 3 5 7 9       1-10y3   all but every third: 2 3 5 6 8 9
///     10-1     backwards                     1-3,7    a list of ranges
///
/// Throws std::invalid_argument for any other text, and for a text that selects no frame. Also
/// throws it for frames and steps outside 1 to kLastFrame, and for ranges that are together longer
/// than ten million frames.
std::vector<int> parse_frame_range(std::string_view text);

/// Returns the frames from 1 to `last`.
std::vector<int> frames_to(int last);

/// Returns the frames of a range, or the frames from 1 to `last` if the text is empty. Throws as
/// parse_frame_range does.
std::vector<int> frames_or_all(std::string_view range, int last);

/// Returns a short text that parse_frame_range parses to these frames. Two or more consecutive
/// frames from A to B become `A-B`. Three or more frames from A to B with a larger constant step S
/// become `A-BxS`. The frames may also decrease. Precondition: each frame is given once.
std::string format_frame_range(std::span<const int> frames);

/// Returns true if the frames, played repeatedly in increasing order, advance evenly through a loop
/// of `count` frames. This is the case if the step from each frame to the next one is the same,
/// modulo `count`. The first frame counts as the next frame after the last one. Examples for a loop
/// of 48 frames are 1-48, 1-48x2 and a single frame. Preconditions: there is a frame; `count` is
/// positive.
bool closes_loop(std::span<const int> frames, int count);

}  // namespace foam::texgen
