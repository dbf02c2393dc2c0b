// SPDX-License-Identifier: Apache-2.0

#include "texgen/manifest/file_lock.h"

#include "core/files/file_io.h"
#include "tests/support/temporary_folder.h"

#include <gtest/gtest.h>
#include <sys/file.h>
#include <sys/syscall.h>
#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <cerrno>
#include <chrono>
#include <filesystem>
#include <string>
#include <thread>
#include <vector>

namespace {

std::atomic<int> interruptions = 0;  // number of calls of flock that are to fail with EINTR

}  // namespace

// Replaces the function of the C library. On a local file system, a signal does not interrupt an
// attempt that does not wait, so a test cannot use a signal.
extern "C" int flock(int file, int operation) noexcept {
    if (interruptions > 0) {
        --interruptions;
        errno = EINTR;
        return -1;
    }
    return static_cast<int>(syscall(SYS_flock, file, operation));
}

namespace foam::texgen {
namespace {

TEST(FileLock, OneThreadGoesOnAtATime) {
    const TemporaryFolder folder;
    const std::filesystem::path path = folder.path() / "a.lock";
    std::atomic<int> inside = 0;
    std::atomic<int> largest = 0;
    {
        std::vector<std::jthread> threads;
        for (int k = 0; k < 4; ++k) {
            threads.emplace_back([&] {
                for (int round = 0; round < 25; ++round) {
                    const FileLock lock(path);
                    largest = std::max(largest.load(), ++inside);
                    std::this_thread::yield();
                    --inside;
                }
            });
        }
    }
    EXPECT_EQ(largest, 1);
    EXPECT_FALSE(std::filesystem::exists(path));
}

TEST(FileLock, ALockThatIsNeverReleasedIsAnOutputError) {
    const TemporaryFolder folder;
    const std::filesystem::path path = folder.path() / "a.lock";
    const FileLock held(path);
    try {
        const FileLock lock(path, std::chrono::milliseconds(20));
        ADD_FAILURE() << "got the lock";
    } catch (const OutputError& error) {
        EXPECT_EQ(std::string(error.what()),
                  "another program has locked '" + path.string() +
                      "' for 0 seconds; end that program, and repeat the command");
    }
    EXPECT_TRUE(std::filesystem::exists(path));
}

TEST(FileLock, AnInterruptedAttemptIsRepeated) {
    const TemporaryFolder folder;
    const std::filesystem::path path = folder.path() / "a.lock";
    {
        const FileLock held(path);
        interruptions = 1;
        EXPECT_THROW(FileLock(path, std::chrono::milliseconds(20)), OutputError);
    }
    interruptions = 1;
    EXPECT_NO_THROW(FileLock(path, std::chrono::seconds(10)));
    EXPECT_EQ(interruptions, 0);
}

TEST(FileLock, AFolderThatIsMissingIsAnOutputError) {
    const TemporaryFolder folder;
    EXPECT_THROW(FileLock(folder.path() / "none" / "a.lock"), OutputError);
}

}  // namespace
}  // namespace foam::texgen
