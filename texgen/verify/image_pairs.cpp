// SPDX-License-Identifier: Apache-2.0

#include "texgen/verify/image_pairs.h"

#include "core/files/file_io.h"
#include "texgen/bake/existing_sequence.h"
#include "texgen/bake/frame_range.h"
#include "texgen/image/format.h"
#include "texgen/manifest/manifest_file.h"

#include <fmt/core.h>

#include <iterator>
#include <map>
#include <stdexcept>

namespace foam::texgen {

namespace {

namespace fs = std::filesystem;

// The two inputs that are compared, A and B, are called sides. A SideImage contains what is known
// about one image of a side.
struct SideImage {
    std::string map{};  // empty if unknown, or if the file contains several maps
    std::optional<int> frame{};
};

using SideImages = std::map<std::string, SideImage>;

// All images of one side, by their paths relative to the folder of the side.
struct Side {
    fs::path folder;
    SideImages images;
};

enum class Kind { File, Pattern, Folder, Manifest };

Kind kind_of(const std::string& name) {
    if (fs::is_directory(name)) {
        return Kind::Folder;
    }
    if (name.ends_with(".json")) {
        return Kind::Manifest;
    }
    const bool may_be_pattern = name.find_first_of("#@%") != std::string::npos;
    return may_be_pattern && !fs::exists(name) ? Kind::Pattern : Kind::File;
}

const char* name_of(Kind kind) {
    switch (kind) {
        case Kind::File:
            return "an image";
        case Kind::Pattern:
            return "a file name pattern";
        case Kind::Folder:
            return "a folder";
        default:
            return "a manifest";
    }
}

// Throws InputError if a name that is not a pattern does not exist.
void check_exists(const std::string& name, const std::string& a, const std::string& b) {
    if (kind_of(name) != Kind::Pattern && !fs::exists(name)) {
        throw InputError(
            fmt::format("cannot compare '{}' with '{}': '{}' does not exist", a, b, name));
    }
}

// Returns the common kind of A and B. If their kinds differ, throws InputError if one of them does
// not exist (check_exists), otherwise std::invalid_argument.
Kind common_kind(const std::string& a, const std::string& b) {
    const Kind kind = kind_of(a);
    const Kind other = kind_of(b);
    if (kind != other) {
        check_exists(a, a, b);
        check_exists(b, a, b);
        throw std::invalid_argument(
            fmt::format("cannot compare {} ('{}') with {} ('{}'); A and B must both be images, "
                        "patterns, folders or manifests",
                        name_of(kind),
                        a,
                        name_of(other),
                        b));
    }
    return kind;
}

FilePattern parse_pattern(const std::string& text) {
    if (text.find('{') != std::string::npos) {
        throw std::invalid_argument(fmt::format(
            "file name pattern '{}': must contain a frame number, but no placeholder in braces; "
            "compare folders to compare several maps",
            text));
    }
    return FilePattern(text);
}

std::vector<ImagePair> pairs_of_range(const std::string& a,
                                      const std::string& b,
                                      const std::string& range) {
    const std::vector<int> frames = parse_frame_range(range);
    const FilePattern left = parse_pattern(a);
    const FilePattern right = parse_pattern(b);
    left.check_distinct(frames.size(), 1);
    right.check_distinct(frames.size(), 1);
    std::vector<ImagePair> pairs;
    pairs.reserve(frames.size());
    for (const int frame : frames) {
        pairs.push_back({left.path({}, frame), right.path({}, frame)});
        pairs.back().frame = frame;
    }
    return pairs;
}

// Calls add(key, presence) for each key of two std::maps, in increasing order. `presence` tells
// which of them contain the key.
template <class Map, class Add>
void visit_keys(const Map& a, const Map& b, const Add& add) {
    auto left = a.begin();
    auto right = b.begin();
    while (left != a.end() || right != b.end()) {
        const bool in_a = right == b.end() || (left != a.end() && left->first <= right->first);
        const bool in_b = left == a.end() || (right != b.end() && right->first <= left->first);
        add(in_a ? left->first : right->first,
            in_a && in_b ? Presence::Both : (in_a ? Presence::OnlyA : Presence::OnlyB));
        left = in_a ? std::next(left) : left;
        right = in_b ? std::next(right) : right;
    }
}

std::vector<ImagePair> pairs_of_patterns(const std::string& a, const std::string& b) {
    const FilePattern left = parse_pattern(a);
    const FilePattern right = parse_pattern(b);
    std::vector<ImagePair> pairs;
    visit_keys(
        existing_sequence(left), existing_sequence(right), [&](int frame, Presence presence) {
            pairs.push_back({left.path({}, frame), right.path({}, frame), presence, "", frame});
        });
    return pairs;
}

// Returns the images that a manifest lists. Vector files are left out.
SideImages images_in(const Manifest& manifest) {
    SideImages images;
    for (const BakedSet& set : manifest.sets) {
        for (const ManifestFile& file : set.files) {
            if (find_format(file.path) != nullptr) {
                images[file.path] = {file.maps.size() == 1 ? file.maps.front() : "", file.frame};
            }
        }
    }
    return images;
}

// Returns what is known about the image with the given path.
SideImage known_of(const SideImages& images, const std::string& path) {
    const auto found = images.find(path);
    return found != images.end() ? found->second : SideImage{};
}

Side side_of_manifest(const std::string& file) {
    return {fs::path(file).parent_path(), images_in(read_manifest(file))};
}

Side side_of_folder(const std::string& name) {
    Side side{name, {}};
    const SideImages listed = images_in(manifest_in(name));
    for (const auto& entry : fs::recursive_directory_iterator(name)) {
        if (entry.is_directory() || find_format(entry.path().string()) == nullptr) {
            continue;
        }
        const std::string path = entry.path().lexically_relative(name).generic_string();
        side.images[path] = known_of(listed, path);
    }
    return side;
}

std::vector<ImagePair> pairs_of_sides(const Side& a, const Side& b) {
    std::vector<ImagePair> pairs;
    visit_keys(a.images, b.images, [&](const std::string& path, Presence presence) {
        const SideImage left = known_of(a.images, path);
        const SideImage right = known_of(b.images, path);
        pairs.push_back({a.folder / path,
                         b.folder / path,
                         presence,
                         left.map.empty() ? right.map : left.map,
                         left.frame ? left.frame : right.frame});
    });
    return pairs;
}

std::vector<ImagePair> pairs_of_kind(Kind kind, const std::string& a, const std::string& b) {
    switch (kind) {
        case Kind::File:
            return {{a, b}};
        case Kind::Pattern:
            return pairs_of_patterns(a, b);
        case Kind::Folder:
            return pairs_of_sides(side_of_folder(a), side_of_folder(b));
        default:
            return pairs_of_sides(side_of_manifest(a), side_of_manifest(b));
    }
}

}  // namespace

std::vector<ImagePair> image_pairs(const std::string& a,
                                   const std::string& b,
                                   const std::optional<std::string>& frames) {
    if (frames) {
        return pairs_of_range(a, b, *frames);
    }
    std::vector<ImagePair> pairs = pairs_of_kind(common_kind(a, b), a, b);
    if (pairs.empty()) {
        throw InputError(
            fmt::format("cannot compare '{}' with '{}': neither contains an image", a, b));
    }
    return pairs;
}

}  // namespace foam::texgen
