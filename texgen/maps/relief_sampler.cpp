// SPDX-License-Identifier: Apache-2.0

#include "texgen/maps/relief_sampler.h"

#include "core/parallel/simd_level.h"
#include "texgen/raster/simd/kernel.h"

#include <cmath>

namespace foam::texgen {

// Within a pixel, the smooth distance to the films (Relief::distance) is taken as a quadratic
// function of the position. The relief is computed from this distance by the formulas of the
// relief's cross-section (ReliefSection). The second derivatives of the distance are differences of
// the gradients of neighboring pixels. For each derivative there are two such differences, to the
// neighbors on both sides. The one of smaller magnitude is used, or 0 if they have opposite signs
// (the minmod limiter; P. L. Roe, "Characteristic-based schemes for the Euler equations", 1986).
// Differences across a film, where the gradient is reversed, are large and are therefore not used.
//
// A relief is locally symmetric about a film. If a film lies between the center of the pixel and a
// point, the relief is therefore computed at the point's mirror image in the film. The slope is
// then mirrored back.
//
// The slope of the grain at the center of a pixel is used for all points of the pixel.

namespace {

// Some terms are divided by the square of the slope of the smooth distance. A square below this
// number is replaced by it. The slope is 1 on films, and smaller only where no film is near.
constexpr float kSmallestSquare = 0.05F;

float minmod(float a, float b) {
    if (a * b <= 0.0F) {
        return 0.0F;
    }
    return std::abs(a) < std::abs(b) ? a : b;
}

}  // namespace

ReliefSampler::ReliefSampler(const Relief& relief,
                             const PixelSlopes& slopes,
                             const SkyLookup& sky,
                             const PixelNeighbors& neighbors)
    : relief_(relief), slopes_(slopes), sky_(sky), neighbors_(neighbors) {}

void ReliefSampler::Pixels::resize(std::size_t count) {
    for (std::vector<float>* const numbers :
         {&unit, &distance, &x, &y, &xx, &xy, &yy, &grain_x, &grain_y}) {
        numbers->resize(count);
    }
}

void ReliefSampler::choose(std::span<const std::uint32_t> pixels) {
    chosen_.resize(pixels.size());
    for (std::size_t k = 0; k < pixels.size(); ++k) {
        set_distance(k, pixels[k]);
        set_grain(k, pixels[k]);
    }
}

void ReliefSampler::set_distance(std::size_t k, std::size_t pixel) {
    const std::span<const float> gradient = relief_.gradient().samples();
    const auto change = [&](std::size_t axis, std::size_t before, std::size_t after) {
        const float middle = gradient[2 * pixel + axis];
        return minmod(middle - gradient[2 * before + axis], gradient[2 * after + axis] - middle);
    };
    const std::size_t below = neighbors_.below(pixel);
    const std::size_t above = neighbors_.above(pixel);
    chosen_.unit[k] = static_cast<float>(relief_.unit(pixel));
    chosen_.distance[k] = relief_.distance().samples()[pixel];
    chosen_.x[k] = gradient[2 * pixel];
    chosen_.y[k] = gradient[2 * pixel + 1];
    chosen_.xx[k] = change(0, neighbors_.left(pixel), neighbors_.right(pixel));
    chosen_.xy[k] = change(0, below, above);
    chosen_.yy[k] = change(1, below, above);
}

// Sets the slope of the grain. It is the slope of the whole relief at the center of the pixel,
// minus the slope of the relief without grain. The latter slope follows from the smooth distance by
// the relief's cross-section.
void ReliefSampler::set_grain(std::size_t k, std::size_t pixel) {
    if (!relief_.has_grain()) {
        chosen_.grain_x[k] = 0.0F;
        chosen_.grain_y[k] = 0.0F;
        return;
    }
    const double unit = relief_.unit(pixel);
    const double smooth = static_cast<double>(relief_.distance().samples()[pixel]) / unit;
    const double slope = unit > 0.0 ? relief_.strength() * relief_.section().slope(smooth) : 0.0;
    const auto grain_slope = [&](const Image<float>& whole, float gradient) {
        return whole.samples()[pixel] - static_cast<float>(slope * static_cast<double>(gradient));
    };
    chosen_.grain_x[k] = grain_slope(slopes_.x, chosen_.x[k]);
    chosen_.grain_y[k] = grain_slope(slopes_.y, chosen_.y[k]);
}

void ReliefSampler::write(const Vec2& offset, const ReliefPoints<float>& to) const {
    relief_.section().visit([&](const auto& section) {
        at_simd_level([section,
                       sky = sky_,
                       strength = relief_.strength(),
                       count = chosen_.x.size(),
                       unit = chosen_.unit.data(),
                       distance = chosen_.distance.data(),
                       gradient_x = chosen_.x.data(),
                       gradient_y = chosen_.y.data(),
                       xx = chosen_.xx.data(),
                       xy = chosen_.xy.data(),
                       yy = chosen_.yy.data(),
                       grain_x = chosen_.grain_x.data(),
                       grain_y = chosen_.grain_y.data(),
                       right = static_cast<float>(offset.x()),
                       up = static_cast<float>(offset.y()),
                       slopes_x = to.slopes_x.data(),
                       slopes_y = to.slopes_y.data(),
                       visible = to.sky.data()] {
            FOAM_INDEPENDENT_ITERATIONS
            for (std::size_t k = 0; k < count; ++k) {
                const float x = gradient_x[k];
                const float y = gradient_y[k];
                const float square = max_value(x * x + y * y, kSmallestSquare);
                // The point is beyond the film if this factor is positive. Its mirror image is at
                // the offset plus the factor times the gradient.
                const float beyond =
                    max_value(-2.0F * (distance[k] + x * right + y * up) / square, 0.0F);
                const float at_x = right + beyond * x;
                const float at_y = up + beyond * y;
                const float bend_x = xx[k] * at_x + xy[k] * at_y;
                const float bend_y = xy[k] * at_x + yy[k] * at_y;
                const float smooth =
                    distance[k] + (x + 0.5F * bend_x) * at_x + (y + 0.5F * bend_y) * at_y;
                const float across = 2.0F * ((x + bend_x) * x + (y + bend_y) * y) / square;
                const float turned = beyond > 0.0F ? across : 0.0F;
                const auto in_units = static_cast<double>(max_value(smooth, 0.0F) / unit[k]);
                const auto slope = static_cast<float>(strength * section.slope(in_units));
                const bool has_relief = unit[k] > 0.0F;
                const float factor = has_relief ? slope : 0.0F;
                slopes_x[k] = factor * (x + bend_x - turned * x) + grain_x[k];
                slopes_y[k] = factor * (y + bend_y - turned * y) + grain_y[k];
                const auto fraction = static_cast<float>(sky.at(section.distance(in_units)));
                visible[k] = has_relief ? fraction : 1.0F;
            }
        });
    });
}

}  // namespace foam::texgen
