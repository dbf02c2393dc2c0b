// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "texgen/bake/bake.h"
#include "texgen/manifest/file_lock.h"
#include "texgen/manifest/manifest.h"

#include <chrono>
#include <filesystem>
#include <string>
#include <vector>

namespace foam::texgen {

/// Returns the folder of the manifest of a bake of a preset. This is the deepest folder that
/// contains all images of the preset, whichever maps and frames are baked. The path is empty for
/// the working folder. Throws std::invalid_argument if output.pattern is malformed (FilePattern).
std::filesystem::path manifest_folder(const Preset& preset);

/// Returns the paths of the files that a bake will write, relative to `folder`, the folder of the
/// manifest. The files of the frames in BakeOptions::existing_frames are left out, because the bake
/// keeps them.
std::vector<std::string> written_paths(const Preset& preset,
                                       const BakeOptions& options,
                                       const std::filesystem::path& folder);

/// Records a bake in the manifest of its folder while the bake runs. The functions throw
/// OutputError if the manifest cannot be written, and InputError if an existing manifest cannot be
/// read.
class BakeRecorder {
  public:
    /// Prepares the set (BakedSet), the part of the manifest that describes the bake. Does not
    /// write the manifest yet.
    BakeRecorder(const Preset& preset, const BakeOptions& options);

    /// Removes from the manifest the files that the bake will write, and adds the set of the bake.
    /// Removes the temporary files of killed programs from the folders of these files. Only the
    /// first call has an effect.
    void begin();

    /// Adds a frame, whose files have been written, to the set. Writes the manifest if enough time
    /// has passed since it was last written. Precondition: `begin` has been called.
    void add(const BakedFrame& baked);

    /// Calls `begin`, and writes the manifest at the end of the bake. `failure` is the reason why
    /// the bake ended early, or empty. `patience` is the longest time to wait for the lock of the
    /// manifest.
    void close(const std::string& failure, std::chrono::milliseconds patience = FileLock::kMaxWait);

    /// Returns true if `begin` has changed the manifest.
    bool begun() const { return begun_; }

  private:
    void save(std::chrono::milliseconds patience = FileLock::kMaxWait);

    std::filesystem::path folder_;
    BakedSet set_;
    std::vector<std::string> paths_;  // paths of the files that the bake will write
    bool begun_ = false;
    std::chrono::steady_clock::time_point next_save_{};
};

}  // namespace foam::texgen
