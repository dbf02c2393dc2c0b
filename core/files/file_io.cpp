// SPDX-License-Identifier: Apache-2.0

#include "core/files/file_io.h"

#include "core/files/shown_text.h"

#include <fcntl.h>
#include <fmt/core.h>
#include <sys/stat.h>
#include <unistd.h>

#include <atomic>
#include <cerrno>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <string>
#include <system_error>
#include <utility>

namespace foam {

namespace {

// The number of bytes that one call of `read` requests.
constexpr std::size_t kReadBlock = 1 << 16;
// The largest length of a plain name, in bytes. File systems allow names of 255 bytes.
constexpr std::size_t kMaxPlainName = 200;

std::string reason(int error) {
    return std::generic_category().message(error);
}

/// An open file for reading.
class InputFile {
  public:
    // O_NONBLOCK: if the path is a pipe, open does not wait for a writer.
    explicit InputFile(const std::filesystem::path& path)
        : path_(path), file_(open(path.c_str(), O_RDONLY | O_NONBLOCK | O_CLOEXEC)) {
        if (file_ < 0) {
            fail_to_read(path_, reason(errno));
        }
    }
    ~InputFile() { close(file_); }
    InputFile(const InputFile&) = delete;
    InputFile& operator=(const InputFile&) = delete;

    /// Returns the size of the file. Throws InputError if it is not a regular file.
    std::uint64_t size() const {
        struct stat status {};
        if (fstat(file_, &status) != 0) {
            fail_to_read(path_, reason(errno));
        }
        if (S_ISDIR(status.st_mode)) {
            fail_to_read(path_, reason(EISDIR));
        }
        if (!S_ISREG(status.st_mode)) {
            fail_to_read(path_, "must be a regular file, not a pipe, a socket or a device");
        }
        return static_cast<std::uint64_t>(status.st_size);
    }

    /// Appends the next bytes to the content. Returns false at the end of the file.
    bool append_to(Bytes& content) const {
        const std::size_t old_size = content.size();
        content.resize(old_size + kReadBlock);
        ssize_t count = 0;
        do {
            count = read(file_, content.data() + old_size, kReadBlock);
        } while (count < 0 && errno == EINTR);
        if (count < 0) {
            fail_to_read(path_, reason(errno));
        }
        content.resize(old_size + static_cast<std::size_t>(count));
        return count > 0;
    }

  private:
    const std::filesystem::path& path_;
    int file_;
};

void check_size(const std::filesystem::path& path, std::uint64_t size, const InputKind& kind) {
    if (size > kind.max_bytes) {
        fail_to_read(path,
                     fmt::format("the file is too large: {} may have at most {} MiB",
                                 kind.name,
                                 kind.max_bytes / kMebibyte));
    }
}

// Returns a path in the folder of the target that no other thread or process of this machine uses.
// remove_abandoned_files recognizes such names.
std::filesystem::path unique_sibling(const std::filesystem::path& target) {
    static std::atomic<unsigned> count{0};
    std::filesystem::path sibling = target;
    sibling += fmt::format(".foamtex-{}-{}.part", getpid(), ++count);
    return sibling;
}

// Returns the path of a symbolic link to an open file. linkat follows this link to name a file that
// has no name yet.
std::string link_to(int file) {
    return fmt::format("/proc/self/fd/{}", file);
}

}  // namespace

void fail_to_read(const std::filesystem::path& path, const std::string& why) {
    throw InputError(fmt::format("cannot read '{}': {}", path.string(), why));
}

Bytes read_file(const std::filesystem::path& path, const InputKind& kind) {
    const InputFile file(path);
    const std::uint64_t size = file.size();
    check_size(path, size, kind);
    Bytes content;
    content.reserve(size + kReadBlock);
    while (file.append_to(content)) {
        check_size(path, content.size(), kind);  // the file may have grown
    }
    return content;
}

bool is_plain_name(std::string_view name) {
    return !name.empty() && name.size() <= kMaxPlainName && is_harmless(name) &&
           name.front() != '.' && name.find('/') == std::string_view::npos;
}

StagedFile::StagedFile(std::filesystem::path target,
                       std::span<const std::byte> content,
                       Durability durability)
    : target_(std::move(target)) {
    try {
        open();
        write(content);
        if (durability == Durability::BeforeNaming && fsync(file_) != 0) {
            fail(errno);
        }
    } catch (...) {
        close();
        throw;
    }
}

StagedFile::StagedFile(StagedFile&& other) noexcept
    : target_(std::move(other.target_)),
      name_(std::exchange(other.name_, {})),
      file_(std::exchange(other.file_, -1)) {}

StagedFile::~StagedFile() {
    close();
}

void StagedFile::open() {
    constexpr mode_t kMode = 0666;  // reduced by the umask of the process
    const std::filesystem::path folder = target_.has_parent_path() ? target_.parent_path() : ".";
    file_ = ::open(folder.c_str(), O_TMPFILE | O_WRONLY | O_CLOEXEC, kMode);
    if (file_ >= 0 && access(link_to(file_).c_str(), F_OK) == 0) {
        return;
    }
    close();
    std::filesystem::path temporary;
    do {  // a killed program with the same process identifier may have left a file of this name
        temporary = unique_sibling(target_);
        file_ = ::open(temporary.c_str(), O_CREAT | O_EXCL | O_WRONLY | O_CLOEXEC, kMode);
    } while (file_ < 0 && errno == EEXIST);
    if (file_ < 0) {
        fail(errno);
    }
    name_ = std::move(temporary);
}

void StagedFile::write(std::span<const std::byte> content) {
    while (!content.empty()) {
        const ssize_t written = ::write(file_, content.data(), content.size());
        if (written >= 0) {
            content = content.subspan(static_cast<std::size_t>(written));
        } else if (errno != EINTR) {
            fail(errno);
        }
    }
}

// linkat does not replace an existing file. If a file with the name of the target exists, the new
// file first gets a temporary name, and is then renamed, which replaces the existing file. If
// closing the new file fails, its content may be lost. The file is then not renamed, and the
// destructor removes it, even if it already has the name of the target.
void StagedFile::publish() {
    if (name_.empty()) {
        std::filesystem::path name = target_;
        if (!link_as(name)) {
            do {
                name = unique_sibling(target_);
            } while (!link_as(name));
        }
        name_ = std::move(name);
    }
    if (::close(std::exchange(file_, -1)) != 0) {
        fail(errno);
    }
    if (name_ != target_ && std::rename(name_.c_str(), target_.c_str()) != 0) {
        fail(errno);
    }
    name_.clear();
}

// Gives a file without a name the given name. Returns false if a file of this name exists.
bool StagedFile::link_as(const std::filesystem::path& path) const {
    if (linkat(AT_FDCWD, link_to(file_).c_str(), AT_FDCWD, path.c_str(), AT_SYMLINK_FOLLOW) == 0) {
        return true;
    }
    if (errno != EEXIST) {
        fail(errno);
    }
    return false;
}

// Closes the file. Removes it if it has not been published.
void StagedFile::close() {
    if (file_ >= 0) {
        ::close(std::exchange(file_, -1));
    }
    if (!name_.empty()) {
        unlink(name_.c_str());
        name_.clear();
    }
}

void StagedFile::fail(int error) const {
    throw OutputError(fmt::format("cannot write '{}': {}", target_.string(), reason(error)));
}

void write_file(const std::filesystem::path& path,
                std::span<const std::byte> content,
                Durability durability) {
    StagedFile(path, content, durability).publish();
}

bool is_existing(const std::filesystem::path& path) {
    std::error_code error;
    const bool exists = std::filesystem::exists(path, error);
    if (error) {
        throw OutputError(fmt::format("cannot access '{}': {}", path.string(), error.message()));
    }
    return exists;
}

std::filesystem::path nearest_existing(const std::filesystem::path& folder) {
    std::error_code error;
    std::filesystem::path existing = folder.empty() ? std::filesystem::current_path(error)
                                                    : std::filesystem::absolute(folder, error);
    if (error) {
        throw OutputError(fmt::format("cannot find the working directory: {}", error.message()));
    }
    while (!is_existing(existing) && existing.has_relative_path()) {
        existing = existing.parent_path();
    }
    return existing;
}

// Creates a folder instead of checking permissions. For the administrator, the permissions of every
// folder of /proc would allow writing, although no file can be created there.
void check_writable(const std::filesystem::path& folder) {
    const std::filesystem::path existing = nearest_existing(folder);
    std::string probe = (existing / ".foamtex-XXXXXX").string();
    if (mkdtemp(probe.data()) == nullptr) {
        throw OutputError(
            fmt::format("cannot write into '{}': {}", existing.string(), reason(errno)));
    }
    rmdir(probe.c_str());
}

void make_folders(const std::filesystem::path& folder) {
    std::error_code error;
    if (!folder.empty() && !std::filesystem::create_directories(folder, error) && error) {
        throw OutputError(
            fmt::format("cannot create the folder '{}': {}", folder.string(), error.message()));
    }
}

}  // namespace foam
