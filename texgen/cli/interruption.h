// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <stdexcept>

namespace foam::texgen {

/// The exception that ends a run after SIGINT (Ctrl-C), SIGTERM, or SIGHUP (a closed terminal).
class Interrupted : public std::runtime_error {
  public:
    explicit Interrupted(int signal);

    /// Returns the number of the signal, such as SIGINT.
    int signal() const { return signal_; }

  private:
    int signal_;
};

/// Selects how a run stops after a signal. AfterStep: it stops after its current step, such as a
/// time step or the drawing of a frame. Soon: the run has no steps and stops soon. The signal
/// handler writes to stderr which of the two it is.
enum class Stopping { AfterStep, Soon };

/// Installs handlers for SIGINT, SIGTERM and SIGHUP. If one of these signals arrives, the process
/// does not end. Instead, the handler writes to stderr how the run will stop, and from then on
/// throw_if_interrupted throws. A second signal of the same kind ends the process immediately. If
/// the process ignores SIGHUP, as with nohup, SIGHUP stays ignored.
void handle_stop_signals(Stopping stopping = Stopping::AfterStep);

/// Throws Interrupted if SIGINT, SIGTERM or SIGHUP has arrived. Once this function has thrown, it
/// throws at every further call, until a new call of handle_stop_signals forgets the signal. If
/// this function has not thrown yet, handle_stop_signals does not forget the signal.
void throw_if_interrupted();

}  // namespace foam::texgen
