// SPDX-License-Identifier: Apache-2.0

#include "texgen/manifest/manifest.h"

#include "texgen/maps/motion.h"

#include <algorithm>
#include <set>

namespace foam::texgen {

namespace {

template <class Range, class Member, class Value>
auto* find_by(Range& range, Member member, const Value& value) {
    const auto found = std::ranges::find(range, value, member);
    return found != range.end() ? &*found : nullptr;
}

bool has_map(const ManifestFile& file, std::string_view map) {
    return std::ranges::find(file.maps, map) != file.maps.end();
}

void merge_numbers(std::vector<int>& into, const std::vector<int>& more) {
    std::set<int> all(into.begin(), into.end());
    all.insert(more.begin(), more.end());
    into.assign(all.begin(), all.end());
}

void merge_maps(BakedSet& into, const std::vector<ManifestMap>& more) {
    for (const ManifestMap& map : more) {
        ManifestMap* const old = find_by(into.maps, &ManifestMap::name, map.name);
        if (old == nullptr) {
            into.maps.push_back(map);
            continue;
        }
        merge_numbers(old->frames, map.frames);
        if (map.samples) {
            old->note = map.note;
            old->samples = map.samples;
        }
    }
}

// Returns the sort key of a file: its frame, then the index of its first map in the list of maps of
// the set.
auto sort_key_of(const BakedSet& set, const ManifestFile& file) {
    const auto map = std::ranges::find(set.maps, file.maps.front(), &ManifestMap::name);
    return std::pair(file.frame, map - set.maps.begin());
}

// Merges a set into a set with the same parameters.
void merge_into(BakedSet& into, const BakedSet& more) {
    into.toml = more.toml;
    const std::optional<double> closing_error = into.loop.closing_error;
    into.loop = more.loop;
    into.loop.closing_error = more.loop.closing_error ? more.loop.closing_error : closing_error;
    // The conventions contain the motion multiplier. If the multiplier is automatic, it is known
    // only after ranges have been fitted. ManifestMap::samples is set when the first file of a map
    // is written. If it is set for the map `motion` of `more`, the multiplier is known.
    const ManifestMap* const motion = more.find_map(kMotionMap.name);
    if (motion != nullptr && motion->samples) {
        into.conventions = more.conventions;
    }
    merge_maps(into, more.maps);
    for (FrameStatistics frame : more.frame_statistics) {
        if (const FrameStatistics* const old = into.find_frame(frame.frame)) {
            frame.measurements =
                frame.measurements.empty() ? old->measurements : frame.measurements;
        }
        std::erase_if(into.frame_statistics,
                      [&](const auto& old) { return old.frame == frame.frame; });
        into.frame_statistics.push_back(std::move(frame));
    }
    into.files.insert(into.files.end(), more.files.begin(), more.files.end());
    std::ranges::sort(into.frame_statistics, {}, &FrameStatistics::frame);
    std::ranges::sort(into.files, {}, [&](const auto& file) { return sort_key_of(into, file); });
    into.failure = into.complete() ? "" : more.failure;
}

}  // namespace

bool BakedSet::complete() const {
    std::set<std::pair<std::string, int>> existing;
    for (const ManifestFile& file : files) {
        for (const std::string& map : file.maps) {
            existing.emplace(map, file.frame);
        }
    }
    return std::ranges::all_of(maps, [&](const ManifestMap& map) {
        return std::ranges::all_of(map.frames, [&](int frame) {
            return existing.contains({map.name, frame});
        });
    });
}

std::vector<int> BakedSet::frames() const {
    std::vector<int> all;
    for (const ManifestMap& map : maps) {
        merge_numbers(all, map.frames);
    }
    return all;
}

const ManifestMap* BakedSet::find_map(std::string_view name) const {
    return find_by(maps, &ManifestMap::name, name);
}

const ManifestFile* BakedSet::find_file(std::string_view map, int frame) const {
    const auto found = std::ranges::find_if(
        files, [&](const auto& file) { return file.frame == frame && has_map(file, map); });
    return found != files.end() ? &*found : nullptr;
}

const FrameStatistics* BakedSet::find_frame(int frame) const {
    return find_by(frame_statistics, &FrameStatistics::frame, frame);
}

BakedSet* find_same_set(Manifest& manifest, const BakedSet& set) {
    return find_by(manifest.sets, &BakedSet::parameters, set.parameters);
}

const BakedSet* find_same_set(const Manifest& manifest, const BakedSet& set) {
    return find_by(manifest.sets, &BakedSet::parameters, set.parameters);
}

void merge(Manifest& manifest, const BakedSet& set) {
    std::vector<std::string> paths;
    for (const ManifestFile& file : set.files) {
        paths.push_back(file.path);
    }
    remove_files(manifest, paths);
    BakedSet* const same = find_same_set(manifest, set);
    if (same != nullptr) {
        merge_into(*same, set);
        std::rotate(manifest.sets.begin() + (same - manifest.sets.data()),
                    manifest.sets.begin() + (same - manifest.sets.data()) + 1,
                    manifest.sets.end());
    } else {
        manifest.sets.push_back(set);
    }
    std::erase_if(manifest.sets, [&](const BakedSet& other) {
        return other.files.empty() && other.parameters != set.parameters;
    });
}

void add_scenes(Manifest& manifest,
                std::string_view parameters,
                const std::vector<ManifestScene>& scenes) {
    BakedSet* const set = find_by(manifest.sets, &BakedSet::parameters, parameters);
    if (set == nullptr) {
        return;
    }
    for (BakedSet& other : manifest.sets) {
        std::erase_if(other.scenes, [&](const ManifestScene& scene) {
            return find_by(scenes, &ManifestScene::path, scene.path) != nullptr;
        });
    }
    set->scenes.insert(set->scenes.end(), scenes.begin(), scenes.end());
}

std::vector<ReplacedFiles> replaced_files(const Manifest& manifest,
                                          std::string_view parameters,
                                          const std::vector<std::string>& paths) {
    const std::set<std::string> replaced(paths.begin(), paths.end());
    std::vector<ReplacedFiles> found;
    for (const BakedSet& set : manifest.sets) {
        const auto count = std::ranges::count_if(
            set.files, [&](const ManifestFile& file) { return replaced.contains(file.path); });
        if (set.parameters != parameters && count > 0) {
            found.push_back({&set, static_cast<std::size_t>(count)});
        }
    }
    return found;
}

void remove_files(Manifest& manifest, const std::vector<std::string>& paths) {
    const std::set<std::string> removed(paths.begin(), paths.end());
    for (BakedSet& set : manifest.sets) {
        std::erase_if(set.files, [&](const auto& file) { return removed.contains(file.path); });
    }
}

}  // namespace foam::texgen
