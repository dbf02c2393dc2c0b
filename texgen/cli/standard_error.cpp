// SPDX-License-Identifier: Apache-2.0

#include "texgen/cli/standard_error.h"

#include <fcntl.h>
#include <poll.h>
#include <unistd.h>

#include <cerrno>
#include <csignal>
#include <ctime>

namespace foam::texgen {

namespace {

/// Blocks the signal SIGPIPE for the calling thread. While an object of this class exists, writing
/// to a pipe without a reader fails instead of ending the process. Other threads are not affected,
/// because the kernel sends SIGPIPE to the thread that writes.
class NoBrokenPipeSignal {
  public:
    NoBrokenPipeSignal() {
        sigemptyset(&broken_pipe_);
        sigaddset(&broken_pipe_, SIGPIPE);
        pthread_sigmask(SIG_BLOCK, &broken_pipe_, &before_);
    }

    ~NoBrokenPipeSignal() {
        // Removes a pending SIGPIPE, which would otherwise end the process when the signal is
        // unblocked.
        constexpr timespec kNoWait{};
        while (sigtimedwait(&broken_pipe_, nullptr, &kNoWait) < 0 && errno == EINTR) {
        }
        pthread_sigmask(SIG_SETMASK, &before_, nullptr);
    }

    NoBrokenPipeSignal(const NoBrokenPipeSignal&) = delete;
    NoBrokenPipeSignal& operator=(const NoBrokenPipeSignal&) = delete;

  private:
    sigset_t broken_pipe_{};
    sigset_t before_{};
};

}  // namespace

void open_missing_streams() {
    for (const int stream : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO}) {
        if (fcntl(stream, F_GETFD) == -1 && errno == EBADF) {
            // open returns the lowest descriptor that is free, which is this stream.
            const int mode = stream == STDIN_FILENO ? O_WRONLY : O_RDONLY;
            [[maybe_unused]] const int opened = open("/dev/null", mode);
        }
    }
}

void write_stderr(std::string_view text) noexcept {
    const NoBrokenPipeSignal guard;
    while (!text.empty()) {
        const ssize_t written = write(STDERR_FILENO, text.data(), text.size());
        if (written > 0) {
            text.remove_prefix(static_cast<std::size_t>(written));
        } else if (errno != EINTR) {
            return;
        }
    }
}

void write_stderr_without_waiting(std::string_view text) noexcept {
    pollfd stream{STDERR_FILENO, POLLOUT, 0};
    if (poll(&stream, 1, 0) == 1 && (stream.revents & POLLOUT) != 0) {
        write_stderr(text);
    }
}

}  // namespace foam::texgen
