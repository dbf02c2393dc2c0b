// SPDX-License-Identifier: Apache-2.0

#include "texgen/cli/watch.h"

#include "core/files/file_io.h"
#include "texgen/cli/failure.h"
#include "texgen/cli/interruption.h"
#include "texgen/cli/standard_error.h"
#include "texgen/manifest/existing_frames.h"
#include "texgen/preset/load_preset.h"
#include "texgen/preset/preset_files.h"

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <exception>
#include <system_error>
#include <thread>
#include <utility>

// Files are polled: a few calls of stat() ten times per second are cheap compared with a run, and
// polling works on every system. It also works on network disks, where inotify does not report the
// changes that other machines make.

namespace foam::texgen {

namespace {

constexpr std::chrono::milliseconds kPollPeriod{100};
// The number of polls without a change after which a change counts as complete.
constexpr int kQuietPolls = 2;

void wait_for_change(WatchedFiles& files) {
    bool has_changed = false;
    for (int quiet_polls = 0; !has_changed || quiet_polls < kQuietPolls;) {
        std::this_thread::sleep_for(kPollPeriod);
        throw_if_interrupted();
        const bool changes = files.have_changed();
        has_changed = has_changed || changes;
        quiet_polls = changes ? 0 : quiet_polls + 1;
    }
}

/// Returns the paths of the files that exist, separated by commas.
std::string names_of(const std::vector<std::filesystem::path>& paths) {
    std::vector<std::string> names;
    for (const std::filesystem::path& path : paths) {
        std::error_code error;
        if (std::filesystem::exists(path, error)) {
            names.push_back(path.string());
        }
    }
    return fmt::format("{}", fmt::join(names, ", "));
}

}  // namespace

WatchedFiles::WatchedFiles(std::vector<std::filesystem::path> files) {
    for (std::filesystem::path& file : files) {
        states_.push_back(state_of({.path = std::move(file)}));
    }
}

WatchedFiles::State WatchedFiles::state_of(const State& before) {
    State state{.path = before.path};
    std::error_code error;
    state.time = std::filesystem::last_write_time(state.path, error);
    state.size = error ? 0 : std::filesystem::file_size(state.path, error);
    if (error) {
        return {.path = before.path};
    }
    if (state.time == before.time && state.size == before.size) {
        return before;
    }
    try {
        state.hash = file_hash(state.path);
    } catch (const InputError&) {
        return {.path = before.path};
    }
    return state;
}

bool WatchedFiles::have_changed() {
    bool changed = false;
    for (State& state : states_) {
        State now = state_of(state);
        changed = changed || now.hash != state.hash;
        state = std::move(now);
    }
    return changed;
}

void add_watch_option(CLI::App& command, bool& watch) {
    command
        .add_flag(
            "--watch", watch, "Run again when the preset, or a file it names, changes; Ctrl-C ends")
        ->excludes(command.get_option("--json"))
        ->option_text(" ");
}

std::vector<std::filesystem::path> watched_files(const RunArguments& arguments) {
    std::vector<std::filesystem::path> files =
        preset_files(arguments.preset, assignments_of(arguments));
    if (arguments.profile && is_preset_path(*arguments.profile)) {
        files.emplace_back(*arguments.profile);
    }
    return files;
}

void run_watching(const RunArguments& arguments, const std::function<void()>& run) {
    if (watched_files(arguments).empty()) {
        throw PresetError(fmt::format(
            "--watch: '{0}' has no file that could change; 'foamtex presets show {0} > my.toml' "
            "makes one",
            arguments.preset));
    }
    handle_stop_signals();
    for (;;) {
        const std::vector<std::filesystem::path> paths = watched_files(arguments);
        WatchedFiles files(paths);
        try {
            run();
        } catch (const Interrupted&) {
            throw;
        } catch (const std::exception&) {
            report_exception();
        }
        if (!arguments.quiet) {
            print_stderr("foamtex: watching {}; Ctrl-C ends", names_of(paths));
        }
        wait_for_change(files);
    }
}

}  // namespace foam::texgen
