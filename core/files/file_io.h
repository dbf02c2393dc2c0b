// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "core/files/input_limits.h"

#include <cstddef>
#include <filesystem>
#include <span>
#include <stdexcept>
#include <string_view>
#include <vector>

namespace foam {

/// Reports input that is unreadable or malformed. The message gives the reason. It also names the
/// file if the function that throws knows the path.
class InputError : public std::runtime_error {
    using runtime_error::runtime_error;
};

/// Reports output that could not be produced, for example a file that cannot be written or a
/// program that cannot be started. The message gives the reason. It also names the file, if there
/// is one and the function that throws knows the path.
class OutputError : public std::runtime_error {
    using runtime_error::runtime_error;
};

using Bytes = std::vector<std::byte>;

inline void append(Bytes& to, std::span<const std::byte> bytes) {
    to.insert(to.end(), bytes.begin(), bytes.end());
}

/// Throws InputError with a message that names the file and the reason.
[[noreturn]] void fail_to_read(const std::filesystem::path& path, const std::string& why);

/// Returns the whole content of a file. Throws InputError if the file cannot be read or is larger
/// than `kind` allows. Also throws InputError if the path leads not to a regular file but, for
/// example, to a folder or a pipe.
Bytes read_file(const std::filesystem::path& path, const InputKind& kind);

/// Returns true if the name can be a part of a file name. Such a name is not empty, has at most 200
/// bytes and is harmless (is_harmless in shown_text.h). It contains no '/' and does not begin with
/// '.'. A name that is read from an untrusted file must pass this test before it becomes a part of
/// a path.
bool is_plain_name(std::string_view name);

/// Selects when the content of a file reaches the disk.
enum class Durability {
    /// The system selects the time. After a power failure, the file may be empty or damaged.
    Later,
    /// The content reaches the disk before the file gets its name. After a power failure, the name
    /// refers to the complete file or to the file that had the name before.
    BeforeNaming,
};

/// A file whose content is written before it gets its name, so that no reader sees a partial file.
/// On a file system that supports files without names, the file has no name before `publish`, and
/// the system removes it if the program is killed. On other file systems, the file is in the folder
/// of the target under a temporary name such as NAME.foamtex-123-4.part. It stays there if the
/// program is killed (remove_abandoned_files). The destructor removes the file if it has not been
/// published.
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

    /// Gives the file its name. Replaces an existing file. Throws OutputError if this fails. May be
    /// called only once.
    void publish();

  private:
    void open();
    void write(std::span<const std::byte> content);
    bool link_as(const std::filesystem::path& path) const;
    void close();
    [[noreturn]] void fail(int error) const;

    std::filesystem::path target_;
    std::filesystem::path name_;  // empty if the file has no name or has been published
    int file_ = -1;               // file descriptor, or -1
};

/// Writes a file atomically: stages and publishes it (StagedFile). Precondition: the folder of
/// `path` exists. Throws OutputError if writing fails; an existing file of this name then stays
/// unchanged.
void write_file(const std::filesystem::path& path,
                std::span<const std::byte> content,
                Durability durability = Durability::Later);

/// Returns true if a file or folder exists. Throws OutputError if the system cannot tell, for
/// example because the path is too long.
bool is_existing(const std::filesystem::path& path);

/// Returns the absolute path of a folder if it exists, otherwise the path of the nearest existing
/// folder or file above it. An empty path means the working directory. Throws OutputError if the
/// system cannot tell whether a path exists, or what the working directory is.
std::filesystem::path nearest_existing(const std::filesystem::path& folder);

/// Throws OutputError if files cannot be written into a folder, or if a missing folder cannot be
/// created, for example because its path is too long. A long computation can call this function
/// first. As a test, the function creates an empty folder with a temporary name inside `folder`,
/// and removes this empty folder again. If `folder` does not exist, the test is made inside the
/// nearest existing folder above it. The function never creates `folder` itself. An empty path
/// means the working directory.
void check_writable(const std::filesystem::path& folder);

/// Creates a folder and its parent folders if they do not exist. Does nothing for an empty path,
/// which means the working directory. Throws OutputError if a folder cannot be created.
void make_folders(const std::filesystem::path& folder);

}  // namespace foam
