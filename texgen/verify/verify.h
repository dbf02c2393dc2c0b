// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "texgen/manifest/manifest.h"
#include "texgen/verify/steps.h"

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace foam::texgen {

/// The largest ratio that counts as a seamless tile: the largest step across the border of any
/// frame, divided by the largest step within any frame.
inline constexpr double kLargestTileRatio = 1.25;
/// The smallest width and height, in pixels, of images whose tiling is checked. Smaller images have
/// too few columns or rows for a comparison.
inline constexpr int kSmallestTile = 64;
/// The largest ratio that counts as a seamless loop: the step from the last frame to the first,
/// divided by the largest step between successive frames.
inline constexpr double kLargestLoopRatio = 1.1;

/// The result of checking a map. A seam that was not checked is empty.
struct VerifiedMap {
    std::string name;
    std::optional<Seam> tile;
    int tile_frame = 0;  // the frame with the largest step across the border
    std::optional<Seam> loop;

    /// Returns true if no seam exceeds the largest allowed ratio.
    bool holds() const;
};

/// The result of checking a set of images.
struct VerifiedSet {
    BakedSet set;
    int files_same = 0;                 // number of files with the pixels that were baked
    std::vector<std::string> problems;  // one line each: invalid files, missing frames, seams
    std::vector<VerifiedMap> maps;

    /// Returns true if there are no problems.
    bool holds() const { return problems.empty(); }
};

/// The result of checking a folder.
struct Verification {
    std::filesystem::path folder;
    std::vector<VerifiedSet> sets;

    /// Returns true if no set has a problem. Returns false for a folder without sets.
    bool holds() const;
};

/// Checks the images of a folder against its manifest. Every file must exist and decode to the
/// pixels that were baked. Frames that tile must have no seam at their border, and loops no seam
/// between their last frame and their first. A loop is checked only if all frames of its period
/// exist. `path` is the folder or the manifest in it. Throws InputError if the manifest cannot be
/// read; all other problems are part of the result.
Verification verify(const std::filesystem::path& path);

/// Returns the result as text for people, with a few lines per set.
std::string to_text(const Verification& found);

/// Returns the result as one JSON object for programs. README.md describes its members.
std::string to_json(const Verification& found);

}  // namespace foam::texgen
