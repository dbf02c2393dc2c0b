// SPDX-License-Identifier: Apache-2.0

#include "texgen/image/memory.h"

#include <fmt/core.h>
#include <malloc.h>
#include <sys/resource.h>
#include <unistd.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <limits>
#include <optional>

namespace foam::texgen {

namespace {

constexpr std::uint64_t kUnlimited = std::numeric_limits<std::uint64_t>::max();

// Returns the unused part of a limit. Both arguments are in bytes.
std::uint64_t unused_part(std::uint64_t limit, std::uint64_t used) {
    return limit - std::min(limit, used);
}

// Returns the memory, in bytes, that the machine can give to programs without swapping.
std::uint64_t machine_memory() {
    constexpr std::uint64_t kKibibyte = 1024;
    std::ifstream file("/proc/meminfo");
    std::string name;
    std::uint64_t kibibytes = 0;
    for (std::string unit; file >> name >> kibibytes && std::getline(file, unit);) {
        if (name == "MemAvailable:") {
            return kibibytes * kKibibyte;
        }
    }
    return kUnlimited;
}

// Returns how many more bytes of address space the limit of the process (ulimit -v) allows.
std::uint64_t address_space_left() {
    rlimit limit{};
    if (getrlimit(RLIMIT_AS, &limit) != 0 || limit.rlim_cur == RLIM_INFINITY) {
        return kUnlimited;
    }
    std::uint64_t pages = 0;
    std::ifstream("/proc/self/statm") >> pages;
    return unused_part(limit.rlim_cur, pages * static_cast<std::uint64_t>(sysconf(_SC_PAGESIZE)));
}

// Returns the number in a file. Returns nullopt if there is no file, or if the file contains the
// word "max" instead of a number, which means that there is no limit.
std::optional<std::uint64_t> number_in(const std::filesystem::path& path) {
    std::ifstream file(path);
    std::uint64_t number = 0;
    return file >> number ? std::optional(number) : std::nullopt;
}

// Returns how many more bytes a control group may use. This is the smallest unused part among the
// limits of this group and of the groups above it.
std::uint64_t left_in_group(std::filesystem::path group) {
    const std::filesystem::path root = "/sys/fs/cgroup";
    std::uint64_t left = kUnlimited;
    for (group = root / group.relative_path();; group = group.parent_path()) {
        const auto limit = number_in(group / "memory.max");
        const auto used = number_in(group / "memory.current");
        if (limit && used) {
            left = std::min(left, unused_part(*limit, *used));
        }
        if (group == root || !group.has_relative_path()) {
            return left;
        }
    }
}

std::uint64_t group_memory() {
    constexpr std::string_view kVersion2 = "0::";
    std::ifstream file("/proc/self/cgroup");
    for (std::string line; std::getline(file, line);) {
        if (line.starts_with(kVersion2)) {
            return left_in_group(line.substr(kVersion2.size()));
        }
    }
    return kUnlimited;
}

}  // namespace

std::uint64_t available_memory() {
    return std::min({machine_memory(), address_space_left(), group_memory()});
}

void save_address_space() {
#ifdef M_ARENA_MAX
    constexpr int kMaxHeaps = 2;  // threads share these heaps
    if (address_space_left() != kUnlimited) {
        mallopt(M_ARENA_MAX, kMaxHeaps);
    }
#endif
}

void require_memory(std::uint64_t bytes, const std::string& what) {
    const std::uint64_t available = available_memory();
    if (bytes > available) {
        throw OutOfMemory(fmt::format("{} needs {} of memory, but only {} are available",
                                      what,
                                      amount_of_bytes(bytes),
                                      amount_of_bytes(available)));
    }
}

std::string amount_of_bytes(std::uint64_t bytes) {
    constexpr double kMega = 1e6;
    constexpr double kGiga = 1e9;
    const auto number = static_cast<double>(bytes);
    return number < kGiga ? fmt::format("{:.1f} MB", number / kMega)
                          : fmt::format("{:.1f} GB", number / kGiga);
}

}  // namespace foam::texgen
