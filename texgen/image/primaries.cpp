// SPDX-License-Identifier: Apache-2.0

#include "texgen/image/primaries.h"

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <variant>

namespace foam::texgen {

namespace {

constexpr std::size_t kSize = 3;
using ColorVector = std::array<double, kSize>;

ColorMatrix product(const ColorMatrix& a, const ColorMatrix& b) {
    ColorMatrix c{};
    for (std::size_t i = 0; i < kSize; ++i) {
        for (std::size_t j = 0; j < kSize; ++j) {
            c[i][j] = a[i][0] * b[0][j] + a[i][1] * b[1][j] + a[i][2] * b[2][j];
        }
    }
    return c;
}

ColorVector product(const ColorMatrix& a, const ColorVector& v) {
    ColorVector c{};
    for (std::size_t i = 0; i < kSize; ++i) {
        c[i] = a[i][0] * v[0] + a[i][1] * v[1] + a[i][2] * v[2];
    }
    return c;
}

// Returns the inverse by Cramer's rule: the transposed matrix of cofactors, divided by the
// determinant. The cyclic indices give each cofactor its sign.
ColorMatrix inverse(const ColorMatrix& a) {
    ColorMatrix cofactors{};
    for (std::size_t i = 0; i < kSize; ++i) {
        for (std::size_t j = 0; j < kSize; ++j) {
            const auto& next = a[(i + 1) % kSize];
            const auto& last = a[(i + 2) % kSize];
            const std::size_t k = (j + 1) % kSize;
            const std::size_t l = (j + 2) % kSize;
            cofactors[i][j] = next[k] * last[l] - next[l] * last[k];
        }
    }
    const double determinant =
        a[0][0] * cofactors[0][0] + a[0][1] * cofactors[0][1] + a[0][2] * cofactors[0][2];
    ColorMatrix result{};
    for (std::size_t i = 0; i < kSize; ++i) {
        for (std::size_t j = 0; j < kSize; ++j) {
            result[i][j] = cofactors[j][i] / determinant;
        }
    }
    return result;
}

ColorMatrix scaled_columns(ColorMatrix a, const ColorVector& scales) {
    for (auto& row : a) {
        for (std::size_t j = 0; j < kSize; ++j) {
            row[j] *= scales[j];
        }
    }
    return a;
}

// Returns the CIE XYZ coordinates of a color whose Y is 1.
ColorVector xyz_of(const Chromaticity& color) {
    return {color.x / color.y, 1.0, (1.0 - color.x - color.y) / color.y};
}

// Returns the matrix from linear RGB to CIE XYZ. Its columns are the primaries, scaled so that
// their sum is the white point.
ColorMatrix rgb_to_xyz(const Chromaticities& colors) {
    const ColorVector red = xyz_of(colors.red);
    const ColorVector green = xyz_of(colors.green);
    const ColorVector blue = xyz_of(colors.blue);
    ColorMatrix primaries{};
    for (std::size_t i = 0; i < kSize; ++i) {
        primaries[i] = {red[i], green[i], blue[i]};
    }
    return scaled_columns(primaries, product(inverse(primaries), xyz_of(colors.white)));
}

// Returns the Bradford transform of CIE XYZ from the white point `from` to the white point `to`. It
// scales the responses of three kinds of cones so that the first white becomes the second.
ColorMatrix bradford(const Chromaticity& from, const Chromaticity& to) {
    constexpr ColorMatrix kCones = {
        {{0.8951, 0.2664, -0.1614}, {-0.7502, 1.7135, 0.0367}, {0.0389, -0.0685, 1.0296}}};
    const ColorVector before = product(kCones, xyz_of(from));
    const ColorVector after = product(kCones, xyz_of(to));
    const ColorVector scales = {after[0] / before[0], after[1] / before[1], after[2] / before[2]};
    return product(scaled_columns(inverse(kCones), scales), kCones);
}

// The samples of one channel of floats.
struct Plane {
    std::span<float> samples;  // of all channels of the group, interleaved
    std::size_t first;         // index of the sample of the first pixel
    std::size_t step;          // number of samples from one pixel to the next

    float& operator[](std::size_t pixel) const { return samples[first + pixel * step]; }
};

std::optional<Plane> find_plane(Picture& picture, const std::string& name) {
    for (ChannelGroup& group : picture.groups) {
        auto* const image = std::get_if<Image<float>>(&group.samples);
        for (std::size_t k = 0; image != nullptr && k < group.names.size(); ++k) {
            if (group.names[k] == name) {
                return Plane{image->samples(), k, group.names.size()};
            }
        }
    }
    return std::nullopt;
}

}  // namespace

Chromaticities chromaticities_of(Primaries primaries) {
    if (primaries == Primaries::AcesCg) {
        return {{0.713, 0.293}, {0.165, 0.830}, {0.128, 0.044}, {0.32168, 0.33767}};
    }
    return {{0.64, 0.33}, {0.30, 0.60}, {0.15, 0.06}, {0.3127, 0.3290}};
}

ColorMatrix conversion(Primaries from, Primaries to) {
    const Chromaticities source = chromaticities_of(from);
    const Chromaticities target = chromaticities_of(to);
    return product(inverse(rgb_to_xyz(target)),
                   product(bradford(source.white, target.white), rgb_to_xyz(source)));
}

std::string_view linear_space_name(Primaries primaries) {
    return primaries == Primaries::AcesCg ? "ACEScg" : "linear sRGB";
}

void convert_colors(Picture& picture, std::string_view layer, Primaries from, Primaries to) {
    const std::string prefix = layer.empty() ? "" : std::string(layer) + '.';
    const std::optional<Plane> red = find_plane(picture, prefix + 'R');
    const std::optional<Plane> green = find_plane(picture, prefix + 'G');
    const std::optional<Plane> blue = find_plane(picture, prefix + 'B');
    if (from == to || !red || !green || !blue) {
        return;
    }
    const ColorMatrix matrix = conversion(from, to);
    const std::size_t pixels =
        static_cast<std::size_t>(picture.width()) * static_cast<std::size_t>(picture.height());
    for (std::size_t k = 0; k < pixels; ++k) {
        const ColorVector color = product(matrix, ColorVector{(*red)[k], (*green)[k], (*blue)[k]});
        (*red)[k] = static_cast<float>(color[0]);
        (*green)[k] = static_cast<float>(color[1]);
        (*blue)[k] = static_cast<float>(color[2]);
    }
}

}  // namespace foam::texgen
