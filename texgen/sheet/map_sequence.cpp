// SPDX-License-Identifier: Apache-2.0

#include "texgen/sheet/map_sequence.h"

#include "core/files/file_io.h"
#include "texgen/bake/frame_range.h"
#include "texgen/keys/nearest.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

namespace foam::texgen {

namespace {

// Returns the map with the given name. Throws std::invalid_argument if no image of this map was
// baked; vector files are not images.
const ManifestMap& baked_map(const BakedSet& set, std::string_view name) {
    const ManifestMap* const map = set.find_map(name);
    if (map != nullptr && map->samples) {
        return *map;
    }
    if (map != nullptr && !map->vector_format.empty()) {
        throw std::invalid_argument(
            fmt::format("'{}' is in {} files, which have no pixels; bake PNG or EXR files instead",
                        name,
                        map->vector_format));
    }
    std::vector<std::string_view> existing;
    for (const ManifestMap& other : set.maps) {
        if (other.samples) {
            existing.emplace_back(other.name);
        }
    }
    throw std::invalid_argument(
        fmt::format("map '{}' was not baked; baked maps: {}{}",
                    name,
                    existing.empty() ? "none" : fmt::format("{}", fmt::join(existing, ", ")),
                    did_you_mean(name, existing)));
}

// Returns the frames for which the set has a file of the map.
std::vector<int> existing_frames(const BakedSet& set, std::string_view map) {
    std::vector<int> existing = set.frames();
    std::erase_if(existing, [&](int frame) { return set.find_file(map, frame) == nullptr; });
    return existing;
}

MapFile file_of(const BakedSet& set,
                const std::filesystem::path& folder,
                std::string_view map,
                int frame) {
    const ManifestFile* const file = set.find_file(map, frame);
    const FrameStatistics* const statistics = set.find_frame(frame);
    if (file == nullptr || statistics == nullptr) {
        const std::vector<int> existing = existing_frames(set, map);
        throw InputError(fmt::format(
            "frame {} of map '{}' of preset '{}' was not baked into '{}', or another bake has "
            "replaced it; existing frames: {}",
            frame,
            map,
            set.preset,
            folder.string(),
            existing.empty() ? "none" : format_frame_range(existing)));
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

bool closes(const ManifestLoop& loop, std::span<const int> frames) {
    const std::optional<int> step = common_step(frames);
    return loop.period > 0 && step &&
           std::abs(*step) * static_cast<int>(frames.size()) == loop.period;
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
