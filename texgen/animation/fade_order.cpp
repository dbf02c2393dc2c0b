// SPDX-License-Identifier: Apache-2.0

#include "texgen/animation/fade_order.h"

#include "core/geometry/elementary.h"
#include "texgen/animation/displaced_frame.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace foam::texgen {

namespace {

// Ranks are computed from a tileable random field: a sum of plane waves with whole numbers of
// periods across the tile. Such a sum is nearly normally distributed. The cumulative distribution
// function of the normal distribution therefore converts it to ranks that are spread almost evenly
// over [0, 1]. The logistic function approximates this function with an error below 0.01.

constexpr int kOrderWaves = 24;
// The steepness for which the logistic function is closest to the cumulative distribution function
// of the standard normal distribution.
constexpr double kLogisticSteepness = 1.702;
constexpr double kBubblesInWave = 6.0;  // typical wavelength / sqrt(mean bubble area)

double sum_of(const std::vector<PeriodicWave>& waves, const Vec2& fractions) {
    double sum = 0.0;
    for (const PeriodicWave& wave : waves) {
        const double turns = wave.across * fractions.x() + wave.up * fractions.y();
        sum += ieee::cos(2.0 * std::numbers::pi * turns + wave.phase);
    }
    return sum;
}

}  // namespace

FadeOrder::FadeOrder(const Options& options)
    : spread_(options.spread),
      waves_(periodic_waves(
          {.count = kOrderWaves,
           .number = std::sqrt(options.bubbles * std::min(options.aspect, 1.0 / options.aspect)) /
                     kBubblesInWave,
           .variation = 0.5,
           .aspect = options.aspect,
           .seed = options.seed})) {}

std::vector<double> FadeOrder::ranks(const Frame& frame, const Vec2& displacement) const {
    // Each wave has a mean square of 1/2, so the standard deviation of the sum of all waves is
    // sqrt(kOrderWaves / 2).
    const double steepness = kLogisticSteepness / std::sqrt(0.5 * kOrderWaves);
    std::vector<double> ranks;
    for (const BubbleId bubble : frame.network.bubbles()) {
        const Vec2 center = mean_corner(frame, bubble) - displacement;
        const double sum =
            sum_of(waves_, {center.x() / frame.domain.width, center.y() / frame.domain.height});
        ranks.push_back(1.0 / (1.0 + ieee::exp(-steepness * sum)));
    }
    return ranks;
}

double FadeOrder::growth(double rank, double passed) const {
    return std::clamp((passed - spread_ * rank) / (1.0 - spread_), 0.0, 1.0);
}

}  // namespace foam::texgen
