// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "texgen/image/frame_rate.h"
#include "texgen/manifest/manifest.h"

#include <filesystem>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

namespace foam::texgen {

/// The file of one frame of a baked map.
struct MapFile {
    std::filesystem::path path;
    int frame = 0;
    bool tiles = false;    // true if the frame tiles in both directions
    bool layered = false;  // true if the file contains other maps, too
};

/// The files of a map, one per frame, in the order of the frames.
struct MapSequence {
    ManifestMap map;
    std::vector<MapFile> files;

    bool tiles() const;  // true if all frames tile
};

/// Returns the difference between successive frame numbers, or nullopt if it is not always the
/// same. Returns 1 for a single frame.
std::optional<int> common_step(std::span<const int> frames);

/// Returns the frame rate at which the given frames show the foam at the same speed as the whole
/// set. For example, every second frame of a set with 24 frames per second plays at 24 frames in
/// 2 s. Returns the frame rate of the set if the steps between the frames differ.
FrameRate playing_rate(const BakedSet& set, std::span<const int> frames);

/// Returns the files of the given frames of a map. `folder` is the folder of the set's manifest.
/// Throws std::invalid_argument, with a list of the existing maps, for a map that was not baked,
/// and InputError for a frame that was not baked.
MapSequence map_sequence(const BakedSet& set,
                         const std::filesystem::path& folder,
                         std::string_view map,
                         std::span<const int> frames);

}  // namespace foam::texgen
