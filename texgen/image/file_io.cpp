// SPDX-License-Identifier: Apache-2.0

#include "texgen/image/file_io.h"

#include <fmt/core.h>
#include <unistd.h>

#include <array>
#include <atomic>
#include <cerrno>
#include <cstdio>
#include <memory>
#include <string>
#include <system_error>
#include <utility>

namespace foam::texgen {

namespace {

constexpr std::size_t kReadBlock = 1 << 16;  // bytes

std::string reason(int error) {
    return std::generic_category().message(error);
}

/// A file that is written under a temporary name. The destructor removes the file unless `publish`
/// has renamed it.
class TemporaryFile {
  public:
    explicit TemporaryFile(const std::filesystem::path& target)
        : target_(target), path_(unique_sibling(target)) {
        file_ = std::fopen(path_.c_str(), "wbx");
        if (file_ == nullptr) {
            fail(errno);
        }
    }
    ~TemporaryFile() {
        if (file_ != nullptr) {
            std::fclose(file_);
        }
        if (!published_) {
            std::remove(path_.c_str());
        }
    }
    TemporaryFile(const TemporaryFile&) = delete;
    TemporaryFile& operator=(const TemporaryFile&) = delete;

    void write(std::span<const std::byte> content) {
        if (std::fwrite(content.data(), 1, content.size(), file_) != content.size()) {
            fail(errno);
        }
    }

    /// Closes the file and renames it to the target.
    void publish() {
        if (std::fclose(std::exchange(file_, nullptr)) != 0) {
            fail(errno);
        }
        if (std::rename(path_.c_str(), target_.c_str()) != 0) {
            fail(errno);
        }
        published_ = true;
    }

  private:
    // Returns a path in the folder of the target that no other thread or process of the same
    // machine uses.
    static std::filesystem::path unique_sibling(const std::filesystem::path& target) {
        static std::atomic<unsigned> count{0};
        std::filesystem::path sibling = target;
        sibling += fmt::format(".{}-{}.part", getpid(), ++count);
        return sibling;
    }

    [[noreturn]] void fail(int error) const {
        throw OutputError(fmt::format("cannot write '{}': {}", target_.string(), reason(error)));
    }

    std::filesystem::path target_;
    std::filesystem::path path_;
    std::FILE* file_ = nullptr;
    bool published_ = false;
};

struct Close {
    void operator()(std::FILE* file) const { std::fclose(file); }
};

[[noreturn]] void fail_to_read(const std::filesystem::path& path, int error) {
    throw InputError(fmt::format("cannot read '{}': {}", path.string(), reason(error)));
}

}  // namespace

Bytes read_file(const std::filesystem::path& path) {
    const std::unique_ptr<std::FILE, Close> file(std::fopen(path.c_str(), "rb"));
    if (file == nullptr) {
        fail_to_read(path, errno);
    }
    Bytes content;
    std::array<std::byte, kReadBlock> block{};
    while (const std::size_t count = std::fread(block.data(), 1, block.size(), file.get())) {
        content.insert(
            content.end(), block.begin(), block.begin() + static_cast<std::ptrdiff_t>(count));
    }
    if (std::ferror(file.get()) != 0) {
        fail_to_read(path, errno);
    }
    return content;
}

void write_file(const std::filesystem::path& path, std::span<const std::byte> content) {
    TemporaryFile file(path);
    file.write(content);
    file.publish();
}

// Checks the folder itself or, if it does not exist, the nearest folder above it that does.
void check_writable(const std::filesystem::path& folder) {
    std::error_code error;
    std::filesystem::path existing = folder.empty() ? std::filesystem::current_path(error)
                                                    : std::filesystem::absolute(folder, error);
    while (!std::filesystem::exists(existing, error) && existing.has_relative_path()) {
        existing = existing.parent_path();
    }
    const bool is_folder = std::filesystem::is_directory(existing, error);
    if (!is_folder || ::access(existing.c_str(), W_OK | X_OK) != 0) {
        const int reason = is_folder ? errno : ENOTDIR;
        throw OutputError(fmt::format("cannot write into '{}': {}",
                                      existing.string(),
                                      std::generic_category().message(reason)));
    }
}

void make_folders(const std::filesystem::path& folder) {
    std::error_code error;
    if (!folder.empty() && !std::filesystem::create_directories(folder, error) && error) {
        throw OutputError(
            fmt::format("cannot create the folder '{}': {}", folder.string(), error.message()));
    }
}

}  // namespace foam::texgen
