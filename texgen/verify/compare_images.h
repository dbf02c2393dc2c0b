// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "texgen/image/comparison.h"
#include "texgen/image/difference_limits.h"
#include "texgen/verify/image_pairs.h"

#include <filesystem>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace foam::texgen {

/// The options of compare_pair.
struct CompareOptions {
    /// Returns the limits of a map, whose name is empty if it is not known. This function must not
    /// be empty (null).
    std::function<CompareLimits(std::string_view map)> limits_of = [](std::string_view) {
        return CompareLimits{};
    };
    /// The map that all images show. If it is empty, the name of the layer, the manifest or the
    /// metadata of an image tell which map the image shows.
    std::string map{};
    /// The file for a picture of the differences (difference_picture); only for a single pair.
    std::optional<std::filesystem::path> difference{};
};

/// The comparison of two images, or of one layer of two images.
struct ComparedImage {
    ImagePair pair;       // `map` below is used instead of pair.map
    std::string map{};    // empty if it is not known
    std::string layer{};  // empty if the images have no layers
    /// Verdict::Failure if ImagePair::presence is not Both; Verdict::Unreadable if an image could
    /// not be read.
    Verdict verdict = Verdict::Same;
    Comparison found{};   // has its defaults unless both images were read and have the same layout
    std::string error{};  // the reason why an image is unreadable, with the name of the image
};

/// Compares the images of a pair, layer by layer. Throws OutputError if the picture of the
/// differences cannot be written, and std::bad_alloc if memory is exhausted.
std::vector<ComparedImage> compare_pair(const ImagePair& pair, const CompareOptions& options);

/// Returns the worst of the verdicts, in the order of the enumeration; Verdict::Same if there are
/// none.
Verdict worst_verdict(std::span<const ComparedImage> images);

}  // namespace foam::texgen
