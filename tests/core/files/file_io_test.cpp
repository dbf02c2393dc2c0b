// SPDX-License-Identifier: Apache-2.0

#include "core/files/file_io.h"

#include "tests/support/temporary_folder.h"

#include <gtest/gtest.h>
#include <linux/filter.h>
#include <linux/seccomp.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <sys/syscall.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <csignal>
#include <cstddef>
#include <filesystem>
#include <string>
#include <utility>
#include <vector>

namespace {

int synced_files = 0;     // number of calls of fsync
int next_sync_error = 0;  // error of the next call of fsync, 0 for success

}  // namespace

// Replaces the function of the C library, because a test cannot cut the power.
extern "C" int fsync(int file) {
    ++synced_files;
    if (next_sync_error != 0) {
        errno = std::exchange(next_sync_error, 0);
        return -1;
    }
    return static_cast<int>(syscall(SYS_fsync, file));
}

namespace foam {
namespace {

/// Limits the size of the files that this process writes, in order to simulate a full disk.
class FileSizeLimit {
  public:
    explicit FileSizeLimit(rlim_t bytes) : handler_(std::signal(SIGXFSZ, SIG_IGN)) {
        getrlimit(RLIMIT_FSIZE, &before_);
        const rlimit limit{bytes, before_.rlim_max};
        setrlimit(RLIMIT_FSIZE, &limit);
    }
    ~FileSizeLimit() {
        setrlimit(RLIMIT_FSIZE, &before_);
        std::signal(SIGXFSZ, handler_);
    }
    FileSizeLimit(const FileSizeLimit&) = delete;
    FileSizeLimit& operator=(const FileSizeLimit&) = delete;

  private:
    void (*handler_)(int);
    rlimit before_{};
};

std::string failure_to_write(const std::filesystem::path& path, std::size_t size) {
    try {
        write_file(path, Bytes(size));
    } catch (const OutputError& error) {
        return error.what();
    }
    return "no failure";
}

TEST(FileIo, ReachesTheDiskBeforeItGetsItsNameIfRequested) {
    const TemporaryFolder folder;
    const Bytes content(10, std::byte{42});
    synced_files = 0;
    write_file(folder.path() / "later.bin", content);
    EXPECT_EQ(synced_files, 0);
    write_file(folder.path() / "named.bin", content, Durability::BeforeNaming);
    EXPECT_EQ(synced_files, 1);
}

TEST(FileIo, KeepsTheOldFileIfTheNewOneDoesNotReachTheDisk) {
    const TemporaryFolder folder;
    const std::filesystem::path path = folder.path() / "a.bin";
    const Bytes old(10, std::byte{42});
    write_file(path, old);
    next_sync_error = EIO;
    EXPECT_THROW(write_file(path, Bytes(20), Durability::BeforeNaming), OutputError);
    EXPECT_EQ(read_file(path, kImageInput), old);
    EXPECT_EQ(folder.files().size(), 1);
}

TEST(FileIo, RoundTrips) {
    const TemporaryFolder folder;
    const Bytes content(100'000, std::byte{42});
    write_file(folder.path() / "a.bin", content);
    EXPECT_EQ(read_file(folder.path() / "a.bin", kImageInput), content);
    EXPECT_EQ(folder.files(), std::vector<std::string>{"a.bin"});
}

TEST(FileIo, ReplacesAnOlderFile) {
    const TemporaryFolder folder;
    write_file(folder.path() / "a.bin", Bytes(10));
    write_file(folder.path() / "a.bin", Bytes(3));
    EXPECT_EQ(read_file(folder.path() / "a.bin", kImageInput).size(), 3U);
}

TEST(FileIo, AMissingFolderIsNamed) {
    const TemporaryFolder folder;
    const auto path = folder.path() / "none" / "a.bin";
    EXPECT_EQ(failure_to_write(path, 1),
              "cannot write '" + path.string() + "': No such file or directory");
}

// Short contents stay in the buffer of the stream until it is closed, so closing it fails. Long
// contents fail in the write itself.
TEST(FileIo, AFullDiskLeavesNeitherFileNorTemporary) {
    for (const std::size_t size : {std::size_t{2000}, std::size_t{1} << 20}) {
        const TemporaryFolder folder;
        const auto path = folder.path() / "a.bin";
        std::string failure;
        {
            const FileSizeLimit limit(1000);
            failure = failure_to_write(path, size);
        }
        EXPECT_EQ(failure, "cannot write '" + path.string() + "': File too large");
        EXPECT_TRUE(folder.files().empty()) << size;
    }
}

// From now on, the system call close fails in this process, as on a network file system that could
// not store a file. Returns false if the system does not support this.
bool let_close_fail() {
    std::array<sock_filter, 4> program{
        {{BPF_LD | BPF_W | BPF_ABS, 0, 0, offsetof(seccomp_data, nr)},
         {BPF_JMP | BPF_JEQ | BPF_K, 0, 1, SYS_close},
         {BPF_RET | BPF_K, 0, 0, SECCOMP_RET_ERRNO | EDQUOT},
         {BPF_RET | BPF_K, 0, 0, SECCOMP_RET_ALLOW}}};
    const sock_fprog filter{program.size(), program.data()};
    return prctl(PR_SET_NO_NEW_PRIVS, 1, 0, 0, 0) == 0 &&
           prctl(PR_SET_SECCOMP, SECCOMP_MODE_FILTER, &filter) == 0;
}

// The file gets its name before it is closed.
TEST(FileIo, AFailureToCloseLeavesNoFile) {
    constexpr int kFailed = 3;
    constexpr int kUnsupported = 4;
    const TemporaryFolder folder;
    const auto path = folder.path() / "a.bin";
    const std::string expected = "cannot write '" + path.string() + "': Disk quota exceeded";
    const pid_t child = fork();
    if (child == 0) {
        _exit(!let_close_fail()                        ? kUnsupported
              : failure_to_write(path, 10) == expected ? kFailed
                                                       : 0);
    }
    int status = 0;
    ASSERT_EQ(waitpid(child, &status, 0), child);
    ASSERT_TRUE(WIFEXITED(status));
    if (WEXITSTATUS(status) == kUnsupported) {
        GTEST_SKIP() << "the system does not filter system calls";
    }
    EXPECT_EQ(WEXITSTATUS(status), kFailed);
    EXPECT_TRUE(folder.files().empty());
}

TEST(FileIo, AFolderInTheWayLeavesNoTemporary) {
    const TemporaryFolder folder;
    const auto path = folder.path() / "a.bin";
    std::filesystem::create_directory(path);
    EXPECT_EQ(failure_to_write(path, 1), "cannot write '" + path.string() + "': Is a directory");
    EXPECT_TRUE(folder.files().empty());
}

TEST(FileIo, AFailureKeepsTheOlderFile) {
    const TemporaryFolder folder;
    const auto path = folder.path() / "a.bin";
    write_file(path, Bytes(10));
    {
        const FileSizeLimit limit(1000);
        failure_to_write(path, 2000);
    }
    EXPECT_EQ(read_file(path, kImageInput), Bytes(10));
}

TEST(FileIo, FoldersAreMadeAsFarAsTheyAreMissing) {
    const TemporaryFolder folder;
    make_folders(folder.path() / "a" / "b");
    make_folders(folder.path() / "a" / "b");
    make_folders("");
    EXPECT_TRUE(std::filesystem::is_directory(folder.path() / "a" / "b"));
    write_file(folder.path() / "file", Bytes(1));
    EXPECT_THROW(make_folders(folder.path() / "file" / "b"), OutputError);
}

std::string failure_to_read(const std::filesystem::path& path, const InputKind& kind) {
    try {
        read_file(path, kind);
    } catch (const InputError& error) {
        return error.what();
    }
    return "no failure";
}

TEST(FileIo, FilesAreReadUpToALimit) {
    const TemporaryFolder folder;
    const auto path = folder.path() / "sparse";
    write_file(path, Bytes(1));
    std::filesystem::resize_file(path, kMebibyte);
    EXPECT_EQ(read_file(path, {"a test", kMebibyte}).size(), kMebibyte);
    std::filesystem::resize_file(path, std::uintmax_t{10} << 30U);
    EXPECT_EQ(failure_to_read(path, {"a test", kMebibyte}),
              "cannot read '" + path.string() +
                  "': the file is too large: a test may have at most 1 MiB");
}

TEST(FileIo, OnlyRegularFilesAreRead) {
    const TemporaryFolder folder;
    const auto pipe = folder.path() / "pipe";
    ASSERT_EQ(mkfifo(pipe.c_str(), 0600), 0);
    for (const std::filesystem::path& path : {pipe, std::filesystem::path("/dev/zero")}) {
        EXPECT_EQ(failure_to_read(path, kPresetInput),
                  "cannot read '" + path.string() +
                      "': must be a regular file, not a pipe, a socket or a device");
    }
}

TEST(FileIo, AStagedFileHasNoNameBeforeItIsPublished) {
    const TemporaryFolder folder;
    const auto path = folder.path() / "a.bin";
    { const StagedFile file(path, Bytes(10)); }
    EXPECT_TRUE(folder.files().empty());
    StagedFile file(path, Bytes(10), Durability::BeforeNaming);
    EXPECT_FALSE(std::filesystem::exists(path));
    write_file(path, Bytes(3));
    file.publish();
    EXPECT_EQ(read_file(path, kImageInput).size(), 10U);
    EXPECT_EQ(folder.files(), std::vector<std::string>{"a.bin"});
}

TEST(FileIo, PlainNamesCannotLeaveAFolder) {
    for (const char* name : {"a", "sea_foam", "a b.c", "größe"}) {
        EXPECT_TRUE(is_plain_name(name)) << name;
    }
    for (const char* name : {"", ".", "..", ".a", "a/b", "/a", "a\nb", "a\033[0m", "\xFF"}) {
        EXPECT_FALSE(is_plain_name(name)) << name;
    }
    EXPECT_FALSE(is_plain_name(std::string(201, 'a')));
}

// The system cannot tell whether such a folder exists.
TEST(FileIo, FoldersThatCannotBeReachedAreOutputErrors) {
    const TemporaryFolder folder;
    std::filesystem::create_symlink("loop", folder.path() / "loop");
    EXPECT_THROW(check_writable(folder.path() / "loop"), OutputError);
    EXPECT_THROW(check_writable(folder.path() / "loop" / "a"), OutputError);
    EXPECT_THROW(check_writable(folder.path() / std::string(5000, 'a')), OutputError);
    EXPECT_NO_THROW(check_writable(folder.path() / "a" / "b"));
}

TEST(FileIo, CheckingAFolderLeavesNothingBehind) {
    const TemporaryFolder folder;
    check_writable(folder.path() / "a" / "b");
    EXPECT_TRUE(std::filesystem::is_empty(folder.path()));
}

// The permissions of /proc allow the administrator to write, but nobody can create a file there.
TEST(FileIo, AFolderMustTakeFilesAndNotOnlyAllowThem) {
    EXPECT_THROW(check_writable("/proc"), OutputError);
    EXPECT_THROW(check_writable("/proc/none/below"), OutputError);
}

TEST(FileIo, ReadingNamesFileAndReason) {
    const TemporaryFolder folder;
    EXPECT_THROW(read_file(folder.path() / "none", kImageInput), InputError);
    EXPECT_THROW(read_file(folder.path(), kImageInput),
                 InputError);  // a folder can be opened but not read
}

}  // namespace
}  // namespace foam
