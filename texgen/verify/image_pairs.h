// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace foam::texgen {

/// Tells in which of the two inputs that are compared, A and B, the image of a pair exists or, for
/// manifests, is listed. For single images and for frames of a range the value is Both, even if a
/// file does not exist.
enum class Presence { Both, OnlyA, OnlyB };

/// Two images to compare. The two inputs that are compared, A and B, are called sides. `a` is an
/// image of the side A, the reference; `b` is an image of the side B, the new one. The path of a
/// missing image is the path at which it was expected.
struct ImagePair {
    std::filesystem::path a;
    std::filesystem::path b;
    Presence presence = Presence::Both;
    std::string map{};  // from a manifest; empty if unknown or if the file contains several maps
    std::optional<int> frame{};  // from a pattern or a manifest; nullopt if it is not known
};

/// Returns the pairs of images to compare. `a` and `b` must be of the same kind:
///
///     image files      one pair
///     file patterns    one pair per frame number
///     folders          one pair per path of an image relative to the folder, in all subfolders
///     manifests        one pair per path of an image that at least one of the manifests lists
///
/// A file pattern (FilePattern) must not contain a placeholder in braces. The name of an existing
/// file is not a pattern. If a folder has a manifest, the manifest determines the map and frame of
/// each image. Vector files in folders and manifests are left out.
///
/// If `frames` is given, `a` and `b` are patterns, even if files have these names. The result then
/// has a pair for each of these frames, whether its files exist or not. Without `frames`, pairs are
/// in the order of frame numbers or paths. They contain every image that exists (or is listed) on
/// at least one side.
///
/// Throws std::invalid_argument if a pattern or `frames` is malformed, or if several frames would
/// share a file. If `a` and `b` are of different kinds, throws InputError if one of them is not a
/// pattern and does not exist, otherwise std::invalid_argument. If `a` and `b` are of the same
/// kind, an image file that does not exist is not an error here. Also throws InputError if a
/// manifest is unreadable, or if neither A nor B contains an image. Throws
/// std::filesystem::filesystem_error if a folder cannot be read.
std::vector<ImagePair> image_pairs(const std::string& a,
                                   const std::string& b,
                                   const std::optional<std::string>& frames);

}  // namespace foam::texgen
