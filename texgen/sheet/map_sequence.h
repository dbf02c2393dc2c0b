#pragma once

#include "texgen/image/frame_rate.h"
#include "texgen/manifest/manifest.h"

#include <filesystem>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

namespace foam::texgen {

/// One frame of a map that was baked.
struct MapFile {
    std::filesystem::path path;
    int frame = 0;
    bool tiles = false;    // in both directions
    bool layered = false;  // the file has other maps as well
};

/// The files of a map, one a frame, in the order of the frames.
struct MapSequence {
    ManifestMap map;
    std::vector<MapFile> files;

    bool tiles() const;  // all of it
};

/// From each frame to the next, where that is the same for all; 1 of a single frame.
std::optional<int> common_step(std::span<const int> frames);

/// At which these frames of a set show it at its own speed: every second of 24 a second, 24 in 2 s.
/// The set's own rate where the steps differ.
FrameRate playing_rate(const BakedSet& set, std::span<const int> frames);

/// Of a set whose manifest lies in the folder. Throws std::invalid_argument that lists the maps
/// there are, InputError for a frame that was not baked.
MapSequence map_sequence(const BakedSet& set,
                         const std::filesystem::path& folder,
                         std::string_view map,
                         std::span<const int> frames);

}  // namespace foam::texgen
