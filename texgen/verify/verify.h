#pragma once

#include "texgen/manifest/manifest.h"
#include "texgen/verify/steps.h"

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace foam::texgen {

/// Tiles hold where the step across the border is at most so many times the largest within, in all
/// frames together.
inline constexpr double kLargestTileRatio = 1.25;
/// Smaller images, in pixels, have too few steps to compare with.
inline constexpr int kSmallestTile = 64;
/// A loop holds where the step from its last frame to its first is at most so many times the
/// largest from frame to frame.
inline constexpr double kLargestLoopRatio = 1.1;

/// What was found of a map; nothing where it was not to be checked, or could not be.
struct VerifiedMap {
    std::string name;
    std::optional<Seam> tile;
    int tile_frame = 0;  // with the largest step across the border
    std::optional<Seam> loop;

    bool holds() const;
};

/// What was found of a set of images.
struct VerifiedSet {
    BakedSet set;
    int files_same = 0;                 // that have the pixels that were baked
    std::vector<std::string> problems;  // one line each: files, frames that lack, seams
    std::vector<VerifiedMap> maps;

    bool holds() const { return problems.empty(); }
};

/// What was found of a folder, and where that was.
struct Verification {
    std::filesystem::path folder;
    std::vector<VerifiedSet> sets;

    /// Whether everything does; not of a folder without images.
    bool holds() const;
};

/// Checks the images of a folder, or of a manifest in it, against the manifest: that every file is
/// there and decodes to the pixels that were baked, that what tiles has no seam, and that what
/// loops leads from its last frame to its first. A loop is checked once all frames of its period
/// are there. Throws InputError where the manifest cannot be read; all else is found, not thrown.
Verification verify(const std::filesystem::path& path);

/// For persons: a few lines a set.
std::string to_text(const Verification& found);

/// For programs: one JSON object (README.md has the members).
std::string to_json(const Verification& found);

}  // namespace foam::texgen
