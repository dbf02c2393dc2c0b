// SPDX-License-Identifier: Apache-2.0

#include "texgen/animation/current.h"

#include "core/foam/random.h"
#include "core/geometry/elementary.h"
#include "texgen/animation/displaced_frame.h"

#include <cmath>
#include <numbers>

namespace foam::texgen {

namespace {

constexpr int kCurrentWaves = 6;
constexpr int kPathSteps = 8;  // steps of the Runge-Kutta method along a path

// A wave of the velocity field at one moment. Its velocity at a point is
// amplitude * cos(dot(vector, point) + phase).
struct VelocityWave {
    Vec2 amplitude;
    Vec2 vector;
    double phase;
};

Vec2 velocity(const std::vector<VelocityWave>& waves, const Vec2& point) {
    Vec2 sum = Vec2::Zero();
    for (const VelocityWave& wave : waves) {
        sum += ieee::cos(wave.vector.dot(point) + wave.phase) * wave.amplitude;
    }
    return sum;
}

// Returns the displacement of a point that moves with the velocity for one unit of time.
Vec2 displacement_in(const std::vector<VelocityWave>& waves, const Vec2& point) {
    constexpr double kStep = 1.0 / kPathSteps;
    Vec2 place = point;
    for (int step = 0; step < kPathSteps; ++step) {
        const Vec2 first = velocity(waves, place);
        const Vec2 second = velocity(waves, place + 0.5 * kStep * first);
        const Vec2 third = velocity(waves, place + 0.5 * kStep * second);
        const Vec2 fourth = velocity(waves, place + kStep * third);
        place += kStep / 6.0 * (first + 2.0 * second + 2.0 * third + fourth);
    }
    return place - point;
}

// Returns the waves of the velocity after the fraction `progress` of the loop. A wave of the stream
// function with the wave vector K contributes a velocity perpendicular to K. The amplitude of this
// velocity is proportional to 1 / |K|, so that all waves strain the foam equally. The amplitude of
// each wave's strain is strength * sqrt(2 / kCurrentWaves). Because the mean square of a cosine is
// 1/2, the root mean square of the total strain is `strength`.
std::vector<VelocityWave> waves_at(double progress,
                                   const std::vector<PeriodicWave>& waves,
                                   const std::vector<int>& directions,
                                   double strength,
                                   const Domain& domain) {
    const double strain = strength * std::sqrt(2.0 / kCurrentWaves);
    std::vector<VelocityWave> all;
    for (std::size_t k = 0; k < waves.size(); ++k) {
        const PeriodicWave& wave = waves[k];
        const Vec2 turns(wave.across / domain.width,
                         (wave.up - wave.across * domain.shear / domain.width) / domain.height);
        const Vec2 vector = 2.0 * std::numbers::pi * turns;
        all.push_back({strain / vector.squaredNorm() * Vec2(vector.y(), -vector.x()),
                       vector,
                       wave.phase + 2.0 * std::numbers::pi * directions[k] * progress});
    }
    return all;
}

}  // namespace

Current::Current(const LoopOptions& loop, double aspect, std::uint64_t seed)
    : strength_(loop.current),
      waves_(periodic_waves({.count = kCurrentWaves,
                             .number = static_cast<double>(loop.eddies),
                             .aspect = aspect,
                             .seed = seed})) {
    Random random(seed);
    for (int k = 0; k < kCurrentWaves; ++k) {
        directions_.push_back(random.uniform() < 0.5 ? 1 : -1);
    }
}

Vec2 Current::displacement(const Vec2& point, const Domain& domain, double progress) const {
    return displacement_in(waves_at(progress, waves_, directions_, strength_, domain), point);
}

Frame Current::carried(const Frame& frame, double progress) const {
    const Network& network = frame.network;
    const std::vector<VelocityWave> waves =
        waves_at(progress, waves_, directions_, strength_, frame.domain);
    Indexed<JunctionId, Vec2> of_junctions;
    for (const JunctionId junction : network.junctions()) {
        of_junctions.push_back(displacement_in(waves, frame.positions[junction]));
    }
    Indexed<FilmId, Vec2> of_middles;
    for (const FilmId film : network.films()) {
        const Vec2 middle =
            frame.positions[network.tail(forward_side(film))] + point_at(frame.arcs[film], 0.5);
        of_middles.push_back(displacement_in(waves, middle));
    }
    return displaced(frame, of_junctions, of_middles);
}

}  // namespace foam::texgen
