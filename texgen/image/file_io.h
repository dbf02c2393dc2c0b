// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "texgen/image/input_limits.h"

#include <cstddef>
#include <filesystem>
#include <span>
#include <stdexcept>
#include <string_view>
#include <vector>

namespace foam::texgen {

/// Reports input that is unreadable or malformed. The message gives the reason. It also names the
/// file if the function that throws has its path.
class InputError : public std::runtime_error {
    using runtime_error::runtime_error;
};

/// Reports output that could not be produced, for example a file that cannot be written or a
/// program that cannot be started. The message gives the reason. It also names the file, if there
/// is one and the function that throws has its path.
class OutputError : public std::runtime_error {
    using runtime_error::runtime_error;
};

using Bytes = std::vector<std::byte>;

/// Returns the whole content of a file. Throws InputError if the file cannot be read, if it is not
/// a regular file, such as a folder, a pipe or a device, or if it is larger than files of its kind
/// may be.
Bytes read_file(const std::filesystem::path& path, const InputKind& kind = kImageInput);

/// Returns true if the name can be a part of a file name: it is not empty, at most 200 bytes long,
/// harmless (shown_text.h), and has no '/' and no leading '.'. Names in files from an untrusted
/// source must be plain before they become parts of paths.
bool is_plain_name(std::string_view name);

/// When the content of a file reaches the disk.
enum class Durability {
    /// When the system chooses. After a power failure, the file may be empty or damaged.
    Later,
    /// Before the file gets its name. After a power failure, the file is complete, or it is the
    /// file that had the name before.
    BeforeNaming,
};

/// A file that is written but does not have its name yet, so that no reader sees a partial file. If
/// the file system supports it, the file has no name at all until then, and the system removes it
/// if the program is killed. Otherwise it has a temporary name in the same folder, which ends in
/// ".part"; the destructor removes it.
class StagedFile {
  public:
    /// Writes the content. Precondition: the folder of `target` exists. Throws OutputError if
    /// writing fails.
    StagedFile(std::filesystem::path target,
               std::span<const std::byte> content,
               Durability durability = Durability::Later);
    StagedFile(StagedFile&& other) noexcept;
    StagedFile& operator=(StagedFile&&) = delete;
    StagedFile(const StagedFile&) = delete;
    StagedFile& operator=(const StagedFile&) = delete;
    ~StagedFile();

    /// Gives the file its name. Replaces an existing file. Throws OutputError if this fails.
    void publish();

  private:
    void open();
    void write(std::span<const std::byte> content);
    bool link_as(const std::filesystem::path& path) const;
    void close();
    [[noreturn]] void fail(int error) const;

    std::filesystem::path target_;
    std::filesystem::path temporary_;  // empty if the file has no name
    int file_ = -1;                    // file descriptor, or -1
};

/// Writes a file atomically: stages and publishes it. Precondition: the folder exists. Throws
/// OutputError if writing fails; then there is no new file.
void write_file(const std::filesystem::path& path,
                std::span<const std::byte> content,
                Durability durability = Durability::Later);

/// Returns true if a file or folder exists. Throws OutputError if the system cannot tell, for
/// example because the path is too long.
bool is_existing(const std::filesystem::path& path);

/// Returns a folder itself as an absolute path or, if it does not exist, the nearest existing
/// folder or file above it. An empty path means the working directory. Throws OutputError if the
/// system cannot tell.
std::filesystem::path nearest_existing(const std::filesystem::path& folder);

/// Throws OutputError if files cannot be written into a folder, or if the folder does not exist and
/// cannot be created, for example because its path is too long. Creates nothing, so that a long
/// computation can check its output first. An empty path means the working directory.
void check_writable(const std::filesystem::path& folder);

/// Creates a folder and its parent folders if they do not exist. Does nothing for an empty path,
/// which means the working directory. Throws OutputError if a folder cannot be created.
void make_folders(const std::filesystem::path& folder);

}  // namespace foam::texgen
