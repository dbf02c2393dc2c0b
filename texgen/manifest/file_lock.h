// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <chrono>
#include <filesystem>

namespace foam::texgen {

/// A lock file for mutual exclusion between programs and between threads. At any time, at most one
/// FileLock holds the lock of a path. The destructor removes the file and releases the lock. On a
/// file system without flock there is no mutual exclusion.
class FileLock {
  public:
    /// The longest time to wait for a lock, by default. Programs hold a lock only while they read,
    /// change and write a manifest.
    static constexpr std::chrono::milliseconds kMaxWait = std::chrono::minutes(1);

    /// Creates the lock file `path` if it does not exist, and waits until this object holds the
    /// lock. Throws OutputError if the file cannot be created, or if this object does not get the
    /// lock within the time `patience`.
    explicit FileLock(std::filesystem::path path, std::chrono::milliseconds patience = kMaxWait);
    ~FileLock();

    FileLock(const FileLock&) = delete;
    FileLock& operator=(const FileLock&) = delete;

  private:
    // Opens and locks the file. Returns false if another owner holds the lock, if the previous
    // owner has removed the file meanwhile, or if a signal interrupts the attempt.
    bool try_lock();

    std::filesystem::path path_;
    int file_ = -1;  // descriptor of the locked file
};

}  // namespace foam::texgen
