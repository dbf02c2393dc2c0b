// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "texgen/bake/written_file.h"

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace foam::texgen {

/// The version of the format of a manifest. It increases only when an older reader would misread a
/// newer file.
inline constexpr int kManifestVersion = 1;
inline constexpr std::string_view kManifestFormat = "foamtex-manifest";

/// One map of a set.
struct ManifestMap {
    std::string name;
    std::string meaning;
    std::string unit;                   // of the values, and the meaning of the codes of a PNG
    std::string note;                   // such as the direction of y; empty if there is none
    std::vector<int> frames;            // requested frames, in increasing order
    std::optional<MapSamples> samples;  // nullopt before the first file is written

    friend bool operator==(const ManifestMap&, const ManifestMap&) = default;
};

/// One image file.
struct ManifestFile {
    std::string path;               // relative to the folder of the manifest, with '/'
    std::vector<std::string> maps;  // one map, or all maps that are layers of an EXR
    int frame = 0;
    std::uint64_t bytes = 0;
    std::string pixels;  // pixel_hash

    friend bool operator==(const ManifestFile&, const ManifestFile&) = default;
};

/// Statistics of the foam of a frame, in foam units, and the time to compute it.
struct ManifestFrame {
    int frame = 0;
    bool tiles = false;  // true if its images tile in both directions
    double time = 0.0;   // foam time
    int bubbles = 0;
    double mean_area = 0.0;
    int t1 = 0;                // number of T1s since the previous frame of the bake
    int t2 = 0;                // number of T2s since the previous frame of the bake
    double area_error = 0.0;   // largest |A / A_target - 1|
    double angle_error = 0.0;  // largest deviation from 120 degrees, radians
    double simulating = 0.0;   // seconds
    double drawing = 0.0;      // seconds, including encoding and writing

    friend bool operator==(const ManifestFrame&, const ManifestFrame&) = default;
};

/// The loop of an animation: how its last frame leads back to the first.
struct ManifestLoop {
    std::string kind;    // value of the key loop.kind
    std::string called;  // description of the kind
    int period = 0;      // frames; 0 without a loop
    bool cross_faded = false;
    // Distance from the end of a cycle to its start, in diameters of a mean bubble.
    std::optional<double> closing_error;

    friend bool operator==(const ManifestLoop&, const ManifestLoop&) = default;
};

/// Conventions that a program needs to interpret the images; the same for all images of a set.
struct ManifestConventions {
    std::string rows = "top to bottom";
    std::string normal_y = "up";     // or "down"
    std::string motion_unit;         // of an EXR: "image widths" or "pixels"
    std::string motion_y = "up";     // or "down"
    double motion_multiplier = 0.0;  // image widths that the largest code of a PNG represents

    friend bool operator==(const ManifestConventions&, const ManifestConventions&) = default;
};

/// A set of images: maps and frames of one preset with the same values of its keys, baked with the
/// same version of foamtex.
struct BakedSet {
    std::string version;  // of foamtex
    std::string preset;   // name of the preset
    std::string description;
    std::string toml;        // the preset in full
    std::string parameters;  // hash of version, preset name and all keys except image.maps
    std::uint64_t seed = 0;
    int width = 0;
    int height = 0;
    int frames_per_second = 0;
    ManifestLoop loop;
    ManifestConventions conventions;
    std::vector<ManifestMap> maps;
    std::vector<ManifestFile> files;  // sorted by frame, then in the order of `maps`
    std::vector<ManifestFrame> foam;  // sorted by frame
    std::string failure;              // why a bake ended before its last frame; empty if it did not

    /// Returns true if every map has a file of each of its requested frames.
    bool complete() const;

    /// Returns the requested frames of all maps, in increasing order.
    std::vector<int> frames() const;

    /// Returns the map, file or frame, or nullptr if there is none.
    const ManifestMap* find_map(std::string_view name) const;
    const ManifestFile* find_file(std::string_view map, int frame) const;
    const ManifestFrame* find_frame(int frame) const;

    friend bool operator==(const BakedSet&, const BakedSet&) = default;
};

/// The manifest of a folder: all sets of images in it.
struct Manifest {
    std::vector<BakedSet> sets;

    friend bool operator==(const Manifest&, const Manifest&) = default;
};

/// Returns the set with the same parameters, or nullptr if there is none.
BakedSet* find_same_set(Manifest& manifest, const BakedSet& set);
const BakedSet* find_same_set(const Manifest& manifest, const BakedSet& set);

/// Merges the set of a bake into a manifest. If the manifest has a set with the same parameters,
/// the files and frames are added to it and replace those with the same paths and numbers;
/// otherwise the set is appended. Files with these paths are removed from all other sets, and other
/// sets without files are removed.
void merge(Manifest& manifest, const BakedSet& set);

/// Removes files from all sets. Used before a bake overwrites the files.
void remove_files(Manifest& manifest, const std::vector<std::string>& paths);

}  // namespace foam::texgen
