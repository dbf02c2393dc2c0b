#pragma once

#include <filesystem>

namespace foam::texgen {

/// Keeps other programs, and other threads, out for as long as it lives: of all that lock the same
/// path one goes on at a time. The file is there only for that while. Where the file system has no
/// locks, nobody is kept out. Throws OutputError where the file cannot be made.
class FileLock {
  public:
    explicit FileLock(std::filesystem::path path);
    ~FileLock();

    FileLock(const FileLock&) = delete;
    FileLock& operator=(const FileLock&) = delete;

  private:
    bool try_lock();

    std::filesystem::path path_;
    int file_ = -1;
};

}  // namespace foam::texgen
