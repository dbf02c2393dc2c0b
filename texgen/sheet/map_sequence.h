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
    int frame = 0;         // number of the frame
    bool tiles = false;    // true if the frame tiles in both directions
    bool layered = false;  // true if the file contains several maps as layers
};

/// The files of a map, one per frame, in the order of the frames.
struct MapSequence {
    ManifestMap map;
    std::vector<MapFile> files;

    /// Returns true if all frames tile.
    bool tiles() const;
};

/// Returns the difference between successive frame numbers. Returns nullopt if the differences are
/// not all equal, or if they are 0. Returns 1 for fewer than two frames.
std::optional<int> common_step(std::span<const int> frames);

/// Returns the frame rate at which the given frames show the foam at the same speed as the whole
/// set. For example, if every second frame of a set with 24 frames per second is given, the rate is
/// 24 frames in 2 seconds. Returns the frame rate of the set if the frames have no common step.
FrameRate playing_rate(const BakedSet& set, std::span<const int> frames);

/// Returns true if the frames form a closed loop. Successive frame numbers must have the same
/// difference (step). The number of frames times the magnitude of this step must be the period of
/// the loop. The step of a single frame is 1.
bool closes(const ManifestLoop& loop, std::span<const int> frames);

/// Returns the files of the given frames of a map. `folder` is the folder of the manifest of the
/// set. Throws std::invalid_argument if the map was not baked (the message lists the baked maps),
/// or if its files are vector files, which have no pixels. Throws InputError if a frame was not
/// baked.
MapSequence map_sequence(const BakedSet& set,
                         const std::filesystem::path& folder,
                         std::string_view map,
                         std::span<const int> frames);

}  // namespace foam::texgen
