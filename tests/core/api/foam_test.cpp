// SPDX-License-Identifier: Apache-2.0

#include "tests/support/temporary_folder.h"

#include <foamtex/foam.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <string>

namespace foamtex {
namespace {

Foam relaxed(int bubbles, std::uint64_t seed) {
    Foam foam = Foam::torus({.bubbles = bubbles, .seed = seed});
    EXPECT_TRUE(foam.relax().converged);
    return foam;
}

TEST(LibraryFoam, ReachesEquilibriumAndCoarsens) {
    Foam foam = relaxed(50, 1);
    EXPECT_EQ(foam.bubble_count(), 50);
    EXPECT_TRUE(foam.extent().is_torus());
    const double before = foam.energy();
    const Equilibrium found = foam.step(0.2, {}, {.kappa = 0.1});
    EXPECT_TRUE(found.converged);
    EXPECT_LT(found.area_error, 1e-9);
    EXPECT_EQ(foam.time(), 0.2);
    EXPECT_LT(foam.energy(), before);  // gas flows to where it has less pressure
}

TEST(LibraryFoam, IsAValue) {
    const Foam foam = relaxed(30, 2);
    Foam copy = foam;
    ASSERT_TRUE(copy.step(0.5).converged);
    EXPECT_EQ(foam.time(), 0.0);
    Foam other = Foam::disk({.bubbles = 5});
    other = copy;
    EXPECT_EQ(other.state(), copy.state());
    const Foam moved = std::move(copy);
    EXPECT_EQ(moved.time(), 0.5);
}

// An exception of `poll` ends the work, and changes nothing.
TEST(LibraryFoam, CanBeInterrupted) {
    struct Stop {};
    const auto stop_at = [](int call) {
        return [calls = 0, call]() mutable {
            if (++calls == call) {
                throw Stop();
            }
        };
    };
    Foam foam = Foam::torus({.bubbles = 200, .seed = 6});
    const std::string seeded = foam.state();
    EXPECT_THROW(foam.relax(1, stop_at(1)), Stop);
    EXPECT_TRUE(foam.state() == seeded);
    ASSERT_TRUE(foam.relax(1).converged);
    const std::string before = foam.state();
    const std::size_t events = Foam(foam).take_events().size();
    EXPECT_THROW(foam.step(200.0, {}, {}, stop_at(3)), Stop);
    EXPECT_TRUE(foam.state() == before);
    EXPECT_EQ(foam.take_events().size(), events);
}

TEST(LibraryFoam, KeepsEveryBitInFiles) {
    const foam::TemporaryFolder folder;
    const std::string file = (folder.path() / "a.json").string();
    Foam foam = relaxed(30, 3);
    foam.write(file);
    Foam read = Foam::read(file);
    Foam of_state = Foam::from_state(foam.state());
    for (Foam* const one : {&foam, &read, &of_state}) {
        ASSERT_TRUE(one->step(0.3).converged);
    }
    EXPECT_EQ(foam.state(), read.state());
    EXPECT_EQ(foam.state(), of_state.state());
}

TEST(LibraryFoam, IsDrivenFromOutside) {
    Foam foam = relaxed(40, 4);
    const std::int64_t identity = foam.records().bubbles[5].identity;
    ASSERT_TRUE(foam.step(0.0, {.areas = {{identity, 2.0}}, .strain = 0.1}).converged);
    EXPECT_NEAR(foam.extent().shear, 0.1 * foam.extent().height, 1e-12);
    for (const Bubble& bubble : foam.records().bubbles) {
        if (bubble.identity == identity) {
            EXPECT_NEAR(bubble.area, 2.0, 1e-8);
        }
    }
    EXPECT_GT(foam.stress().xy, 0.0);  // the foam resists
    const std::string before = foam.state();
    ASSERT_TRUE(foam.step(0.0).converged);  // nothing happens
    EXPECT_EQ(foam.state(), before);
}

TEST(LibraryFoam, RejectsBadArguments) {
    constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
    Foam foam = relaxed(20, 5);
    const std::string before = foam.state();
    EXPECT_THROW(Foam::torus({.bubbles = -3}), ArgumentError);
    EXPECT_THROW(Foam::torus({.bubbles = 1}), ArgumentError);
    EXPECT_THROW(Foam::disk({.bubbles = 0}), ArgumentError);
    EXPECT_THROW(foam.step(kNaN), ArgumentError);
    EXPECT_THROW(foam.step(1.0, {}, {.kappa = -1.0}), ArgumentError);
    EXPECT_THROW(foam.step(1.0, {}, {.threads = -1}), ArgumentError);
    EXPECT_THROW(foam.step(1.0, {.areas = {{0, 0.0}}}), ArgumentError);
    EXPECT_THROW(foam.step(1.0, {.pushes = {{{0.0, 0.0}, 100.0, {1.0, 0.0}}}}), ArgumentError);
    EXPECT_THROW(foam.relax(-1), ArgumentError);
    EXPECT_THROW(Foam::disk({.bubbles = 9}).shear(0.1), ArgumentError);
    EXPECT_EQ(foam.state(), before);
}

template <class Call>
std::string fault_of(const Call& call) {
    try {
        call();
        return "none";
    } catch (const ArgumentError& error) {
        return error.what();
    }
}

// The largest radius is half of the side of a torus of 16 bubbles, whose area is 16.
TEST(LibraryFoam, GivesTheValueInErrors) {
    Foam torus = Foam::torus({.bubbles = 16});
    Foam disk = Foam::disk({.bubbles = 9});
    EXPECT_EQ(fault_of([&] { torus.step(-1.0); }),
              "time: must be finite and at least 0, but is -1");
    EXPECT_EQ(fault_of([&] { torus.step(0.0, {}, {.tolerance = 0.0}); }),
              "tolerance: must be a positive number, but is 0");
    EXPECT_EQ(fault_of([&] { torus.relax(257); }), "threads: must be from 0 to 256, but is 257");
    EXPECT_EQ(fault_of([&] { torus.shear(-200.0); }),
              "strain: must be from -100 to 100, but is -200");
    EXPECT_EQ(fault_of([&] { disk.step(0.0, {.strain = 0.1}); }),
              "strain: must be 0 for a patch, since only a torus can be sheared, but is 0.1");
    EXPECT_EQ(fault_of([&] { disk.shear(0.1); }),
              "shear: only a torus can be sheared, but this foam is a patch");
    EXPECT_EQ(fault_of([] { Foam::torus({.area_ratio = 0.5}); }),
              "area_ratio: must be 0 or from 1 to 1e6, but is 0.5");
    const auto fault_of_push = [&](const Push& push) {
        return fault_of([&] { torus.step(0.0, {.pushes = {push}}); });
    };
    constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
    EXPECT_EQ(fault_of_push({{0.0, 0.0}, 3.0, {1.0, 0.0}}),
              "radius: must be at most 2 (half of the shorter side of the torus), but is 3");
    EXPECT_EQ(fault_of_push({{kNaN, 0.0}, 1.0, {1.0, 0.0}}),
              "center: must be finite, but is (nan, 0)");
    for (const Point& by : {Point{0.0, -3000.0}, Point{kNaN, 0.0}}) {
        const std::string fault = fault_of_push({{0.0, 0.0}, 2.0, by});
        EXPECT_TRUE(
            fault.starts_with("by: must be at most 2000 (1000 radii) along x and y, but is ("))
            << fault;
    }
}

TEST(LibraryFoam, NamesFilesInErrors) {
    const foam::TemporaryFolder folder;
    try {
        Foam::read((folder.path() / "missing.fe").string());
        FAIL();
    } catch (const InputError& error) {
        EXPECT_NE(std::string(error.what()).find("missing.fe"), std::string::npos);
    }
    EXPECT_THROW(Foam::read("a.txt"), ArgumentError);
    EXPECT_THROW(Foam::from_state("[1"), InputError);
    EXPECT_THROW(relaxed(9, 1).write((folder.path() / "no" / "a.json").string()), OutputError);
}

}  // namespace
}  // namespace foamtex
