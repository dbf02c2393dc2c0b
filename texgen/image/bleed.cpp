// SPDX-License-Identifier: Apache-2.0

#include "texgen/image/bleed.h"

#include "core/parallel/simd_level.h"
#include "texgen/image/color.h"

#include <algorithm>
#include <cstddef>
#include <span>
#include <utility>
#include <vector>

// The pull-push algorithm (Gortler et al., "The Lumigraph", 1996). Pull: each coarser level has
// half the width and height of the level before, rounded up. The color of a texel is the mean color
// of up to four finer texels, weighted by opacity; its opacity is the sum of their opacities. Push:
// from the coarsest level to the finest, a texel without opacity gets the color of the coarser
// texel that contains it. The image itself is the finest level. There, a pixel without opacity gets
// the weighted mean of its eight neighbors instead, if any of them has an opacity above 0.

namespace foam::texgen {

namespace {

constexpr std::size_t kChannels = 4;

// Three components of a color, which is not premultiplied, and an opacity. The color is the mean
// color of the pixels that the texel covers, weighted by opacity. The opacity is the sum of the
// opacities of these pixels. A level is an image of such texels.
using Texel = std::array<float, kChannels>;
using ColorLevel = Image<float>;

template <class Sample>
void add_weighted(Texel& sum, const Sample* texel) {
    const auto weight = static_cast<float>(texel[3]);
    for (std::size_t c = 0; c < 3; ++c) {
        sum[c] += weight * static_cast<float>(texel[c]);
    }
    sum[3] += weight;
}

// Returns the mean for a sum that add_weighted has computed: divides its color by its opacity.
// Returns zeros if the opacity is 0.
Texel weighted_mean(const Texel& sum) {
    const bool is_clear = sum[3] == 0.0F;
    const float divisor = is_clear ? 1.0F : sum[3];  // a sum without opacity is zero
    return {sum[0] / divisor, sum[1] / divisor, sum[2] / divisor, sum[3]};
}

// Returns the mean of the texels from (left, bottom) to (right, top), weighted by opacity. Texels
// outside of the image are ignored.
template <class Sample>
Texel mean_of(ImageView<const Sample> image, int left, int bottom, int right, int top) {
    Texel sum{};
    for (int y = std::max(bottom, 0); y <= std::min(top, image.height() - 1); ++y) {
        for (int x = std::max(left, 0); x <= std::min(right, image.width() - 1); ++x) {
            add_weighted(sum, image.pixel(x, y).data());
        }
    }
    return weighted_mean(sum);
}

// Writes the means of `count` squares of 2 x 2 texels, weighted by opacity, to a row of texels.
template <class Sample>
void write_means(const Sample* lower, const Sample* upper, std::size_t count, float* to) {
    at_simd_level([=] {
        for (std::size_t k = 0; k < count; ++k) {
            Texel sum{};
            add_weighted(sum, lower + 2 * kChannels * k);
            add_weighted(sum, lower + 2 * kChannels * k + kChannels);
            add_weighted(sum, upper + 2 * kChannels * k);
            add_weighted(sum, upper + 2 * kChannels * k + kChannels);
            const Texel mean = weighted_mean(sum);
            for (std::size_t c = 0; c < kChannels; ++c) {
                to[kChannels * k + c] = mean[c];
            }
        }
    });
}

// Returns the next coarser level.
template <class Sample>
ColorLevel halved(ImageView<const Sample> finer) {
    ColorLevel level((finer.width() + 1) / 2, (finer.height() + 1) / 2, kChannels);
    const int whole = finer.height() > 1 ? finer.width() / 2 : 0;
    for (int y = 0; y < level.height(); ++y) {
        const bool has_two_rows = 2 * y + 1 < finer.height();
        if (has_two_rows) {
            write_means(finer.row(2 * y).data(),
                        finer.row(2 * y + 1).data(),
                        static_cast<std::size_t>(whole),
                        level.row(y).data());
        }
        for (int x = has_two_rows ? whole : 0; x < level.width(); ++x) {
            std::ranges::copy(mean_of(finer, 2 * x, 2 * y, 2 * x + 1, 2 * y + 1),
                              level.pixel(x, y).begin());
        }
    }
    return level;
}

// Returns all levels that are coarser than the image, from fine to coarse. The last level has one
// texel.
std::vector<ColorLevel> coarser_levels(ImageView<const std::uint16_t> image) {
    std::vector<ColorLevel> levels{halved(image)};
    while (levels.back().width() > 1 || levels.back().height() > 1) {
        levels.push_back(halved(std::as_const(levels.back()).view()));
    }
    return levels;
}

// Gives every texel without opacity the color of the coarser texel that contains it.
void bleed_into(ColorLevel& level, const ColorLevel& coarser) {
    for (int y = 0; y < level.height(); ++y) {
        for (int x = 0; x < level.width(); ++x) {
            const auto texel = level.pixel(x, y);
            if (texel[3] == 0.0F) {
                std::ranges::copy(coarser.pixel(x / 2, y / 2).first(3), texel.begin());
            }
        }
    }
}

// Returns true if the coarser texels that cover a pixel and its eight neighbors have no opacity. In
// this case the mean of these pixels would have no opacity, either, and need not be computed.
bool is_clear_around(const ColorLevel& coarser, int x, int y) {
    const int right = std::min((x + 1) / 2, coarser.width() - 1);
    const int above = std::min((y + 1) / 2, coarser.height() - 1);
    const int left = std::max(x - 1, 0) / 2;
    const int below = std::max(y - 1, 0) / 2;
    const auto is_clear = [&](int i, int j) { return coarser.pixel(i, j)[3] == 0.0F; };
    return is_clear(left, below) && is_clear(right, below) && is_clear(left, above) &&
           is_clear(right, above);
}

// Gives every pixel without opacity the mean color of its neighbors, or else the color of the
// coarser texel that contains it.
void bleed_into(ImageView<std::uint16_t> image, const ColorLevel& coarser) {
    for (int y = 0; y < image.height(); ++y) {
        for (int x = 0; x < image.width(); ++x) {
            const auto pixel = image.pixel(x, y);
            if (pixel[3] != 0) {
                continue;
            }
            const Texel neighbors = is_clear_around(coarser, x, y)
                                        ? Texel{}
                                        : mean_of<std::uint16_t>(image, x - 1, y - 1, x + 1, y + 1);
            const auto from = neighbors[3] > 0.0F ? std::span<const float>(neighbors)
                                                  : coarser.pixel(x / 2, y / 2);
            for (std::size_t c = 0; c < 3; ++c) {
                pixel[c] = nearest_sample(from[c]);
            }
        }
    }
}

}  // namespace

void bleed_colors(ImageView<std::uint16_t> image, const std::array<std::uint16_t, 3>& fallback) {
    std::vector<ColorLevel> levels = coarser_levels(image);
    const auto last = levels.back().pixel(0, 0);
    if (last[3] == 0.0F) {
        std::ranges::copy(fallback, last.begin());
    }
    for (std::size_t k = levels.size() - 1; k > 0; --k) {
        bleed_into(levels[k - 1], levels[k]);
    }
    bleed_into(image, levels.front());
}

}  // namespace foam::texgen
