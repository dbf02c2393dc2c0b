// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "texgen/cli/exit_code.h"
#include "texgen/cli/run_arguments.h"

#include <cstdint>
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

namespace foam::texgen {

/// The contents of files, to detect changes. If a file becomes missing or unreadable, or becomes
/// readable again, this is a change, too.
class WatchedFiles {
  public:
    /// Remembers the present contents.
    explicit WatchedFiles(std::vector<std::filesystem::path> files);

    /// Returns true if the content of a file differs from the content at the last call, or at the
    /// construction. Reads a file only if its time of modification or its size has changed.
    bool have_changed();

  private:
    struct State {
        std::filesystem::path path;
        std::filesystem::file_time_type time{};
        std::uintmax_t size = 0;
        std::string hash{};  // file_hash; empty if the file cannot be read
    };
    static State state_of(const State& before);

    std::vector<State> states_;
};

/// Adds the option --watch, which cannot be combined with --json. `watch` must outlive the parsing
/// of the command line. Precondition: the command has the option --json.
void add_watch_option(CLI::App& command, bool& watch);

/// Returns the files on which the run of a command with these arguments depends: those of the
/// preset (preset_files) and the profile, if it is a file. Throws PresetError if a `--set` is
/// malformed.
std::vector<std::filesystem::path> watched_files(const RunArguments& arguments);

/// Calls `run`, and calls it again after each change of a file on which it depends (watched_files).
/// Editors write a file in several steps, so `run` is called again only when no file has changed
/// for 0.2 s. Reports an exception of `run` as one line (report_exception) and goes on watching.
/// Never returns: throws Interrupted after a signal, and PresetError if there is no file to watch
/// or if a `--set` is malformed.
[[noreturn]] void run_watching(const RunArguments& arguments, const std::function<void()>& run);

}  // namespace foam::texgen
