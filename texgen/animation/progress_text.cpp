// SPDX-License-Identifier: Apache-2.0

#include "texgen/animation/progress_text.h"

#include "texgen/json/json_writer.h"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace foam::texgen {

namespace {

constexpr int kBarWidth = 24;  // characters between the brackets

struct PhaseWords {
    std::string_view name;  // for programs
    std::string_view text;  // for users; phase_text usually appends numbers: "state 3 of 48"
};

// The words for all phases, in the order of Phase.
constexpr std::array<PhaseWords, 10> kPhaseWords{{
    {"seeding", "placing the bubbles"},
    {"equilibrium", "finding the first equilibrium"},
    {"warm_up", "warm-up"},
    {"loop_closing", "closing the loop"},
    {"states", "state"},
    {"ranges", "ranges: frame"},
    {"frames", "frame"},
    {"files", "file"},
    {"sheets", "sheets: frame"},
    {"previews", "previews: picture"},
}};

const PhaseWords& words_of(Phase phase) {
    return kPhaseWords.at(static_cast<std::size_t>(phase));
}

std::string loop_closing_text(const RunProgress& progress) {
    const bool has_closing_error = progress.measure && std::isfinite(*progress.measure);
    const bool is_usual = progress.cycle <= progress.usual_cycles;
    return fmt::format("{}: cycle {}{} ({}/{}){}",
                       words_of(progress.phase).text,
                       progress.cycle,
                       is_usual ? fmt::format(" of about {}", progress.usual_cycles) : "",
                       progress.done,
                       progress.total,
                       has_closing_error ? fmt::format(", error {:.0e}", *progress.measure) : "");
}

/// Returns a time in minutes and seconds, such as "0:14".
std::string minutes_and_seconds(double seconds) {
    const auto rounded = static_cast<long>(std::ceil(seconds));
    return fmt::format("{}:{:02}", rounded / 60, rounded % 60);
}

/// Returns the last part of the text of a bar: the time left, if it is known. If it is unknown and
/// nothing else shows that the run advances, returns the time that the phase has taken so far.
std::string time_text(const RunProgress& progress, const PhaseTimes& times) {
    if (times.left) {
        return fmt::format("  {} left", minutes_and_seconds(*times.left));
    }
    const bool shows_passed = progress.done == 0 && progress.phase != Phase::LoopClosing;
    return shows_passed && times.passed >= 1.0
               ? fmt::format("  {} so far", minutes_and_seconds(std::floor(times.passed)))
               : "";
}

/// Returns a time in seconds, rounded to milliseconds.
double rounded_to_milliseconds(double seconds) {
    return std::round(seconds * 1000.0) / 1000.0;
}

Json count_or_null(int count) {
    return count > 0 ? Json(count) : Json(nullptr);
}

}  // namespace

std::string_view name_of(Phase phase) {
    return words_of(phase).name;
}

std::string phase_text(const RunProgress& progress) {
    if (progress.total == 0) {
        return std::string(words_of(progress.phase).text);
    }
    if (progress.phase == Phase::LoopClosing) {
        return loop_closing_text(progress);
    }
    return fmt::format("{} {} of {}", words_of(progress.phase).text, progress.done, progress.total);
}

std::string progress_bar(const RunProgress& progress, const PhaseTimes& times) {
    const double fraction =
        progress.total > 0 ? static_cast<double>(progress.done) / progress.total : 0.0;
    const int filled = std::clamp(static_cast<int>(kBarWidth * fraction), 0, kBarWidth);
    const auto hashes = static_cast<std::size_t>(filled);
    // The text of LoopClosing is long, so the number of bubbles is left out.
    const bool shows_bubbles = progress.bubbles > 0 && progress.phase != Phase::LoopClosing;
    return fmt::format("[{}{}] {}{}{}",
                       std::string(hashes, '#'),
                       std::string(kBarWidth - hashes, '-'),
                       phase_text(progress),
                       shows_bubbles ? fmt::format("  {} bubbles", progress.bubbles) : "",
                       time_text(progress, times));
}

std::string progress_line(const RunProgress& progress, double seconds) {
    if (progress.phase != Phase::Frames) {
        return fmt::format("{}, {:.2f} s", phase_text(progress), seconds);
    }
    return fmt::format("frame {}: {} bubbles, area error {:.1e}, angle error {:.1e}, {:.2f} s",
                       progress.frame,
                       progress.bubbles,
                       progress.area_error,
                       progress.angle_error,
                       seconds);
}

std::string progress_json(const RunProgress& progress,
                          double seconds,
                          const std::optional<double>& seconds_left) {
    const Json object = {
        {"phase", name_of(progress.phase)},
        {"done", progress.done},
        {"total", count_or_null(progress.total)},
        {"seconds", rounded_to_milliseconds(seconds)},
        {"seconds_left",
         seconds_left ? Json(rounded_to_milliseconds(*seconds_left)) : Json(nullptr)},
        {"frame", count_or_null(progress.frame)},
        {"bubbles", count_or_null(progress.bubbles)},
        {"cycle", count_or_null(progress.cycle)},
        {"measure", number_or_null(progress.measure)}};
    return json_text(object);
}

std::string long_duration(double seconds) {
    // Durations of at least this many minutes are printed in hours.
    constexpr double kMinutesAsHours = 90.0;
    const double minutes = std::ceil(seconds / 60.0);
    if (minutes >= kMinutesAsHours) {
        return fmt::format("{:.1f} hours", std::ceil(minutes / 6.0) / 10.0);
    }
    return fmt::format("{:.0f} minute{}", minutes, minutes == 1.0 ? "" : "s");
}

}  // namespace foam::texgen
