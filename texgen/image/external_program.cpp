// SPDX-License-Identifier: Apache-2.0

#include "texgen/image/external_program.h"

#include "core/files/file_io.h"

#include <fcntl.h>
#include <fmt/core.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <filesystem>
#include <string_view>
#include <system_error>

namespace foam::texgen {

namespace {

constexpr mode_t kErrorFileMode = 0666;  // reduced by the umask of the process

/// Sets the standard streams and the working directory of a new process.
class SpawnActions {
  public:
    explicit SpawnActions(const ExternalOptions& options) {
        posix_spawn_file_actions_init(&actions_);
        posix_spawn_file_actions_addopen(&actions_, STDIN_FILENO, "/dev/null", O_RDONLY, 0);
        posix_spawn_file_actions_addopen(&actions_, STDOUT_FILENO, "/dev/null", O_WRONLY, 0);
        if (!options.error_file.empty()) {
            posix_spawn_file_actions_addopen(&actions_,
                                             STDERR_FILENO,
                                             options.error_file.c_str(),
                                             O_WRONLY | O_CREAT | O_TRUNC,
                                             kErrorFileMode);
        } else if (!options.shows_errors) {
            posix_spawn_file_actions_addopen(&actions_, STDERR_FILENO, "/dev/null", O_WRONLY, 0);
        }
        if (!options.folder.empty()) {
            posix_spawn_file_actions_addchdir_np(&actions_, options.folder.c_str());
        }
    }
    ~SpawnActions() { posix_spawn_file_actions_destroy(&actions_); }
    SpawnActions(const SpawnActions&) = delete;
    SpawnActions& operator=(const SpawnActions&) = delete;

    const posix_spawn_file_actions_t* get() const { return &actions_; }

  private:
    posix_spawn_file_actions_t actions_{};
};

[[noreturn]] void fail(std::string_view action, const std::string& program, int error) {
    throw OutputError(fmt::format(
        "cannot {} the program '{}': {}", action, program, std::generic_category().message(error)));
}

/// Returns true if a working directory is given but does not exist.
bool is_missing(const std::filesystem::path& folder) {
    std::error_code ignored;
    return !folder.empty() && !std::filesystem::exists(folder, ignored);
}

/// Waits until a process ends. Returns its exit code, or -1 if a signal ended it.
int wait_for(const std::string& program, pid_t child) {
    int status = 0;
    while (waitpid(child, &status, 0) < 0) {
        if (errno != EINTR) {
            fail("wait for", program, errno);
        }
    }
    return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
}

}  // namespace

std::optional<int> run_external(std::vector<std::string> arguments,
                                const ExternalOptions& options) {
    const std::string program = arguments.front();
    std::vector<char*> pointers;
    pointers.reserve(arguments.size() + 1);
    for (std::string& argument : arguments) {
        pointers.push_back(argument.data());
    }
    pointers.push_back(nullptr);
    const SpawnActions actions(options);
    pid_t child = 0;
    const int error =
        posix_spawnp(&child, program.c_str(), actions.get(), nullptr, pointers.data(), environ);
    // ENOENT means that the program, its working directory or the folder of options.error_file does
    // not exist.
    if (error == ENOENT && is_missing(options.folder)) {
        throw OutputError(
            fmt::format("cannot start the program '{}': its working directory '{}' does not exist",
                        program,
                        options.folder.string()));
    }
    if (error == ENOENT) {
        return std::nullopt;
    }
    if (error != 0) {
        fail("start", program, error);
    }
    return wait_for(program, child);
}

}  // namespace foam::texgen
