// SPDX-License-Identifier: Apache-2.0

#include "texgen/cli/progress.h"

#include "texgen/animation/progress_text.h"
#include "texgen/cli/interruption.h"
#include "texgen/cli/standard_error.h"

#include <fmt/core.h>
#include <sys/ioctl.h>
#include <unistd.h>

#include <cstdlib>
#include <string>
#include <system_error>

namespace foam::texgen {

namespace {

constexpr double kBarInterval = 0.1;           // seconds between two drawings of the bar
constexpr double kLineInterval = 1.0;          // seconds between two lines
constexpr std::chrono::seconds kHeartbeat{1};  // time after which the latest report is repeated
// A note is printed if the rest of the run takes at least this time, in seconds.
constexpr double kLongRun = 60.0;
// Before this note, the speed of a phase is measured for at least this time, in seconds.
constexpr double kMeasuringTime = 2.0;

bool wants_color() {
    const char* no_color = std::getenv("NO_COLOR");
    return no_color == nullptr || *no_color == '\0';
}

/// Returns the number of columns of the terminal, or 80 if it is unknown.
std::size_t terminal_columns() {
    constexpr std::size_t kUsual = 80;
    winsize size{};
    return ioctl(STDERR_FILENO, TIOCGWINSZ, &size) == 0 && size.ws_col > 0 ? size.ws_col : kUsual;
}

}  // namespace

ProgressReporter::ProgressReporter(const ProgressOptions& options)
    : options_(options), style_(style_of(options)), has_color_(wants_color()) {
    handle_stop_signals();
    if (style_ != Style::Bar && style_ != Style::JsonLines) {
        return;
    }
    try {
        heartbeat_ = std::jthread([this](const std::stop_token& stop) { beat(stop); });
    } catch (const std::system_error&) {
        // Without another thread, long steps are silent.
    }
}

ProgressReporter::~ProgressReporter() {
    heartbeat_.request_stop();
    if (heartbeat_.joinable()) {
        heartbeat_.join();
    }
    if (is_pending_ && style_ != Style::Lines) {
        print();
    }
    if (style_ == Style::Bar && has_printed_) {
        write_stderr_without_waiting("\n");
    }
}

ProgressReporter::Style ProgressReporter::style_of(const ProgressOptions& options) {
    if (options.verbosity == Verbosity::Quiet) {
        return Style::Nothing;
    }
    if (options.json) {
        return Style::JsonLines;
    }
    if (options.verbosity == Verbosity::Verbose) {
        return Style::Lines;
    }
    return isatty(STDERR_FILENO) != 0 ? Style::Bar : Style::Nothing;
}

ProgressCallback ProgressReporter::callback() {
    return [this](const RunProgress& progress) { take(progress); };
}

void ProgressReporter::beat(const std::stop_token& stop) {
    std::unique_lock lock(mutex_);
    while (!stop.stop_requested()) {
        const auto due = (has_printed_ ? last_print_ : PhaseClock::Clock::now()) + kHeartbeat;
        wake_.wait_until(lock, stop, due, [] { return false; });
        const auto now = PhaseClock::Clock::now();
        if (!stop.stop_requested() && has_printed_ && now >= last_print_ + kHeartbeat) {
            now_ = now;
            clock_.advance(now);
            print();
        }
    }
}

void ProgressReporter::take(const RunProgress& progress) {
    const std::lock_guard lock(mutex_);
    now_ = PhaseClock::Clock::now();
    const PhaseClock::News news = clock_.add(progress, now_);
    if (news == PhaseClock::News::NewPhase) {
        phase_begin_ = now_;
        has_frames_ = has_frames_ || progress.phase == Phase::Frames;
    }
    latest_ = progress;
    is_pending_ = is_pending_ || news != PhaseClock::News::Nothing;
    note_long_run();
    if (is_due(news)) {
        print();
    }
    if (!progress.finished()) {
        throw_if_interrupted();
    }
}

bool ProgressReporter::is_due(PhaseClock::News news) const {
    const double passed = seconds_since(last_print_);
    switch (style_) {
        case Style::Bar:
            return !has_printed_ || passed >= kBarInterval;
        case Style::JsonLines:
            return !has_printed_ || passed >= kLineInterval;
        case Style::Lines:
            if (latest_.phase == Phase::Frames) {
                return news != PhaseClock::News::Nothing && latest_.done > 0;
            }
            return news == PhaseClock::News::NewPhase ||
                   (news == PhaseClock::News::Units &&
                    (latest_.finished() || passed >= kLineInterval));
        case Style::Nothing:
            break;
    }
    return false;
}

void ProgressReporter::print() {
    const double seconds = seconds_since(begin_);
    if (style_ == Style::Bar) {
        const std::string bar =
            progress_bar(latest_, {clock_.seconds_in_phase(), clock_.seconds_left()});
        write_stderr_without_waiting(fmt::format("\r\033[K{}{}{}",
                                                 has_color_ ? "\033[36m" : "",
                                                 bar.substr(0, terminal_columns() - 1),
                                                 has_color_ ? "\033[0m" : ""));
    } else if (style_ == Style::Lines) {
        write_stderr_without_waiting(progress_line(latest_, seconds) + "\n");
    } else if (style_ == Style::JsonLines) {
        write_stderr_without_waiting(progress_json(latest_, seconds, clock_.seconds_left()) + "\n");
    }
    last_print_ = now_;
    has_printed_ = true;
    is_pending_ = false;
}

// Returns the wall time per unit of the present phase. If the phase repeats a cycle, this is the
// mean of all steps since the phase began.
std::optional<double> ProgressReporter::seconds_per_unit() const {
    if (latest_.cycle == 0) {
        return clock_.seconds_per_unit();
    }
    const int steps = (latest_.cycle - 1) * latest_.total + latest_.done;
    return steps > 0 ? std::optional(seconds_since(phase_begin_) / steps) : std::nullopt;
}

// The estimate multiplies the measured time of a unit, such as a step, by the number of units left.
// Before the phase Frames, the frames are added to the units left. The reason: a step that prepares
// frame 1 takes about as long as the step to a later frame. If the usual number of cycles of a loop
// is known, the steps of its further cycles are added, too. Without this number, the estimate in
// the phases before Frames is a lower bound, because it includes neither drawing nor further
// cycles.
void ProgressReporter::note_long_run() {
    const std::optional<double> per_unit = seconds_per_unit();
    const bool wants_note = options_.verbosity == Verbosity::Normal && !options_.json;
    if (has_noted_ || !wants_note || !per_unit || seconds_since(phase_begin_) < kMeasuringTime) {
        return;
    }
    const bool frames_follow = latest_.phase < Phase::Frames && !has_frames_;
    const bool knows_cycles = latest_.cycle <= latest_.usual_cycles;
    const int cycles = knows_cycles ? latest_.usual_cycles - latest_.cycle : 0;
    const int units =
        (1 + cycles) * latest_.total - latest_.done + (frames_follow ? options_.frames : 0);
    const bool is_lower_bound = frames_follow && cycles == 0;
    const double seconds = units * *per_unit;
    if (seconds >= kLongRun) {
        has_noted_ = true;
        write_stderr_without_waiting(fmt::format("{}foamtex: note: this takes {} {} more\n",
                                                 style_ == Style::Bar ? "\r\033[K" : "",
                                                 is_lower_bound ? "at least" : "about",
                                                 long_duration(seconds)));
    }
}

double ProgressReporter::seconds_since(PhaseClock::Clock::time_point begin) const {
    return std::chrono::duration<double>(now_ - begin).count();
}

}  // namespace foam::texgen
