// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace foam::texgen {

/// Which image of a pair exists.
enum class Presence { Both, OnlyA, OnlyB };

/// Two images to compare: `a` is the reference, `b` the new image. The path of a missing image is
/// the path at which it was expected.
struct ImagePair {
    std::filesystem::path a;
    std::filesystem::path b;
    Presence presence = Presence::Both;
    std::string map{};           // the only map of the images, by their manifest; else empty
    std::optional<int> frame{};  // by a pattern or a manifest
};

/// Returns the pairs of images to compare. `a` and `b` are of the same kind:
///
///     image files      one pair
///     file patterns    one pair per frame number (FilePattern, without {preset} and {map}); a name
///                      of an existing file is not a pattern
///     folders          one pair per path of an image relative to the folder, in all subfolders;
///                      maps and frames are those of the manifests of the folders, if they have one
///     manifests        one pair per file that at least one of the manifests lists, by path
///
/// With `frames`, `a` and `b` are names or patterns, and the pairs are those of these frames,
/// whether files exist or not. Otherwise pairs are in the order of frame numbers or paths, and
/// contain every image that exists (or is listed) on at least one side.
///
/// Throws std::invalid_argument if `a` and `b` are of different kinds or a pattern is malformed,
/// and InputError if a name of another kind does not exist, a manifest is unreadable or there is no
/// image on either side.
std::vector<ImagePair> image_pairs(const std::string& a,
                                   const std::string& b,
                                   const std::optional<std::string>& frames);

}  // namespace foam::texgen
