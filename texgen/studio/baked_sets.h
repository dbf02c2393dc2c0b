// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "texgen/json/json_writer.h"
#include "texgen/studio/folder.h"
#include "texgen/studio/http_message.h"

#include <string>

namespace foam::texgen {

/// Returns the answer to /api/bakes (REQUESTS.md): the sets of images (BakedSet) of all manifests
/// that StudioFolder::bakes finds. A manifest that cannot be read, or whose folder
/// StudioFolder::below rejects, is left out.
Json describe_baked_sets(const StudioFolder& folder);

/// An image of a baked set.
struct BakedImage {
    std::string folder;  // folder of the manifest, relative to the folder of the studio
    std::string set;     // BakedSet::parameters
    std::string map;
    int frame = 1;
};

/// Returns the answer to /api/baked: an image, reduced so that its longer side has at most `side`
/// pixels. Throws PathRejected if a path is rejected (StudioFolder::below). Throws InputError if
/// the manifest or the image cannot be read or shown, or if the frame was not baked. Throws
/// std::invalid_argument if the set does not exist, if the map was not baked, or if its files are
/// vector files, which have no pixels.
HttpResponse baked_picture(const StudioFolder& folder, const BakedImage& image, int side);

/// Returns the answer to /api/baked/pick: what the file of the image contains at a point. If the
/// map is one of colors, this is the color, shown over gray where the image is transparent.
/// Otherwise, it is a list of numbers in the unit of the map. `x` and `y` are fractions of the
/// width and of the height, from the upper left. Throws the exceptions of baked_picture.
Json pick_baked(const StudioFolder& folder, const BakedImage& image, double x, double y);

}  // namespace foam::texgen
