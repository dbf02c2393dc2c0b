// SPDX-License-Identifier: Apache-2.0

#include "texgen/image/bleed.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

// The pull-push algorithm (Gortler et al., "The Lumigraph", 1996). Pull: each coarser level has
// half the width and height of the level before, rounded up. The color of a texel is the mean color
// of up to four finer texels, weighted by opacity; its opacity is the sum of their opacities. Push:
// from the coarsest level to the finest, a texel without opacity gets the color of the coarser
// texel that contains it. The image itself is the finest level. There, a pixel without opacity gets
// the weighted mean of its eight neighbors instead, if any of them has an opacity above 0.

namespace foam::texgen {

namespace {

// Three components of a color, which is not premultiplied, and an opacity. The color is the mean
// color of the pixels that the texel covers, weighted by opacity. The opacity is the sum of the
// opacities of these pixels.
using Texel = std::array<float, 4>;

struct ColorLevel {
    int width = 0;
    int height = 0;
    std::vector<Texel> texels;

    Texel& at(int x, int y) {
        return texels[static_cast<std::size_t>(y) * static_cast<std::size_t>(width) +
                      static_cast<std::size_t>(x)];
    }
};

Texel texel_of(ImageView<std::uint16_t> image, int x, int y) {
    const auto pixel = image.pixel(x, y);
    return {static_cast<float>(pixel[0]),
            static_cast<float>(pixel[1]),
            static_cast<float>(pixel[2]),
            static_cast<float>(pixel[3])};
}

void add_weighted(Texel& sum, const Texel& texel) {
    for (std::size_t c = 0; c < 3; ++c) {
        sum[c] += texel[3] * texel[c];
    }
    sum[3] += texel[3];
}

// Returns the mean for a sum that add_weighted has computed: divides its color by its opacity.
// Returns zeros if the opacity is 0.
Texel weighted_mean(const Texel& sum) {
    return sum[3] > 0.0F ? Texel{sum[0] / sum[3], sum[1] / sum[3], sum[2] / sum[3], sum[3]}
                         : Texel{};
}

// Returns the mean of up to four texels of a level, weighted by opacity. The level has the given
// width and height, and finer(i, j) returns its texel (i, j). The texel (x, y) is the lower left
// one of the four.
template <class Finer>
Texel mean_of_four(int width, int height, const Finer& finer, int x, int y) {
    Texel sum{};
    for (int j = y; j < std::min(y + 2, height); ++j) {
        for (int i = x; i < std::min(x + 2, width); ++i) {
            add_weighted(sum, finer(i, j));
        }
    }
    return weighted_mean(sum);
}

// Returns the next coarser level. The finer level has the given width and height, and finer(x, y)
// returns its texel (x, y).
template <class Finer>
ColorLevel halved(int width, int height, const Finer& finer) {
    ColorLevel level{(width + 1) / 2, (height + 1) / 2, {}};
    level.texels.reserve(static_cast<std::size_t>(level.width) *
                         static_cast<std::size_t>(level.height));
    for (int y = 0; y < height; y += 2) {
        for (int x = 0; x < width; x += 2) {
            level.texels.push_back(mean_of_four(width, height, finer, x, y));
        }
    }
    return level;
}

// Returns all levels that are coarser than the image, from fine to coarse. The last level has one
// texel.
std::vector<ColorLevel> coarser_levels(ImageView<std::uint16_t> image) {
    std::vector<ColorLevel> levels{
        halved(image.width(), image.height(), [&](int x, int y) { return texel_of(image, x, y); })};
    while (levels.back().texels.size() > 1) {
        ColorLevel& finer = levels.back();
        levels.push_back(
            halved(finer.width, finer.height, [&](int x, int y) { return finer.at(x, y); }));
    }
    return levels;
}

void take_color(Texel& texel, const Texel& from) {
    std::copy_n(from.begin(), 3, texel.begin());
}

// Gives every texel without opacity the color of the coarser texel that contains it.
void bleed_into(ColorLevel& level, ColorLevel& coarser) {
    for (int y = 0; y < level.height; ++y) {
        for (int x = 0; x < level.width; ++x) {
            Texel& texel = level.at(x, y);
            if (texel[3] == 0.0F) {
                take_color(texel, coarser.at(x / 2, y / 2));
            }
        }
    }
}

// Returns the mean of a pixel and its eight neighbors, weighted by opacity.
Texel mean_around(ImageView<std::uint16_t> image, int x, int y) {
    Texel sum{};
    for (int j = std::max(y - 1, 0); j <= std::min(y + 1, image.height() - 1); ++j) {
        for (int i = std::max(x - 1, 0); i <= std::min(x + 1, image.width() - 1); ++i) {
            add_weighted(sum, texel_of(image, i, j));
        }
    }
    return weighted_mean(sum);
}

// Returns true if the coarser texels that cover a pixel and its eight neighbors have no opacity. In
// this case mean_around would return an opacity of 0, too, and need not be called.
bool is_clear_around(ColorLevel& coarser, int x, int y) {
    const int right = std::min((x + 1) / 2, coarser.width - 1);
    const int above = std::min((y + 1) / 2, coarser.height - 1);
    const int left = std::max(x - 1, 0) / 2;
    const int below = std::max(y - 1, 0) / 2;
    return coarser.at(left, below)[3] == 0.0F && coarser.at(right, below)[3] == 0.0F &&
           coarser.at(left, above)[3] == 0.0F && coarser.at(right, above)[3] == 0.0F;
}

// Gives every pixel without opacity the mean color of its neighbors, or else the color of the
// coarser texel that contains it.
void bleed_into(ImageView<std::uint16_t> image, ColorLevel& coarser) {
    for (int y = 0; y < image.height(); ++y) {
        for (int x = 0; x < image.width(); ++x) {
            const auto pixel = image.pixel(x, y);
            if (pixel[3] != 0) {
                continue;
            }
            const Texel neighbors =
                is_clear_around(coarser, x, y) ? Texel{} : mean_around(image, x, y);
            const Texel& from = neighbors[3] > 0.0F ? neighbors : coarser.at(x / 2, y / 2);
            for (std::size_t c = 0; c < 3; ++c) {
                pixel[c] = static_cast<std::uint16_t>(std::lround(from[c]));
            }
        }
    }
}

}  // namespace

void bleed_colors(ImageView<std::uint16_t> image, const std::array<std::uint16_t, 3>& fallback) {
    std::vector<ColorLevel> levels = coarser_levels(image);
    Texel& last = levels.back().texels.front();
    if (last[3] == 0.0F) {
        std::copy(fallback.begin(), fallback.end(), last.begin());
    }
    for (std::size_t k = levels.size() - 1; k > 0; --k) {
        bleed_into(levels[k - 1], levels[k]);
    }
    bleed_into(image, levels.front());
}

}  // namespace foam::texgen
