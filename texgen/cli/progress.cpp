// SPDX-License-Identifier: Apache-2.0

#include "texgen/cli/progress.h"

#include "texgen/cli/interruption.h"

#include <fmt/core.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>

namespace foam::texgen {

namespace {

constexpr int kBarWidth = 24;  // characters between the brackets

/// Returns the estimated time left in minutes and seconds, such as "0:14 left". The remaining
/// frames are assumed to take as long as the frames so far. Precondition: at least one frame is
/// done.
std::string time_left(const RunProgress& progress) {
    const double ratio = static_cast<double>(progress.total - progress.done) / progress.done;
    const auto seconds = static_cast<long>(std::ceil(progress.seconds * ratio));
    return fmt::format("{}:{:02} left", seconds / 60, seconds % 60);
}

bool wants_color() {
    const char* no_color = std::getenv("NO_COLOR");
    return no_color == nullptr || *no_color == '\0';
}

/// Draws the bar over the previous one. The last bar ends with a newline, so that it stays visible.
void draw_bar(const RunProgress& progress, bool color) {
    const std::string bar = progress_bar(progress);
    const char* end = progress.done == progress.total ? "\n" : "";
    fmt::print(
        stderr, "\r\033[K{}{}{}{}", color ? "\033[36m" : "", bar, color ? "\033[0m" : "", end);
    std::fflush(stderr);
}

}  // namespace

std::string progress_bar(const RunProgress& progress) {
    const int filled = progress.total > 0 ? kBarWidth * progress.done / progress.total : 0;
    const auto hashes = static_cast<std::size_t>(std::clamp(filled, 0, kBarWidth));
    const std::string bar = std::string(hashes, '#') + std::string(kBarWidth - hashes, '-');
    const std::string left = progress.done > 0 ? "  " + time_left(progress) : "";
    return fmt::format("[{}] {:>{}}/{}  {} bubbles{}",
                       bar,
                       progress.done,
                       std::to_string(progress.total).size(),
                       progress.total,
                       progress.bubbles,
                       left);
}

std::string progress_line(const RunProgress& progress) {
    return fmt::format("frame {}: {} bubbles, area error {:.1e}, angle error {:.1e}, {:.2f} s",
                       progress.frame,
                       progress.bubbles,
                       progress.area_error,
                       progress.angle_error,
                       progress.seconds);
}

ProgressCallback progress_reporter(Verbosity verbosity) {
    const bool has_bar = verbosity == Verbosity::Normal && isatty(STDERR_FILENO) != 0;
    handle_stop_signals();
    return [=, color = wants_color()](const RunProgress& progress) {
        if (verbosity == Verbosity::Verbose) {
            fmt::print(stderr, "{}\n", progress_line(progress));
        } else if (has_bar) {
            draw_bar(progress, color);
        }
        if (progress.done < progress.total) {
            throw_if_interrupted();
        }
    };
}

}  // namespace foam::texgen
