// SPDX-License-Identifier: Apache-2.0

#include "texgen/bake/frame_range.h"

#include <fmt/core.h>

#include <algorithm>
#include <charconv>
#include <cstddef>
#include <cstdlib>
#include <numeric>
#include <stdexcept>

namespace foam::texgen {

namespace {

/// A range `first-last`, optionally followed by `xSTEP` or `ySTEP`.
struct Range {
    int first = 0;
    int last = 0;
    int step = 1;
    bool inverted = false;  // true for ySTEP, which selects the frames that xSTEP skips
};

// The largest sum of the lengths of all ranges. It limits the time that parsing a list takes.
constexpr int kMaxTotalLength = 10 * kLastFrame;

[[noreturn]] void reject(std::string_view text, std::string_view reason) {
    throw std::invalid_argument(fmt::format("frame range '{}': {}", text, reason));
}

/// Parses frame ranges from left to right. Each function removes the characters that it has parsed
/// from the front of the text.
class Scanner {
  public:
    explicit Scanner(std::string_view text) : text_(text), rest_(text) {}

    bool at_end() const { return rest_.empty(); }

    bool take(char c) {
        const bool found = !rest_.empty() && rest_.front() == c;
        rest_.remove_prefix(found ? 1 : 0);
        return found;
    }

    int number() {
        int value = 0;
        const auto [end, error] = std::from_chars(rest_.data(), rest_.data() + rest_.size(), value);
        if (end == rest_.data() || rest_.front() == '-') {
            reject(
                text_,
                "must be a list of ranges such as 5, 1-10, 1-10x2 or 1-10y3, separated by commas");
        }
        if (error != std::errc{} || value < 1 || value > kLastFrame) {
            reject(text_, fmt::format("frames and steps must be from 1 to {}", kLastFrame));
        }
        rest_.remove_prefix(static_cast<std::size_t>(end - rest_.data()));
        return value;
    }

    Range range() {
        Range range;
        range.first = range.last = number();
        if (take('-')) {
            range.last = number();
            range.inverted = take('y');
            if (range.inverted || take('x')) {
                range.step = number();
            }
        }
        return range;
    }

  private:
    std::string_view text_;
    std::string_view rest_;
};

// Appends the frames of a range that are not yet marked in `seen`, and marks them. `seen` is
// indexed by frame numbers.
void expand(const Range& range, std::vector<bool>& seen, std::vector<int>& frames) {
    const int count = std::abs(range.last - range.first) + 1;
    const int direction = range.last < range.first ? -1 : 1;
    for (int i = 0; i < count; i += range.inverted ? 1 : range.step) {
        const bool on_step = i % range.step == 0;
        const int frame = range.first + direction * i;
        const auto index = static_cast<std::size_t>(frame);
        if (on_step != range.inverted && !seen[index]) {
            seen[index] = true;
            frames.push_back(frame);
        }
    }
}

/// Returns the number of frames in the longest prefix that is an arithmetic progression.
std::size_t run_length(std::span<const int> frames) {
    std::size_t length = frames.size() < 2 ? frames.size() : 2;
    while (length < frames.size() && frames[length] - frames[length - 1] == frames[1] - frames[0]) {
        ++length;
    }
    return length;
}

std::string format_run(int first, int last, int step) {
    return step == 1 ? fmt::format("{}-{}", first, last)
                     : fmt::format("{}-{}x{}", first, last, step);
}

}  // namespace

std::vector<int> parse_frame_range(std::string_view text) {
    std::vector<bool> seen(kLastFrame + 1);
    std::vector<int> frames;
    Scanner scanner(text);
    int length = 0;
    do {
        const Range range = scanner.range();
        length += std::abs(range.last - range.first) + 1;
        if (length > kMaxTotalLength) {
            reject(text,
                   fmt::format("the ranges have more than {} frames in all", kMaxTotalLength));
        }
        expand(range, seen, frames);
    } while (scanner.take(','));
    if (!scanner.at_end()) {
        reject(text,
               "must be a list of ranges such as 5, 1-10, 1-10x2 or 1-10y3, separated by commas");
    }
    if (frames.empty()) {
        reject(text, "contains no frame");
    }
    return frames;
}

std::vector<int> frames_to(int last) {
    std::vector<int> frames(static_cast<std::size_t>(last));
    std::iota(frames.begin(), frames.end(), 1);
    return frames;
}

std::vector<int> frames_or_all(std::string_view range, int last) {
    return range.empty() ? frames_to(last) : parse_frame_range(range);
}

std::string format_frame_range(std::span<const int> frames) {
    std::string text;
    while (!frames.empty()) {
        const std::size_t length = run_length(frames);
        const int step = length > 1 ? std::abs(frames[1] - frames[0]) : 1;
        const bool range = length > 2 || (length == 2 && step == 1);
        text += text.empty() ? "" : ",";
        text += range ? format_run(frames.front(), frames[length - 1], step)
                      : fmt::format("{}", frames.front());
        frames = frames.subspan(range ? length : 1);
    }
    return text;
}

bool closes_loop(std::span<const int> frames, int count) {
    std::vector<int> cycle(frames.begin(), frames.end());
    std::ranges::sort(cycle);
    cycle.push_back(cycle.front());
    const int step = cycle[1] - cycle[0];
    for (std::size_t k = 1; k < cycle.size(); ++k) {
        if ((cycle[k] - cycle[k - 1] - step) % count != 0) {
            return false;
        }
    }
    return true;
}

}  // namespace foam::texgen
