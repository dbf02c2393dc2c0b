// SPDX-License-Identifier: Apache-2.0

#include "texgen/manifest/file_lock.h"

#include "core/files/file_io.h"

#include <fcntl.h>
#include <fmt/core.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <chrono>
#include <system_error>
#include <thread>
#include <utility>

// The lock is an exclusive flock on a file. The owner of the lock removes the file before it
// releases the lock. A second program may have opened the file before its removal. This program may
// then lock the removed file, while a third program locks a new file at the same path. For this
// reason, a lock is valid only if the file at the path is still the locked file. Otherwise the
// attempt is repeated.

namespace foam::texgen {

namespace {

constexpr mode_t kMode = 0666;  // permissions of the file, reduced by the umask of the process

/// Returns true if the open file is still the file at the path. `file` is a file descriptor.
bool is_file_at(int file, const std::filesystem::path& path) {
    struct stat held {};
    struct stat found {};
    return fstat(file, &held) == 0 && stat(path.c_str(), &found) == 0 &&
           held.st_ino == found.st_ino && held.st_dev == found.st_dev;
}

constexpr std::chrono::milliseconds kPause{5};  // pause between two attempts to lock the file

// Locks a file; `file` is a file descriptor. Returns false if another owner holds the lock, or if a
// signal interrupts the call, as it may on a network file system. Returns true without a lock if
// flock fails for another reason, for example because the file system does not support it.
bool try_flock(int file) {
    return flock(file, LOCK_EX | LOCK_NB) == 0 || (errno != EWOULDBLOCK && errno != EINTR);
}

}  // namespace

FileLock::FileLock(std::filesystem::path path, std::chrono::milliseconds patience)
    : path_(std::move(path)) {
    const auto end = std::chrono::steady_clock::now() + patience;
    while (!try_lock()) {
        if (std::chrono::steady_clock::now() >= end) {
            throw OutputError(
                fmt::format("another program has locked '{}' for {} seconds; end that program, "
                            "and repeat the command",
                            path_.string(),
                            std::chrono::duration_cast<std::chrono::seconds>(patience).count()));
        }
        std::this_thread::sleep_for(kPause);
    }
}

FileLock::~FileLock() {
    unlink(path_.c_str());
    close(file_);
}

bool FileLock::try_lock() {
    file_ = open(path_.c_str(), O_RDWR | O_CREAT | O_CLOEXEC, kMode);
    if (file_ < 0) {
        throw OutputError(fmt::format(
            "cannot write '{}': {}", path_.string(), std::generic_category().message(errno)));
    }
    if (try_flock(file_) && is_file_at(file_, path_)) {
        return true;
    }
    close(file_);
    return false;
}

}  // namespace foam::texgen
