// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "texgen/animation/phase_clock.h"
#include "texgen/animation/progress.h"

#include <condition_variable>
#include <mutex>
#include <stop_token>
#include <thread>

namespace foam::texgen {

/// The level of detail with which a run reports its progress on stderr.
enum class Verbosity {
    Quiet,
    Normal,   // a progress bar if stderr is a terminal
    Verbose,  // a line per frame, and lines for the other phases
};

/// The options of a ProgressReporter.
struct ProgressOptions {
    Verbosity verbosity = Verbosity::Normal;
    bool json = false;  // true for JSON lines in place of a bar or lines
    int frames = 0;     // number of frames of the phase Frames; 0 if unknown
};

/// Reports the progress of one run on stderr, in one of four styles:
///
/// - JSON lines (progress_json), if ProgressOptions::json is true: the first and the last report of
///   the run, and otherwise one line per second.
/// - lines, for Verbosity::Verbose. The phase Frames has one line per frame. Every other phase has
///   one line at its start, one when its last unit is reported, and otherwise at most one per
///   second. In the phase LoopClosing, the last unit of each cycle also has a line.
/// - a bar, for Verbosity::Normal if stderr is a terminal. It is in color only if the environment
///   variable NO_COLOR is unset or empty.
/// - nothing, in all other cases, and always for Verbosity::Quiet.
///
/// In the styles JSON lines and bar, a thread prints the latest report, with the present times, if
/// nothing has been printed for a second. Long steps, such as the first equilibrium of a large
/// foam, are therefore not silent.
///
/// With Verbosity::Normal and without JSON, a note tells the user if the rest of the run takes a
/// minute or more. It is printed as soon as this can be estimated from the first units, such as
/// frames, of a phase.
class ProgressReporter {
  public:
    /// Begins the run. From now on, SIGINT, SIGTERM and SIGHUP stop the run after its current step
    /// instead of ending the process at once (handle_stop_signals).
    explicit ProgressReporter(const ProgressOptions& options);

    /// Ends the run. In the styles bar and JSON lines, prints the last report if it has news and is
    /// not yet printed. Ends the line of the bar.
    ~ProgressReporter();

    ProgressReporter(const ProgressReporter&) = delete;
    ProgressReporter& operator=(const ProgressReporter&) = delete;

    /// Returns the callback that reports. After SIGINT, SIGTERM or SIGHUP it throws Interrupted,
    /// unless it has just received the last unit of a phase (RunProgress::finished). The reporter
    /// must outlive the callback.
    ProgressCallback callback();

  private:
    enum class Style { Nothing, Bar, Lines, JsonLines };

    static Style style_of(const ProgressOptions& options);
    void beat(const std::stop_token& stop);  // runs in the thread that repeats reports
    void take(const RunProgress& progress);
    bool is_due(PhaseClock::News news) const;
    void print();
    void note_long_run();
    std::optional<double> seconds_per_unit() const;
    double seconds_since(PhaseClock::Clock::time_point begin) const;

    std::mutex mutex_;  // protects the members from clock_ to has_noted_
    std::condition_variable_any wake_;
    ProgressOptions options_;
    Style style_;
    bool has_color_;
    PhaseClock clock_;
    PhaseClock::Clock::time_point begin_ = PhaseClock::Clock::now();
    PhaseClock::Clock::time_point now_ = begin_;  // time of the latest report or repetition
    PhaseClock::Clock::time_point phase_begin_ = begin_;
    PhaseClock::Clock::time_point last_print_ = begin_;
    RunProgress latest_;
    bool has_frames_ = false;  // true once the phase Frames has begun
    bool has_printed_ = false;
    bool is_pending_ = false;  // true if there has been news since the last report that was printed
    bool has_noted_ = false;
    std::jthread heartbeat_;  // the last member, because its thread uses the others
};

}  // namespace foam::texgen
