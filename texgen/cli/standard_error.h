// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "core/files/shown_text.h"

#include <fmt/core.h>

#include <string_view>
#include <utility>

namespace foam::texgen {

// Messages and progress are written to stderr only through these functions; the signal handler in
// interruption.cpp is the only exception. None of the functions fails: if stderr is closed, full or
// a pipe without a reader, the text is lost and the program goes on. The exit code therefore never
// depends on stderr.

/// Opens /dev/null for each standard stream that is closed. Without this, a file that is opened
/// later could get the descriptor of the stream and receive messages. /dev/null is opened only for
/// writing as stdin, and only for reading as stdout or stderr. Reading from this stdin and writing
/// to this stdout or stderr therefore fail, as with a closed stream. Must be called before any file
/// is opened.
void open_missing_streams();

/// Writes a text to stderr.
void write_stderr(std::string_view text) noexcept;

/// Writes a text to stderr, or drops it if writing would block, because the buffer of a pipe is
/// full or a terminal is stopped. Precondition: the text has fewer than 4096 bytes (PIPE_BUF),
/// which any pipe that is ready for writing can store.
void write_stderr_without_waiting(std::string_view text) noexcept;

/// Formats a message and writes it to stderr as one line that a terminal shows without interpreting
/// any character (shown_text).
template <class... Arguments>
void print_stderr(fmt::format_string<Arguments...> format, Arguments&&... arguments) {
    write_stderr(shown_text(fmt::format(format, std::forward<Arguments>(arguments)...)) + "\n");
}

}  // namespace foam::texgen
