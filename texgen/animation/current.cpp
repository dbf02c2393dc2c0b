// SPDX-License-Identifier: Apache-2.0

#include "texgen/animation/current.h"

#include "core/foam/random.h"
#include "core/geometry/elementary.h"
#include "core/parallel/kernel_array.h"
#include "core/parallel/simd_level.h"
#include "texgen/animation/displaced_frame.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <span>

// The velocity is a sum of waves with random directions and phases, as in R. H. Kraichnan,
// "Diffusion by a random velocity field" (1970). It is derived from a stream function, so that it
// has no divergence; computer graphics calls such fields curl noise (R. Bridson, J. Hourihan and M.
// Nordenstam, "Curl-noise for procedural fluid flow", 2007). Points move along this field because a
// displacement that is simply proportional to a field without divergence would change areas, and
// could fold the plane. The paths are integrated by the classical Runge-Kutta method of order 4 (J.
// C. Butcher, "Numerical Methods for Ordinary Differential Equations"). Waves that travel by whole
// wavelengths, so that loops close, are our own.

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

// The coordinates of points, or the components of vectors. The points move together, so that the
// loops over them are vectorized.
struct PointGroup {
    static constexpr std::size_t kSize = 32;

    KernelArray<double, kSize> x;
    KernelArray<double, kSize> y;
};

// Returns a + factor * b.
[[gnu::always_inline]] inline PointGroup sum(const PointGroup& a,
                                             double factor,
                                             const PointGroup& b) {
    PointGroup sums;
    for (std::size_t k = 0; k < PointGroup::kSize; ++k) {
        sums.x[k] = a.x[k] + factor * b.x[k];
        sums.y[k] = a.y[k] + factor * b.y[k];
    }
    return sums;
}

[[gnu::always_inline]] inline PointGroup velocity(std::span<const VelocityWave> waves,
                                                  const PointGroup& points) {
    PointGroup velocities;
    for (const VelocityWave& wave : waves) {
        for (std::size_t k = 0; k < PointGroup::kSize; ++k) {
            const double angle =
                wave.vector.x() * points.x[k] + wave.vector.y() * points.y[k] + wave.phase;
            const double cosine = ieee::sincos_of_moderate(angle).cosine;
            velocities.x[k] += cosine * wave.amplitude.x();
            velocities.y[k] += cosine * wave.amplitude.y();
        }
    }
    return velocities;
}

// Moves points with the velocity for one unit of time, by the Runge-Kutta method of order 4.
void move(std::span<const VelocityWave> waves, PointGroup& points) {
    at_simd_level([waves, &points] {
        constexpr double kStep = 1.0 / kPathSteps;
        PointGroup moved = points;
        for (int step = 0; step < kPathSteps; ++step) {
            const PointGroup first = velocity(waves, moved);
            const PointGroup second = velocity(waves, sum(moved, 0.5 * kStep, first));
            const PointGroup third = velocity(waves, sum(moved, 0.5 * kStep, second));
            const PointGroup fourth = velocity(waves, sum(moved, kStep, third));
            const PointGroup all = sum(sum(sum(first, 2.0, second), 2.0, third), 1.0, fourth);
            moved = sum(moved, kStep / 6.0, all);
        }
        points = moved;
    });
}

// Replaces each point by the displacement that it undergoes when it moves with the velocity for one
// unit of time.
void replace_by_displacements(std::span<const VelocityWave> waves, std::span<Vec2> points) {
    for (std::size_t begin = 0; begin < points.size(); begin += PointGroup::kSize) {
        const auto batch =
            points.subspan(begin, std::min(PointGroup::kSize, points.size() - begin));
        PointGroup group;
        for (std::size_t k = 0; k < batch.size(); ++k) {
            group.x[k] = batch[k].x();
            group.y[k] = batch[k].y();
        }
        move(waves, group);
        for (std::size_t k = 0; k < batch.size(); ++k) {
            batch[k] = Vec2(group.x[k], group.y[k]) - batch[k];
        }
    }
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
    Vec2 displacement = point;
    replace_by_displacements(waves_at(progress, waves_, directions_, strength_, domain),
                             std::span(&displacement, 1));
    return displacement;
}

Frame Current::carried(const Frame& frame, double progress) const {
    const Network& network = frame.network;
    const std::vector<VelocityWave> waves =
        waves_at(progress, waves_, directions_, strength_, frame.domain);
    // Both lists contain points of the frame until replace_by_displacements has been called.
    Indexed<JunctionId, Vec2> junction_displacements;
    for (const JunctionId junction : network.junctions()) {
        junction_displacements.push_back(frame.positions[junction]);
    }
    Indexed<FilmId, Vec2> middle_displacements;
    for (const FilmId film : network.films()) {
        middle_displacements.push_back(frame.positions[network.tail(forward_side(film))] +
                                       point_at(frame.arcs[film], 0.5));
    }
    replace_by_displacements(waves, {junction_displacements.begin(), junction_displacements.end()});
    replace_by_displacements(waves, {middle_displacements.begin(), middle_displacements.end()});
    return displaced(frame, junction_displacements, middle_displacements);
}

}  // namespace foam::texgen
