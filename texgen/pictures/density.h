// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "core/foam/area_field.h"
#include "texgen/keys/key.h"
#include "texgen/pictures/picture_file.h"

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace foam::texgen {

/// The source of the density: "even", "gradient", "radial", "noise", or the path of a picture.
struct DensitySource {
    std::string name = "even";
    PictureFile picture{};  // the picture, if `name` is a path
};

/// The treatment of the edges of a picture on a torus, where each edge meets the opposite one.
enum class PictureEdges {
    Keep,    // the picture is not changed
    Mirror,  // the picture and three mirror images of it; each of the four covers a quarter of the
             // torus
    Blend,   // opposite edges are adjusted to their mean; the adjustment fades out inward
};

/// The density of bubbles: how the sizes of the seeded bubbles depend on position. A picture is
/// stretched over the torus, or over the bounding box of the outline of a patch.
struct DensityOptions {
    DensitySource source{};
    double ratio = 30.0;       // largest divided by smallest bubble area
    bool is_inverted = false;  // false: bubbles are small in dark places; true: in light places
    PictureEdges edges = PictureEdges::Keep;
    double noise_scale = 3.0;  // number of features of the noise along the foam's shorter side
    std::int64_t noise_seed = 1;
};

Keys<DensityOptions> density_keys();

/// The rectangle of a foam, over which a density is stretched.
struct DensityDomain {
    bool is_torus = true;
    double aspect = 1.0;  // width / height
};

/// Returns the field of bubble areas of a density, or nullopt if the source is "even". The darkness
/// of a picture is 1 minus the luminance (luminance_of) of its colors on white. The darkness of the
/// whole rectangle is first stretched to the range from 0 to 1. The area a is then chosen such that
/// 1 / sqrt(a) is linear in the darkness. The area is 1 at the darkest point and `options.ratio` at
/// the lightest one, or the reverse if `options.is_inverted` is true.
///
/// If films have a constant width, the fraction of the area that they cover is everywhere
/// proportional to 1 / sqrt(a). A foam of dark films on a light ground therefore has the tones of
/// the picture.
std::optional<AreaField> area_field_of(const DensityOptions& options, const DensityDomain& domain);

/// Returns remarks on the picture of a density. There is a remark if the picture is stretched by
/// more than 2 % in one direction relative to the other direction. On a torus with
/// PictureEdges::Keep, there is also a remark if the picture does not tile.
std::vector<std::string> density_remarks(const DensityOptions& options,
                                         const DensityDomain& domain);

}  // namespace foam::texgen
