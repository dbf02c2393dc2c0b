// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "core/files/shown_text.h"

#include <fmt/core.h>
#include <unistd.h>

#include <cstdio>
#include <string>
#include <string_view>
#include <utility>

namespace foam::texgen {

// Results are written to stdout only through these functions. The help and the version are no
// results: CLI11 prints them. The functions do not throw if stdout is closed or full. Instead,
// run_program checks at the end whether all output was written.

/// Writes a text to stdout. If stdout is a terminal, characters that could control it, for example
/// in the names of files, are replaced (shown_lines).
inline void write_stdout(std::string_view text) {
    std::string shown;
    if (isatty(STDOUT_FILENO) == 1) {
        shown = shown_lines(text);
        text = shown;
    }
    std::fwrite(text.data(), 1, text.size(), stdout);
}

/// Formats a text and writes it to stdout.
template <class... Arguments>
void print_stdout(fmt::format_string<Arguments...> format, Arguments&&... arguments) {
    write_stdout(fmt::format(format, std::forward<Arguments>(arguments)...));
}

/// Flushes stdout. Returns false if output was lost, now or before, for example on a full disk.
inline bool flush_stdout() {
    return std::fflush(stdout) == 0 && std::ferror(stdout) == 0;
}

}  // namespace foam::texgen
