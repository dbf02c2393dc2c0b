// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <stdexcept>

namespace foam::texgen {

/// The exception that ends a run after SIGINT (Ctrl-C), SIGTERM, or SIGHUP (a closed terminal).
class Interrupted : public std::runtime_error {
  public:
    explicit Interrupted(int signal);

    int signal() const { return signal_; }

  private:
    int signal_;
};

/// Installs handlers for SIGINT, SIGTERM and SIGHUP. The first signal then makes
/// throw_if_interrupted throw instead of ending the process, and prints on stderr that the run will
/// stop after its current step. A second signal of the same kind ends the process immediately. A
/// SIGHUP that is ignored, as by nohup, stays ignored.
void handle_stop_signals();

/// Throws Interrupted if handle_stop_signals has been called and a signal has arrived since then.
void throw_if_interrupted();

}  // namespace foam::texgen
