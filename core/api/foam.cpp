// SPDX-License-Identifier: Apache-2.0

#include "core/dynamics/displacement.h"
#include "core/dynamics/shear.h"
#include "core/dynamics/shear_modulus.h"
#include "core/dynamics/step.h"
#include "core/equilibrium/equilibrate_given.h"
#include "core/foam/measure.h"
#include "core/foam/patch.h"
#include "core/foam/seeding.h"
#include "core/foam/stress.h"
#include "core/io/foam_file.h"
#include "core/io/foam_json.h"
#include "core/library/foam_records.h"
#include "core/library/require.h"
#include "core/library/with_public_errors.h"

#include <fmt/core.h>
#include <foamtex/foam.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <stdexcept>
#include <string>
#include <string_view>
#include <utility>

namespace foamtex {

struct Foam::State {
    foam::Foam foam;
};

namespace {

using foam::require;
using foam::require_from;
using foam::require_threads;

// The largest strain of one call. A larger strain would take too many substeps.
constexpr double kMaxStrain = 100.0;
// The largest displacement of a push along x and along y, in radii of the push. A larger
// displacement would take too many small steps.
constexpr double kMaxPush = 1000.0;
constexpr int kMaxBubbles = 10'000'000;
constexpr int kMaxLloydIterations = 1000;
constexpr double kMaxAreaRatio = 1e6;

void require_positive(std::string_view name, double number) {
    require(std::isfinite(number) && number > 0.0, name, "a positive number", number);
}

void require_not_negative(std::string_view name, double number) {
    require(std::isfinite(number) && number >= 0.0, name, "finite and at least 0", number);
}

void check(const StepSettings& settings) {
    require_not_negative("kappa", settings.kappa);
    require_positive("tolerance", settings.tolerance);
    require_positive("t1_distance", settings.t1_distance);
    require_positive("t2_area", settings.t2_area);
}

foam::StepOptions options_of(const StepSettings& settings) {
    foam::StepOptions options;
    options.coarsening.kappa = settings.kappa;
    options.equilibrium.tolerance = settings.tolerance;
    options.equilibrium.thresholds = {settings.t1_distance, settings.t2_area};
    options.equilibrium.threads = settings.threads;
    return options;
}

foam::Vec2 vector_of(const Point& point) {
    return {point.x, point.y};
}

std::string text_of(const Point& point) {
    return fmt::format("({}, {})", point.x, point.y);
}

void check(const SeedOptions& options) {
    require(options.bubbles <= kMaxBubbles, "bubbles", "at most 10 million", options.bubbles);
    require_from("aspect", options.aspect, 1.0 / foam::kMaxAspect, foam::kMaxAspect);
    require_from("lloyd_iterations", options.lloyd_iterations, 0, kMaxLloydIterations);
    require(options.area_ratio == 0.0 ||
                (options.area_ratio >= 1.0 && options.area_ratio <= kMaxAreaRatio),
            "area_ratio",
            "0 or from 1 to 1e6",
            options.area_ratio);
    require_positive("surface_tension", options.surface_tension);
}

// Returns the push as a Displacement. Throws ArgumentError if a value is not allowed.
foam::Displacement push_of(const Push& push, const foam::Domain& domain) {
    require_positive("radius", push.radius);
    const double largest = 0.5 * std::min(domain.width, domain.height);
    require(domain.is_plane() || push.radius <= largest,
            "radius",
            fmt::format("at most {} (half of the shorter side of the torus)", largest),
            push.radius);
    const foam::Vec2 center = vector_of(push.center);
    require(center.allFinite(), "center", "finite", text_of(push.center));
    const foam::Vec2 by = vector_of(push.by);
    const double limit = kMaxPush * push.radius;
    require((by.array().abs() <= limit).all(),
            "by",
            fmt::format("at most {} (1000 radii) along x and y", limit),
            text_of(push.by));
    return {center, push.radius, by};
}

// Returns the drive as a StateChange. Throws ArgumentError if a value is not allowed.
foam::StateChange change_of(const Drive& drive, const foam::Domain& domain) {
    require_from("strain", drive.strain, -kMaxStrain, kMaxStrain);
    require(drive.strain == 0.0 || !domain.is_plane(),
            "strain",
            "0 for a patch, since only a torus can be sheared",
            drive.strain);
    foam::StateChange change{.strain = drive.strain};
    for (const DrivenArea& driven : drive.areas) {
        require_positive("target_area", driven.target_area);
        if (driven.identity < 0 ||
            driven.identity > std::numeric_limits<foam::BubbleIdentity>::max()) {
            continue;  // no bubble has such an identity
        }
        change.driven.push_back({.bubble = static_cast<foam::BubbleIdentity>(driven.identity),
                                 .target_area = driven.target_area});
    }
    for (const Push& push : drive.pushes) {
        change.pushes.push_back(push_of(push, domain));
    }
    return change;
}

Equilibrium result_of(const foam::EquilibriumSummary& summary) {
    return {.converged = summary.converged(),
            .iterations = summary.iterations,
            .t1 = summary.t1,
            .t2 = summary.t2,
            .area_error = summary.area_error,
            .angle_error = summary.angle_error};
}

// Returns the result of a step in which nothing happens.
Equilibrium present_errors(const foam::Foam& foam, double tolerance) {
    const foam::EquilibriumErrors errors = foam::equilibrium_errors(foam);
    return {.converged = errors.are_below(tolerance),
            .area_error = errors.area,
            .angle_error = errors.angle};
}

// Returns seed(). Throws ArgumentError if the options give no valid foam.
template <class Seed>
Foam seeded(const Seed& seed) {
    try {
        return foam::with_public_errors(seed);
    } catch (const Error&) {
        throw;
    } catch (const std::runtime_error& error) {
        throw ArgumentError(error.what());
    }
}

}  // namespace

Foam::Foam(std::unique_ptr<State> state) : state_(std::move(state)) {}
Foam::Foam(const Foam& other) : state_(std::make_unique<State>(*other.state_)) {}
Foam::Foam(Foam&& other) noexcept = default;
Foam& Foam::operator=(Foam&& other) noexcept = default;
Foam::~Foam() = default;

Foam& Foam::operator=(const Foam& other) {
    return *this = Foam(other);
}

Foam Foam::torus(const SeedOptions& options) {
    check(options);
    return seeded([&] {
        const foam::SeedingOptions seeding{.bubbles = options.bubbles,
                                           .aspect = options.aspect,
                                           .lloyd_iterations = options.lloyd_iterations,
                                           .area_ratio = options.area_ratio,
                                           .surface_tension = options.surface_tension,
                                           .seed = options.seed};
        return Foam(std::make_unique<State>(State{foam::seed_foam(seeding)}));
    });
}

Foam Foam::disk(const SeedOptions& options) {
    check(options);
    return seeded([&] {
        const foam::PatchOptions patch{.bubbles = options.bubbles,
                                       .lloyd_iterations = options.lloyd_iterations,
                                       .area_ratio = options.area_ratio,
                                       .surface_tension = options.surface_tension,
                                       .seed = options.seed};
        return Foam(std::make_unique<State>(State{foam::seed_patch(foam::disc_outline(), patch)}));
    });
}

Foam Foam::read(const std::string& file) {
    return foam::with_public_errors(
        [&] { return Foam(std::make_unique<State>(State{foam::load_foam(file).foam})); });
}

Foam Foam::from_state(const std::string& json) {
    return foam::with_public_errors(
        [&] { return Foam(std::make_unique<State>(State{foam::read_foam_json(json, "state")})); });
}

std::string Foam::state() const {
    return foam::write_foam_json(state_->foam);
}

void Foam::write(const std::string& file) const {
    foam::with_public_errors([&] { foam::save_foam(file, state_->foam); });
}

Equilibrium Foam::relax(int threads, const std::function<void()>& poll) {
    require_threads(threads);
    return foam::with_public_errors(
        [&] { return result_of(foam::equilibrate_given(state_->foam, threads, poll)); });
}

Equilibrium Foam::step(double time,
                       const Drive& drive,
                       const StepSettings& settings,
                       const std::function<void()>& poll) {
    require_not_negative("time", time);
    check(settings);
    require_threads(settings.threads);
    const foam::StateChange change = change_of(drive, state_->foam.domain);
    if (time == 0.0 && change.empty()) {
        return present_errors(state_->foam, settings.tolerance);
    }
    foam::StepOptions options = options_of(settings);
    options.equilibrium.on_round = poll;
    return foam::with_public_errors([&] {
        // A copy advances, because an exception of `poll` must not change the foam.
        foam::Foam next = state_->foam;
        const foam::StepSummary summary = foam::step(next, time, change, options);
        state_->foam = std::move(next);
        return result_of(summary.equilibrium);
    });
}

void Foam::shear(double strain) {
    require_from("strain", strain, -kMaxStrain, kMaxStrain);
    if (!extent().is_torus()) {
        throw ArgumentError("shear: only a torus can be sheared, but this foam is a patch");
    }
    foam::shear(state_->foam, strain);
}

double Foam::time() const {
    return state_->foam.time;
}

double Foam::film_tension() const {
    return state_->foam.film_tension;
}

Extent Foam::extent() const {
    return foam::extent_of(state_->foam.domain);
}

std::int64_t Foam::bubble_count() const {
    return static_cast<std::int64_t>(state_->foam.network.bubble_count() +
                                     state_->foam.lone_bubbles.size());
}

double Foam::energy() const {
    return foam::energy(state_->foam);
}

std::optional<double> Foam::shear_modulus(int threads) const {
    require_threads(threads);
    return foam::with_public_errors([&] { return foam::shear_modulus(state_->foam, threads); });
}

std::vector<Event> Foam::take_events() {
    return foam::event_records(std::exchange(state_->foam.events, {}));
}

Stress Foam::stress() const {
    return foam::stress_record(foam::mean_stress(foam::snapshot(state_->foam, 0)));
}

FoamRecords Foam::records() const {
    return foam::records_of(foam::snapshot(state_->foam, 0));
}

}  // namespace foamtex
