// SPDX-License-Identifier: Apache-2.0

#include "texgen/image/file_io.h"

#include "tests/texgen/temporary_folder.h"

#include <gtest/gtest.h>
#include <sys/resource.h>

#include <csignal>
#include <filesystem>
#include <string>

namespace foam::texgen {
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

TEST(FileIo, RoundTrips) {
    const TemporaryFolder folder;
    const Bytes content(100'000, std::byte{42});
    write_file(folder.path() / "a.bin", content);
    EXPECT_EQ(read_file(folder.path() / "a.bin"), content);
    EXPECT_EQ(folder.files(), std::vector<std::string>{"a.bin"});
}

TEST(FileIo, ReplacesAnOlderFile) {
    const TemporaryFolder folder;
    write_file(folder.path() / "a.bin", Bytes(10));
    write_file(folder.path() / "a.bin", Bytes(3));
    EXPECT_EQ(read_file(folder.path() / "a.bin").size(), 3U);
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
    EXPECT_EQ(read_file(path), Bytes(10));
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

TEST(FileIo, ReadingNamesFileAndReason) {
    const TemporaryFolder folder;
    EXPECT_THROW(read_file(folder.path() / "none"), InputError);
    EXPECT_THROW(read_file(folder.path()), InputError);  // a folder can be opened but not read
}

}  // namespace
}  // namespace foam::texgen
