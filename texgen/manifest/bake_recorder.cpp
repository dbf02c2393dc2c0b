// SPDX-License-Identifier: Apache-2.0

#include "texgen/manifest/bake_recorder.h"

#include "core/files/abandoned_files.h"
#include "texgen/bake/file_pattern.h"
#include "texgen/bake/frame_files.h"
#include "texgen/manifest/describe.h"
#include "texgen/manifest/manifest_file.h"

#include <set>
#include <string_view>

namespace foam::texgen {

namespace {

using Clock = std::chrono::steady_clock;

// Approximate upper limit on the fraction of the duration of a bake that is spent on writing the
// manifest.
constexpr double kMaxSaveFraction = 0.05;

}  // namespace

std::filesystem::path manifest_folder(const Preset& preset) {
    return FilePattern(preset).folder();
}

std::vector<std::string> written_paths(const Preset& preset,
                                       const BakeOptions& options,
                                       const std::filesystem::path& folder) {
    const FrameFiles files(preset);
    std::vector<std::string> paths;
    for (const int frame : options.frames) {
        if (options.existing_frames.contains(frame)) {
            continue;
        }
        for (const std::filesystem::path& path : files.paths(frame)) {
            paths.push_back(relative_path(path, folder));
        }
    }
    return paths;
}

BakeRecorder::BakeRecorder(const Preset& preset, const BakeOptions& options)
    : folder_(manifest_folder(preset)),
      set_(describe(preset, options.frames)),
      paths_(written_paths(preset, options, folder_)) {}

void BakeRecorder::begin() {
    if (begun_) {
        return;
    }
    std::set<std::string_view> subfolders{""};
    for (const std::string_view path : paths_) {
        subfolders.insert(path.substr(0, path.rfind('/') + 1));
    }
    for (const std::string_view subfolder : subfolders) {
        remove_abandoned_files(folder_ / subfolder);
    }
    update_manifest(folder_, [&](Manifest& manifest) {
        remove_files(manifest, paths_);
        merge(manifest, set_);
    });
    begun_ = true;
}

void BakeRecorder::add(const BakedFrame& baked) {
    add_frame(set_, baked, folder_);
    if (Clock::now() >= next_save_) {
        save();
    }
}

void BakeRecorder::close(const std::string& failure, std::chrono::milliseconds patience) {
    begin();
    set_.failure = failure;
    save(patience);
}

void BakeRecorder::save(std::chrono::milliseconds patience) {
    const Clock::time_point begin = Clock::now();
    update_manifest(
        folder_, [&](Manifest& manifest) { merge(manifest, set_); }, patience);
    const Clock::time_point end = Clock::now();
    next_save_ =
        end + std::chrono::duration_cast<Clock::duration>((end - begin) / kMaxSaveFraction);
}

}  // namespace foam::texgen
