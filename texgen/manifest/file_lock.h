// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <filesystem>

namespace foam::texgen {

/// A lock file for mutual exclusion between programs and between threads. At any time only one
/// FileLock of a path exists. The file exists only while it is locked. On a file system without
/// flock there is no mutual exclusion.
class FileLock {
  public:
    /// Waits for the lock. Throws OutputError if the file cannot be created.
    explicit FileLock(std::filesystem::path path);
    ~FileLock();

    FileLock(const FileLock&) = delete;
    FileLock& operator=(const FileLock&) = delete;

  private:
    // Opens and locks the file. Returns false if the previous owner removed it meanwhile.
    bool try_lock();

    std::filesystem::path path_;
    int file_ = -1;
};

}  // namespace foam::texgen
