// SPDX-License-Identifier: Apache-2.0

#include "texgen/maps/fade_order.h"

#include "core/foam/random.h"
#include "core/geometry/elementary.h"
#include "core/geometry/vec2.h"
#include "core/parallel/simd_level.h"
#include "texgen/maps/smooth_step.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <span>
#include <vector>

namespace foam::texgen {

namespace {

// The order is a tileable random field. It is the sum of plane waves with random directions and
// phases, each with a whole number of periods across the tile, so that the field is periodic. Such
// a sum is nearly normally distributed. The cumulative distribution function of the normal
// distribution therefore converts the sum to ranks that are spread almost evenly over [0, 1]. It is
// approximated by the logistic function, whose error is below 0.01. A pixel of rank t begins to
// fade after the fraction `spread` * t of the cross-fade, and its fade lasts for the fraction 1 -
// `spread` of the cross-fade.

constexpr int kWaves = 24;
// The steepness for which the logistic function is closest to the cumulative distribution function
// of the standard normal distribution.
constexpr double kLogisticSteepness = 1.702;
constexpr double kBubblesInWave = 4.0;  // typical wavelength, in square roots of the mean area

// A plane wave with whole numbers of periods across the tile in x and y.
struct Wave {
    int across = 0;
    int up = 0;
    double phase = 0.0;  // radians
};

std::vector<Wave> random_waves(const FadeOrder::Options& options) {
    Random random(options.seed);
    const double aspect = std::sqrt(static_cast<double>(options.width) / options.height);
    const double mean = std::sqrt(options.bubbles) / kBubblesInWave;  // waves across a square tile
    std::vector<Wave> waves;
    for (int k = 0; k < kWaves; ++k) {
        const double direction = 2.0 * std::numbers::pi * random.uniform();
        const Vec2 toward = mean * (0.5 + random.uniform()) * unit_vector(direction);
        Wave wave{static_cast<int>(std::lround(aspect * toward.x())),
                  static_cast<int>(std::lround(toward.y() / aspect)),
                  2.0 * std::numbers::pi * random.uniform()};
        if (wave.across == 0 && wave.up == 0) {
            (options.width >= options.height ? wave.across : wave.up) = 1;
        }
        waves.push_back(wave);
    }
    return waves;
}

// Adds cos(2 pi (across x + up y) + phase) to the sum at the center of every pixel; x and y are in
// fractions of the tile.
void add(const Wave& wave, Image<float>& sum) {
    const auto angle = [](int times, int index, int count) {
        return 2.0 * std::numbers::pi * times * (index + 0.5) / count;
    };
    std::vector<float> cosines;
    std::vector<float> sines;
    for (int x = 0; x < sum.width(); ++x) {
        const double at = angle(wave.across, x, sum.width()) + wave.phase;
        const auto [sine, cosine] = ieee::sincos(at);
        cosines.push_back(static_cast<float>(cosine));
        sines.push_back(static_cast<float>(sine));
    }
    for (int y = 0; y < sum.height(); ++y) {
        const double at = angle(wave.up, y, sum.height());
        const Vec2 turn = unit_vector(at);
        const auto cosine = static_cast<float>(turn.x());
        const auto sine = static_cast<float>(turn.y());
        const auto row = sum.row(y);
        for (std::size_t x = 0; x < row.size(); ++x) {
            row[x] += cosine * cosines[x] - sine * sines[x];
        }
    }
}

}  // namespace

FadeOrder::FadeOrder(const Options& options)
    : spread_(options.spread), ranks_(options.width, options.height, 1) {
    for (const Wave& wave : random_waves(options)) {
        add(wave, ranks_);
    }
    // Each wave has a mean square of 1/2, so the standard deviation of the sum is sqrt(kWaves / 2).
    const double steepness = kLogisticSteepness / std::sqrt(0.5 * kWaves);
    const std::span<float> ranks = ranks_.samples();
    at_simd_level([ranks, steepness] {
        for (std::size_t k = 0; k < ranks.size(); ++k) {
            ranks[k] = static_cast<float>(1.0 / (1.0 + ieee::exp(-steepness * ranks[k])));
        }
    });
}

Image<float> FadeOrder::weights(double passed) const {
    // The fade of a pixel of rank t has progressed by (passed - spread * t) / (1 - spread).
    const auto begun = static_cast<float>(passed / (1.0 - spread_));
    const auto later = static_cast<float>(spread_ / (1.0 - spread_));
    Image<float> weights(ranks_.width(), ranks_.height(), 1);
    const auto ranks = ranks_.samples();
    const auto to = weights.samples();
    for (std::size_t k = 0; k < to.size(); ++k) {
        to[k] = smooth_step(std::clamp(begun - later * ranks[k], 0.0F, 1.0F));
    }
    return weights;
}

}  // namespace foam::texgen
