// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "texgen/bake/written_file.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace foam::texgen {

/// The version of the manifest format. It increases only if an older reader would misread a newer
/// file.
inline constexpr int kManifestVersion = 1;
/// The value of the member "format" of every manifest.
inline constexpr std::string_view kManifestFormat = "foamtex-manifest";

/// The value of the member "kind" of an item of the list "maps" in a manifest, if the item is a
/// drawing, table or mesh.
inline constexpr std::string_view kVectorKind = "vector";

/// An item of the list BakedSet::maps: a map, a packed image (maps/packing.h), or a drawing, table
/// or mesh, which is stored in vector files (vector/format.h).
struct ManifestMap {
    std::string name;
    std::string meaning;
    std::string unit;         // unit of the values, and the meaning of the samples of a PNG
    std::string note;         // DrawnImage::note, such as the direction of y; may be empty
    std::vector<int> frames;  // requested frames, in increasing order
    std::optional<MapSamples> samples;  // nullopt until the first file of the map is written
    // The content of each channel of a packed image, such as "1-roughness"; empty for a map.
    std::vector<std::string> packed{};
    // The format of vector files, such as "SVG"; empty for images.
    std::string vector_format{};

    friend bool operator==(const ManifestMap&, const ManifestMap&) = default;
};

/// An item of the list BakedSet::files: a file that a bake has written.
struct ManifestFile {
    std::string path;               // relative to the folder of the manifest, with '/'
    std::vector<std::string> maps;  // one map, or the maps that are layers of an EXR
    int frame = 0;
    std::uint64_t bytes = 0;  // size of the file
    // pixel_hash of the picture in the file, or text_hash of a vector file.
    std::string pixels;
    // WrittenFile::numbers; also nullopt in manifests that older versions of foamtex wrote.
    std::optional<NumberExtent> numbers{};
    // WrittenFile::displacement; also nullopt in manifests that older versions of foamtex wrote.
    std::optional<double> displacement{};

    friend bool operator==(const ManifestFile&, const ManifestFile&) = default;
};

/// One scene file, which describes the material that the images of a set make
/// (material/scene_files.h).
struct ManifestScene {
    std::string path;         // relative to the folder of the manifest, with '/'
    std::string format;       // a word of output.scene, such as "usda"
    std::uint64_t bytes = 0;  // size of the file
    std::string hash;         // text_hash of the content of the file

    friend bool operator==(const ManifestScene&, const ManifestScene&) = default;
};

/// The mechanical state of the foam in a frame, in foam units (FrameEffort in
/// animation/simulated_frame.h).
struct FrameMechanics {
    double strain = 0.0;             // since the foam was seeded
    double energy = 0.0;             // film tension times total length of the films
    std::array<double, 3> stress{};  // xx, xy, yy (E11 in core/EQUATIONS.md)

    friend bool operator==(const FrameMechanics&, const FrameMechanics&) = default;
};

/// Statistics of the foam in a frame, in foam units, and the time spent on the frame. T1s, T2s and
/// `simulating` cover the same steps as FrameEffort (animation/simulated_frame.h): usually the
/// steps since the previous frame of the bake or, for the first frame, since the start of the
/// simulation.
struct FrameStatistics {
    int frame = 0;
    bool tiles = false;  // true if the images of the frame tile in both directions
    double time = 0.0;   // foam time
    int bubbles = 0;
    double mean_area = 0.0;
    std::int64_t t1 = 0;  // number of T1s
    std::int64_t t2 = 0;  // number of T2s
    // The largest |A / A_target - 1|, and the largest deviation from 120 degrees, in radians. A
    // manifest stores infinity and NaN as null; null is read as NaN.
    double area_error = 0.0;
    double angle_error = 0.0;
    double simulating = 0.0;  // wall time, seconds
    double drawing = 0.0;     // wall time of drawing, encoding, writing and measuring, seconds
    // nullopt in manifests that older versions of foamtex wrote.
    std::optional<FrameMechanics> mechanics{};
    // The JSON object that measurements_json (bake/measurements.h) returned; empty if there is
    // none.
    std::string measurements{};

    friend bool operator==(const FrameStatistics&, const FrameStatistics&) = default;
};

/// The loop of an animation: how the last frame leads back to the first frame.
struct ManifestLoop {
    std::string kind;         // value of the key loop.kind
    std::string description;  // description of the kind, for users
    int period = 0;           // frames; 0 without a loop
    bool cross_faded = false;
    // The distance between the foam at the start and at the end of the last cycle before frame 1,
    // in mean bubble diameters (closing_error in core/dynamics/cycle.h). Only loops of the kinds
    // breathe, shear and boil have such a distance. It is nullopt if no cycle was simulated before
    // frame 1. An infinite distance becomes nullopt when a manifest is written and read again.
    std::optional<double> closing_error;

    friend bool operator==(const ManifestLoop&, const ManifestLoop&) = default;
};

/// Conventions that a program needs to interpret the images. They are the same for all images of a
/// set.
struct ManifestConventions {
    std::string rows = "top to bottom";  // order of the rows in a file
    std::string normal_y = "up";         // direction of positive y in normals: "up" or "down"
    std::string motion_unit;             // unit of motion in an EXR: "image widths" or "pixels"
    std::string motion_y = "up";     // direction of positive y in motion vectors: "up" or "down"
    double motion_multiplier = 0.0;  // motion that the largest PNG code represents, in image widths

    friend bool operator==(const ManifestConventions&, const ManifestConventions&) = default;
};

/// A set of images: maps and frames of one preset. All bakes of a set have the same version of
/// foamtex, and the same content of the files that keys name (files_of in preset/preset_keys.h).
/// They also have the same values of all keys except image.maps, output.scene and
/// output.measurements.
struct BakedSet {
    std::string version;  // version of foamtex
    std::string preset;   // name of the preset
    std::string description;
    std::string toml;  // all keys of the preset as TOML
    // A hash of `version`, the name of the preset, the content of the files that keys name, and all
    // keys except image.maps, output.scene and output.measurements.
    std::string parameters;
    std::uint64_t seed = 0;
    int width = 0;
    int height = 0;
    int frames_per_second = 0;
    ManifestLoop loop;
    ManifestConventions conventions;
    std::vector<ManifestMap> maps;
    // In a Manifest, sorted by frame, then in the order of `maps`.
    std::vector<ManifestFile> files;
    std::vector<FrameStatistics> frame_statistics;  // in a Manifest, sorted by frame
    // The reason why the last bake ended early; empty if it did not end early, or if complete().
    std::string failure;
    std::vector<ManifestScene> scenes{};
    // kAlgorithmVersion (preset/algorithm_version.h) of the program that baked the set; 0 in
    // manifests of older programs, which did not record it.
    int algorithm_version = 0;

    /// Returns true if every map has a file of each of its requested frames.
    bool complete() const;

    /// Returns all frames that are requested for any map, in increasing order.
    std::vector<int> frames() const;

    /// Return the map, the file of a frame of a map, or the statistics of a frame; nullptr if there
    /// is none.
    const ManifestMap* find_map(std::string_view name) const;
    const ManifestFile* find_file(std::string_view map, int frame) const;
    const FrameStatistics* find_frame(int frame) const;

    friend bool operator==(const BakedSet&, const BakedSet&) = default;
};

/// The manifest of a folder: all sets of images in it. The newest set, which the latest call of
/// `merge` has added or changed, is at the end.
struct Manifest {
    std::vector<BakedSet> sets;

    friend bool operator==(const Manifest&, const Manifest&) = default;
};

/// Returns the set of the manifest with the same parameters as `set`, or nullptr if there is none.
BakedSet* find_same_set(Manifest& manifest, const BakedSet& set);
const BakedSet* find_same_set(const Manifest& manifest, const BakedSet& set);

/// Merges the set of a bake into a manifest. First, every file of the manifest that has the same
/// path as a file of `set` is removed from the manifest. If the manifest has no set with the same
/// parameters, `set` is then appended. Otherwise `set` is merged into the set with the same
/// parameters:
/// - The maps, files and frame statistics of `set` are added.
/// - New statistics of a frame replace its old statistics. Old measurements stay if there are no
///   new ones.
/// - The members `toml` and `loop` are replaced. The old closing error stays if `set` has none.
/// - The member `failure` is replaced, or becomes empty if the merged set is complete.
/// - The old scene files stay.
/// - The note of a map is replaced if a file of the map has been written, that is, if the map has
///   ManifestMap::samples in `set`.
/// - The conventions are replaced if a file of the map `motion` has been written.
/// In either case, the set becomes the last one of the manifest. Other sets that have no files left
/// are removed.
void merge(Manifest& manifest, const BakedSet& set);

/// A set, and the number of its files that a bake of another set replaces.
struct ReplacedFiles {
    const BakedSet* set = nullptr;  // refers to an element of Manifest::sets
    std::size_t count = 0;          // number of files
};

/// Adds scene files to the set with the given parameters. Scene files with the same paths are first
/// removed from all sets. Does nothing if no set has the parameters.
void add_scenes(Manifest& manifest,
                std::string_view parameters,
                const std::vector<ManifestScene>& scenes);

/// Returns how many of the files with the given paths belong to each set whose parameters differ
/// from `parameters`. Sets without such files are left out.
std::vector<ReplacedFiles> replaced_files(const Manifest& manifest,
                                          std::string_view parameters,
                                          const std::vector<std::string>& paths);

/// Removes the files with the given paths, relative to the folder of the manifest, from all sets.
/// This is done before a bake overwrites the files.
void remove_files(Manifest& manifest, const std::vector<std::string>& paths);

}  // namespace foam::texgen
