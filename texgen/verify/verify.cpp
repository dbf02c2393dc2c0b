// SPDX-License-Identifier: Apache-2.0

#include "texgen/verify/verify.h"

#include "core/geometry/elementary.h"
#include "core/geometry/max_or_nan.h"
#include "texgen/animation/progress_meter.h"
#include "texgen/bake/frame_range.h"
#include "texgen/manifest/manifest_file.h"
#include "texgen/verify/baked_file.h"
#include "texgen/verify/scene_check.h"

#include <fmt/core.h>

#include <algorithm>
#include <iterator>
#include <map>
#include <memory>
#include <numbers>
#include <utility>

namespace foam::texgen {

namespace {

// Every image is decoded once. The hash of its pixels is compared with the hash in the manifest.
// If they are equal, the picture is added to the MapCheck of each map in the file. A step is the
// mean difference of the samples of two adjacent columns, rows or frames (steps.h). A MapCheck
// accumulates the largest steps within frames, across the borders of frames and from frame to
// frame. A seam is the border of a frame that should tile, or the change from the last frame of a
// loop to the first. After the last file, the MapCheck returns the steps across seams and the
// largest other steps. Vector files are not decoded; only the hash of their content is compared.

// Returns how samples of a map are compared.
Difference difference_of(const ManifestMap& map) {
    return map.samples && map.samples->kind == "id" ? Difference::Ids : Difference::Numbers;
}

// Accumulates the steps of one map, frame after frame.
class MapCheck {
  public:
    // `period` is the number of frames of the loop, or 0 if there is no loop.
    MapCheck(const ManifestMap& map, int period)
        : difference_(difference_of(map)), period_(period), found_{map.name, {}, 0, {}} {}

    // Adds a frame of the map. Frames must be added in increasing order. `checks_border` is true if
    // the seams at the border of the frame are to be checked.
    void add(const DecodedFile& file, int frame, bool checks_border) {
        if (checks_border) {
            add_tile(tile_seams(groups_of(*file, found_.name), difference_), frame);
        }
        if (frame <= period_) {
            add_loop_frame(file, frame);
        }
    }

    // Returns the result. The loop is checked only if its period is at least kMinLoopPeriod and all
    // frames of the period were added.
    VerifiedMap finish() {
        const bool has_all_frames =
            period_ >= kMinLoopPeriod && first_frame_ == 1 && steps_ == period_ - 1;
        if (has_all_frames) {
            loop_.across = step(*last_, *first_);
            found_.loop = loop_;
        }
        if (const WorstSeam& border = worse_border(); border.frame > 0) {
            found_.tile = border.seam;
            found_.tile_frame = border.frame;
        }
        return found_;
    }

  private:
    void add_loop_frame(const DecodedFile& file, int frame) {
        if (last_ && frame == last_frame_ + 1) {
            loop_.largest_within = max_or_nan(loop_.largest_within, step(*last_, *file));
            ++steps_;
        }
        if (!last_) {
            first_ = file;
            first_frame_ = frame;
        }
        last_ = file;
        last_frame_ = frame;
    }

    void add_tile(const TileSeams& seams, int frame) {
        columns_.add(seams.columns, frame);
        rows_.add(seams.rows, frame);
    }

    // Returns the border whose step is larger relative to the largest other step (Seam::ratio).
    const WorstSeam& worse_border() const {
        return columns_.seam.ratio() > rows_.seam.ratio() ? columns_ : rows_;
    }

    double step(const Picture& a, const Picture& b) const {
        return step_between(groups_of(a, found_.name), groups_of(b, found_.name), difference_);
    }

    Difference difference_;
    int period_;
    VerifiedMap found_;
    DecodedFile first_;    // the first of the added frames that belong to the period
    DecodedFile last_;     // the last of the added frames that belong to the period
    int first_frame_ = 0;  // number of the frame `first_`
    int last_frame_ = 0;   // number of the frame `last_`
    int steps_ = 0;  // number of steps that were measured between successive frames of the period
    Seam loop_;
    WorstSeam columns_;
    WorstSeam rows_;
};

// Adds problems for missing frames: one line for all maps with the same missing frames.
void note_missing(const BakedSet& set, std::vector<std::string>& problems) {
    std::map<std::vector<int>, std::string> maps_by_missing;
    for (const ManifestMap& map : set.maps) {
        std::vector<int> missing;
        std::ranges::copy_if(map.frames, std::back_inserter(missing), [&](int frame) {
            return set.find_file(map.name, frame) == nullptr;
        });
        std::string& maps = maps_by_missing[missing];
        maps += (maps.empty() ? "" : ", ") + map.name;
    }
    maps_by_missing.erase(std::vector<int>());
    for (const auto& [missing, maps] : maps_by_missing) {
        problems.push_back(fmt::format("{}: frames {} are missing{}{}",
                                       maps,
                                       format_frame_range(missing),
                                       set.failure.empty() ? "" : ": ",
                                       set.failure));
    }
}

// Adds a problem for each seam of a map whose Seam::ratio is above its limit. `period` is the
// period of the loop.
void note_seams(const VerifiedMap& map, int period, std::vector<std::string>& problems) {
    if (map.tile && map.tile->ratio() > kMaxTileRatio) {
        problems.push_back(
            fmt::format("{}: frame {} does not tile: the step across its border is {:.3g} times "
                        "the largest step inside any frame",
                        map.name,
                        map.tile_frame,
                        map.tile->ratio()));
    }
    if (map.loop && map.loop->ratio() > largest_loop_ratio(period)) {
        problems.push_back(
            fmt::format("{}: does not loop: the step from its last frame to its first is {:.3g} "
                        "times the largest step between frames",
                        map.name,
                        map.loop->ratio()));
    }
}

// Returns the smallest and the largest number in all files of a map, and the largest fraction of
// samples that were clipped in one file. Returns nullopt if the manifest does not record them.
std::optional<NumberExtent> numbers_of(const BakedSet& set, const std::string& map) {
    std::optional<NumberExtent> numbers;
    for (const ManifestFile& file : set.files) {
        if (file.numbers && file.maps.front() == map) {
            numbers = numbers ? joined(*numbers, *file.numbers) : file.numbers;
        }
    }
    return numbers;
}

// Returns true if the border of a frame is to be checked: if the frame should tile and its images
// are large enough.
bool is_border_checked(const BakedSet& set, int frame) {
    const FrameStatistics* const found = set.find_frame(frame);
    return found != nullptr && found->tiles && std::min(set.width, set.height) >= kMinTileSize;
}

VerifiedSet verify_set(const BakedSet& set,
                       const std::filesystem::path& folder,
                       ProgressMeter& progress) {
    VerifiedSet found{set, 0, {}, {}};
    note_missing(set, found.problems);
    std::map<std::string, MapCheck> checks;
    for (const ManifestFile& file : set.files) {
        if (!set.find_map(file.maps.front())->vector_format.empty()) {
            found.files_same += is_unchanged_vector_file(file, folder, found.problems) ? 1 : 0;
            progress.add();
            continue;
        }
        if (const DecodedFile decoded = read_baked(file, folder, found.problems)) {
            ++found.files_same;
            for (const std::string& map : file.maps) {
                auto& check =
                    checks.try_emplace(map, *set.find_map(map), set.loop.period).first->second;
                check.add(decoded, file.frame, is_border_checked(set, file.frame));
            }
        }
        progress.add();
    }
    for (const ManifestMap& map : set.maps) {
        const auto check = checks.find(map.name);
        if (check != checks.end()) {
            found.maps.push_back(check->second.finish());
            found.maps.back().numbers = numbers_of(set, map.name);
            note_seams(found.maps.back(), set.loop.period, found.problems);
        }
    }
    const std::vector<std::string> scenes = scene_problems(set, folder);
    found.problems.insert(found.problems.end(), scenes.begin(), scenes.end());
    return found;
}

// Returns true if no later set of the list has the same preset. Sets are in the order in which they
// were baked.
bool is_newest(const BakedSet& set, const std::vector<const BakedSet*>& sets) {
    const auto newest = std::find_if(sets.rbegin(), sets.rend(), [&](const BakedSet* other) {
        return other->preset == set.preset;
    });
    return *newest == &set;
}

}  // namespace

double largest_loop_ratio(int period) {
    return 1.1 / ieee::cos(2.0 * std::numbers::pi / period);
}

bool VerifiedMap::holds(int period) const {
    return (!tile || tile->ratio() <= kMaxTileRatio) &&
           (!loop || loop->ratio() <= largest_loop_ratio(period));
}

bool Verification::holds() const {
    return !sets.empty() && std::ranges::all_of(sets, &VerifiedSet::holds);
}

Verification verify(const Manifest& manifest,
                    const std::filesystem::path& path,
                    const VerifyOptions& options,
                    const ProgressCallback& on_progress) {
    if (!manifest.sets.empty()) {
        newest_set(manifest, options.choice, path);  // throws if the choice selects no set
    }
    Verification found{std::filesystem::is_directory(path) ? path : path.parent_path(), {}};
    const std::vector<const BakedSet*> selected = selected_sets(manifest, options.choice);
    std::vector<const BakedSet*> checked;
    std::size_t files = 0;
    for (const BakedSet* const set : selected) {
        if (options.all || is_newest(*set, selected)) {
            checked.push_back(set);
            files += set->files.size();
        } else {
            found.unchecked.push_back(name_of(*set));
        }
    }
    ProgressMeter progress(Phase::Files, static_cast<int>(files), on_progress);
    progress.begin();
    for (const BakedSet* const set : checked) {
        found.sets.push_back(verify_set(*set, found.folder, progress));
    }
    return found;
}

Verification verify(const std::filesystem::path& path, const ProgressCallback& on_progress) {
    return verify(read_manifest(path), path, {}, on_progress);
}

}  // namespace foam::texgen
