// SPDX-License-Identifier: Apache-2.0

#include "texgen/cli/interruption.h"

#include <unistd.h>

#include <atomic>
#include <cerrno>
#include <csignal>
#include <string_view>

namespace foam::texgen {

namespace {

// The signal that arrived last, or 0.
std::atomic<int> stop_signal{0};
// True if throw_if_interrupted has thrown because of this signal. If false, the next call of
// handle_stop_signals keeps the signal, so that no signal is lost between two parts of a run.
std::atomic<bool> is_reported{false};
static_assert(std::atomic<int>::is_always_lock_free, "signal handlers may use it");

// Tells how the run will stop after a signal. The signal handler writes this to stderr (stop_note).
// handle_stop_signals may change it while handlers are installed.
std::atomic<Stopping> stopping_of_run{Stopping::AfterStep};
static_assert(std::atomic<Stopping>::is_always_lock_free, "signal handlers may use it");

std::string_view stop_note(Stopping stopping) {
    return stopping == Stopping::AfterStep
               ? "\nfoamtex: stopping after the current step; the same signal again stops at once\n"
               : "\nfoamtex: stopping; the same signal again stops at once\n";
}

// The signal handler: stores the signal and writes a note. Calls only functions that a signal
// handler may call.
void take_signal(int signal) {
    const int error = errno;  // the errno of the code that the signal interrupts
    stop_signal = signal;
    // If stderr is a pipe without a reader, the write must fail instead of ending the process.
    struct sigaction ignore {};
    struct sigaction before {};
    ignore.sa_handler = SIG_IGN;
    sigaction(SIGPIPE, &ignore, &before);
    const std::string_view note = stop_note(stopping_of_run);
    [[maybe_unused]] const auto written = write(STDERR_FILENO, note.data(), note.size());
    sigaction(SIGPIPE, &before, nullptr);
    errno = error;
}

}  // namespace

Interrupted::Interrupted(int signal)
    : std::runtime_error(signal == SIGINT   ? "interrupted"
                         : signal == SIGHUP ? "hung up"
                                            : "terminated"),
      signal_(signal) {}

void handle_stop_signals(Stopping stopping) {
    if (is_reported.exchange(false)) {
        stop_signal = 0;
    }
    stopping_of_run = stopping;
    for (const int signal : {SIGINT, SIGTERM, SIGHUP}) {
        struct sigaction action {};
        sigaction(signal, nullptr, &action);
        if (signal == SIGHUP && action.sa_handler == SIG_IGN) {
            continue;
        }
        action = {};
        action.sa_handler = take_signal;
        action.sa_flags = static_cast<int>(SA_RESETHAND) | SA_RESTART;
        sigaction(signal, &action, nullptr);
    }
}

void throw_if_interrupted() {
    if (const int signal = stop_signal; signal != 0) {
        is_reported = true;
        throw Interrupted(signal);
    }
}

}  // namespace foam::texgen
