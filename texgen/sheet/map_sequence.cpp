// SPDX-License-Identifier: Apache-2.0

#include "texgen/sheet/map_sequence.h"

#include "texgen/image/file_io.h"

#include <fmt/core.h>

#include <algorithm>
#include <cstdlib>
#include <stdexcept>
#include <string>

namespace foam::texgen {

namespace {

// Returns the map with the given name. Throws std::invalid_argument if no file of this map was
// baked.
const ManifestMap& baked_map(const BakedSet& set, std::string_view name) {
    const ManifestMap* const map = set.find_map(name);
    if (map != nullptr && map->samples) {
        return *map;
    }
    std::string existing;
    for (const ManifestMap& other : set.maps) {
        if (other.samples) {
            existing += (existing.empty() ? "" : ", ") + other.name;
        }
    }
    throw std::invalid_argument(fmt::format(
        "map '{}' was not baked; baked maps: {}", name, existing.empty() ? "none" : existing));
}

MapFile file_of(const BakedSet& set,
                const std::filesystem::path& folder,
                std::string_view map,
                int frame) {
    const ManifestFile* const file = set.find_file(map, frame);
    const FrameStatistics* const statistics = set.find_frame(frame);
    if (file == nullptr || statistics == nullptr) {
        throw InputError(fmt::format("frame {} of map '{}' of preset '{}' was not baked into '{}'",
                                     frame,
                                     map,
                                     set.preset,
                                     folder.string()));
    }
    return {folder / file->path, frame, statistics->tiles, file->maps.size() > 1};
}

}  // namespace

bool MapSequence::tiles() const {
    return std::ranges::all_of(files, &MapFile::tiles);
}

std::optional<int> common_step(std::span<const int> frames) {
    const int step = frames.size() > 1 ? frames[1] - frames[0] : 1;
    if (step == 0) {
        return std::nullopt;
    }
    for (std::size_t k = 1; k < frames.size(); ++k) {
        if (frames[k] - frames[k - 1] != step) {
            return std::nullopt;
        }
    }
    return step;
}

FrameRate playing_rate(const BakedSet& set, std::span<const int> frames) {
    return {set.frames_per_second, std::abs(common_step(frames).value_or(1))};
}

MapSequence map_sequence(const BakedSet& set,
                         const std::filesystem::path& folder,
                         std::string_view map,
                         std::span<const int> frames) {
    MapSequence sequence{baked_map(set, map), {}};
    for (const int frame : frames) {
        sequence.files.push_back(file_of(set, folder, map, frame));
    }
    return sequence;
}

}  // namespace foam::texgen
