// SPDX-License-Identifier: Apache-2.0

// Runs a fuzz target once for each given file, and for each file of the given folders. This needs
// no libFuzzer, so every compiler can build it.

#include "core/files/file_io.h"
#include "tests/fuzz/fuzz_target.h"

#include <cstdio>
#include <filesystem>
#include <span>
#include <vector>

namespace {

std::vector<std::filesystem::path> files_of(const std::filesystem::path& path) {
    if (!std::filesystem::is_directory(path)) {
        return {path};
    }
    std::vector<std::filesystem::path> files;
    for (const auto& entry : std::filesystem::directory_iterator(path)) {
        files.push_back(entry.path());
    }
    return files;
}

}  // namespace

int main(int argc, char** argv) {
    if (argc < 3) {
        std::fputs("usage: fuzz_replay TARGET FILE_OR_FOLDER...\n", stderr);
        return 2;
    }
    const foam::fuzz::FuzzTarget& target = foam::fuzz::target_named(argv[1]);
    int runs = 0;
    for (const char* const argument : std::span(argv, static_cast<std::size_t>(argc)).subspan(2)) {
        for (const std::filesystem::path& file : files_of(argument)) {
            std::printf("%s\n", file.c_str());
            std::fflush(stdout);  // if the target aborts, the last line names the file
            const foam::Bytes content = foam::read_file(file, foam::kImageInput);
            target.run({reinterpret_cast<const char*>(content.data()), content.size()});
            ++runs;
        }
    }
    std::printf("%d runs\n", runs);
    return runs > 0 ? 0 : 1;
}
