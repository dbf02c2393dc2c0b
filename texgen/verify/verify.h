// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "texgen/animation/progress.h"
#include "texgen/manifest/manifest.h"
#include "texgen/manifest/set_choice.h"
#include "texgen/verify/steps.h"

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace foam::texgen {

/// The largest allowed Seam::ratio of frames that tile. The ratio is the largest step across the
/// border of any frame, divided by the largest step within any frame. A step is the mean difference
/// of the samples of two adjacent columns, rows or frames (steps.h).
inline constexpr double kMaxTileRatio = 1.25;
/// The smallest width and height, in pixels, of images whose tiling is checked. Smaller images have
/// too few columns or rows for a comparison.
inline constexpr int kMinTileSize = 64;
/// The smallest period, in frames, of loops that are checked. Shorter loops have too few steps for
/// a comparison.
inline constexpr int kMinLoopPeriod = 5;

/// Returns the largest allowed Seam::ratio of a loop with a period of `period` >= kMinLoopPeriod
/// frames. The ratio is the step from the last frame to the first, divided by the largest step
/// between successive frames. If all pixels change like sines of the same phase, the steps before
/// and after the largest step are cos(2 pi / period) times as large. The allowed ratio is 1.1 /
/// cos(2 pi / period): 1.11 for 48 frames, 1.56 for 8 frames.
double largest_loop_ratio(int period);

/// The result of checking the seams of a map. A seam that was not checked is nullopt. `tile` is the
/// seam of the columns or the seam of the rows, whichever has the larger ratio.
struct VerifiedMap {
    std::string name;
    std::optional<Seam> tile;
    int tile_frame = 0;  // the frame with the largest step across this seam; 0 without `tile`
    std::optional<Seam> loop;
    // The smallest and the largest number in all files of the map. `clipped` is the largest
    // fraction of the samples of a file that are clipped, that is, outside of the range of the map.
    // Clipped samples do not count as a problem. nullopt if the manifest does not record these
    // numbers.
    std::optional<NumberExtent> numbers{};

    /// Returns true if the ratio of `tile` is at most kMaxTileRatio and the ratio of `loop`, a
    /// loop of `period` frames, is at most largest_loop_ratio(period). A seam that was not checked
    /// does not count.
    bool holds(int period) const;
};

/// The result of checking a set of images (BakedSet): the images of one preset that were baked with
/// the same values of the keys.
struct VerifiedSet {
    BakedSet set;
    // Number of images and vector files whose content has the hash that the manifest records.
    int files_same = 0;
    // One line for each of these problems:
    // - a bad file: an image, a vector file or a scene file;
    // - a group of maps that lack the same frames;
    // - a seam whose ratio is above its limit.
    std::vector<std::string> problems;
    std::vector<VerifiedMap> maps;  // maps of which at least one file has the recorded pixels

    /// Returns true if there are no problems.
    bool holds() const { return problems.empty(); }
};

/// The sets of a manifest to check.
struct VerifyOptions {
    SetChoice choice = {};  // selects sets by preset, seed and size; by default, all sets
    bool all = false;       // true: all selected sets; false: the newest selected set per preset
};

/// The result of checking a folder.
struct Verification {
    std::filesystem::path folder;   // folder of the manifest
    std::vector<VerifiedSet> sets;  // the sets that were checked
    // Names (name_of) of the selected sets (VerifyOptions::choice) that were not checked, since a
    // newer set of the same preset is selected, too.
    std::vector<std::string> unchecked = {};

    /// Returns true if no set has a problem. Returns false for a folder without sets.
    bool holds() const;
};

/// Checks the images of a folder against its manifest. Every file must exist, and its pixels must
/// have the hash that the manifest records for them. The content of every vector file and scene
/// file must have its recorded hash, too. The ratios of the seams (Seam::ratio) of frames that tile
/// and of loops must not exceed their limits. A loop is only checked if its period is at least
/// kMinLoopPeriod frames, and if all frames of the period have the recorded pixels. Frames after
/// the period are ignored. `path` is the folder or the manifest in it. Throws InputError if the
/// manifest has sets, but the choice selects none; all other problems are part of the result.
/// `on_progress` receives the progress of the phase Phase::Files.
Verification verify(const Manifest& manifest,
                    const std::filesystem::path& path,
                    const VerifyOptions& options,
                    const ProgressCallback& on_progress = {});

/// Reads the manifest of a folder and checks the newest set of each preset. Throws InputError if
/// the manifest cannot be read.
Verification verify(const std::filesystem::path& path, const ProgressCallback& on_progress = {});

/// Returns the result as text for users, with a few lines per set.
std::string to_text(const Verification& found);

/// Returns the result as one JSON object for programs. REPORTS.md describes its members.
std::string to_json(const Verification& found);

}  // namespace foam::texgen
