#pragma once

#include "texgen/bake/written_file.h"

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace foam::texgen {

/// Of the format of a manifest; it grows when an older reader could not go on from a newer file.
inline constexpr int kManifestVersion = 1;
inline constexpr std::string_view kManifestFormat = "foamtex-manifest";

/// One map of a set.
struct ManifestMap {
    std::string name;
    std::string meaning;
    std::string unit;                   // of its values, and what a PNG's codes stand for
    std::string note;                   // which way y points, say; empty where there is none
    std::vector<int> frames;            // asked for, in increasing order
    std::optional<MapSamples> samples;  // known from the first file on

    friend bool operator==(const ManifestMap&, const ManifestMap&) = default;
};

/// One image file.
struct ManifestFile {
    std::string path;               // relative to the folder of the manifest, with '/'
    std::vector<std::string> maps;  // one, or all those that are layers of an EXR
    int frame = 0;
    std::uint64_t bytes = 0;
    std::string pixels;  // pixel_hash

    friend bool operator==(const ManifestFile&, const ManifestFile&) = default;
};

/// The foam of a frame in numbers, in foam units, and what it took.
struct ManifestFrame {
    int frame = 0;
    bool tiles = false;  // whether its images do, in both directions
    double time = 0.0;   // foam time
    int bubbles = 0;
    double mean_area = 0.0;
    int t1 = 0;  // since the frame before it
    int t2 = 0;
    double area_error = 0.0;   // largest |A / A_target - 1|
    double angle_error = 0.0;  // largest deviation from 120 degrees, radians
    double simulating = 0.0;   // seconds
    double drawing = 0.0;      // seconds, encoding and writing too

    friend bool operator==(const ManifestFrame&, const ManifestFrame&) = default;
};

/// What leads the last frame back to the first.
struct ManifestLoop {
    std::string kind;    // as loop.kind has it
    std::string called;  // what that is, in words
    int period = 0;      // frames; 0 where there is no loop
    bool cross_faded = false;
    // How far the end of a cycle is from its start, in diameters of a mean bubble.
    std::optional<double> closing_error;

    friend bool operator==(const ManifestLoop&, const ManifestLoop&) = default;
};

/// What numbers mean that any program has to know of; the same for the whole set.
struct ManifestConventions {
    std::string rows = "top to bottom";
    std::string normal_y = "up";  // or "down"
    std::string motion_unit;      // of an EXR: "image widths" or "pixels"
    std::string motion_y = "up";
    double motion_multiplier = 0.0;  // image widths that the ends of a PNG's codes stand for

    friend bool operator==(const ManifestConventions&, const ManifestConventions&) = default;
};

/// Images that belong together: the maps and frames of one preset with one choice of its keys.
struct BakedSet {
    std::string version;  // of foamtex
    std::string preset;   // its name
    std::string description;
    std::string toml;        // the preset in full
    std::string parameters;  // a hash of all that decides files but image.maps and the frames
    std::uint64_t seed = 0;
    int width = 0;
    int height = 0;
    int frames_per_second = 0;
    ManifestLoop loop;
    ManifestConventions conventions;
    std::vector<ManifestMap> maps;
    std::vector<ManifestFile> files;  // by frame, then in the order of the maps
    std::vector<ManifestFrame> foam;  // by frame
    std::string failure;              // why a bake ended before its last frame

    /// Whether every map has a file of every frame that was asked for.
    bool complete() const;

    /// Of all maps, in increasing order.
    std::vector<int> frames() const;

    /// nullptr where there is none.
    const ManifestMap* find_map(std::string_view name) const;
    const ManifestFile* find_file(std::string_view map, int frame) const;
    const ManifestFrame* find_frame(int frame) const;

    friend bool operator==(const BakedSet&, const BakedSet&) = default;
};

/// What a folder holds of bakes.
struct Manifest {
    std::vector<BakedSet> sets;

    friend bool operator==(const Manifest&, const Manifest&) = default;
};

/// The set of the same parameters and version, or nullptr.
BakedSet* find_same_set(Manifest& manifest, const BakedSet& set);
const BakedSet* find_same_set(const Manifest& manifest, const BakedSet& set);

/// Adds what a bake has written to what its folder holds: to the set of the same parameters, of
/// which files and frames of the same name are replaced, or as a set of its own. Files that other
/// sets had under these names are theirs no more; a set without files goes.
void merge(Manifest& manifest, const BakedSet& set);

/// Takes files out of all sets, as a bake is about to write them anew.
void remove_files(Manifest& manifest, const std::vector<std::string>& paths);

}  // namespace foam::texgen
