// SPDX-License-Identifier: Apache-2.0

#include "core/dynamics/collapse.h"
#include "core/io/evolver_file.h"
#include "core/io/foam_json.h"
#include "tests/core/foams.h"
#include "tests/core/io/small_torus.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>
#include <unistd.h>

#include <bit>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <limits>
#include <string>
#include <vector>

namespace foam {
namespace {

using test::kSmallState;

Foam read(const std::string& text) {
    return read_foam_json(text, "a.json");
}

TEST(FoamJsonWriter, WritesOneElementALine) {
    EXPECT_EQ(write_foam_json(read_evolver(test::kSmallTorus, "").foam), kSmallState);
}

TEST(FoamJsonWriter, ClosesDeadSlots) {
    Foam foam = test::honeycomb_around(3);
    TopologyCounts counts;
    ASSERT_TRUE(collapse(foam, BubbleId{5}, counts));
    const Foam again = read(write_foam_json(foam));
    compact(foam);
    EXPECT_TRUE(test::are_same(again, foam));
}

// Returns a state whose pressure, the number that has no limits, is the given number.
std::string state_with(double number) {
    Foam foam = read_evolver(test::kSmallTorus, "").foam;
    foam.pressures[BubbleId{0}] = number;
    return write_foam_json(foam);
}

// Numbers whose shortest form has one digit and an exponent, and other numbers at the limits.
std::vector<double> special_numbers() {
    using Limits = std::numeric_limits<double>;
    std::vector<double> numbers{0.0, -0.0, 1.0, 1e22, Limits::max(), Limits::min()};
    numbers.insert(numbers.end(), {Limits::denorm_min(), Limits::epsilon(), 0.1, 1.0 / 3.0});
    for (int exponent = -323; exponent <= 308; ++exponent) {
        numbers.push_back(std::strtod(("1e" + std::to_string(exponent)).c_str(), nullptr));
        numbers.push_back(-(2.0 / 3.0) * numbers.back());
    }
    return numbers;
}

void expect_same_bits(double number) {
    const double again = read(state_with(number)).pressures[BubbleId{0}];
    EXPECT_EQ(std::bit_cast<std::uint64_t>(again), std::bit_cast<std::uint64_t>(number)) << number;
}

TEST(FoamJsonWriter, KeepsTheBitsOfSpecialNumbers) {
    for (const double number : special_numbers()) {
        expect_same_bits(number);
    }
}

RC_GTEST_PROP(FoamJsonWriter, KeepsTheBitsOfAnyNumber, (std::uint64_t bits)) {
    const auto number = std::bit_cast<double>(bits);
    RC_PRE(std::isfinite(number));
    expect_same_bits(number);
}

// Every length, area and tension is a small power of ten, as in SI units.
TEST(FoamJsonWriter, KeepsAFoamInSiUnits) {
    Foam foam = read_evolver(test::kSmallTorus, "").foam;
    constexpr double kScale = 1e-5;
    foam.domain = {3.0 * kScale, 2.0 * kScale};
    foam.film_tension = 1e-5;
    foam.target_areas[BubbleId{0}] = foam.domain.area();
    for (const JunctionId junction : foam.network.junctions()) {
        foam.positions[junction] *= kScale;
    }
    EXPECT_TRUE(test::are_same(read(write_foam_json(foam)), foam));
}

// Python's reader, which is independent of ours, must get the same bits.
TEST(FoamJsonWriter, WritesWhatOtherProgramsRead) {
    const std::vector<double> numbers = special_numbers();
    const std::filesystem::path folder =
        std::filesystem::temp_directory_path() / ("foam_json_" + std::to_string(getpid()));
    std::filesystem::create_directory(folder);
    std::ofstream states(folder / "states.json");
    std::ofstream bits(folder / "bits.txt");
    states << "[";
    for (std::size_t k = 0; k < numbers.size(); ++k) {
        states << (k > 0 ? "," : "") << state_with(numbers[k]);
        bits << std::bit_cast<std::uint64_t>(numbers[k]) << "\n";
    }
    states << "]";
    states.close();
    bits.close();
    const std::string script =
        "import json,struct;"
        "s=json.load(open('states.json'));"
        "b=[int(line) for line in open('bits.txt')];"
        "assert [struct.unpack('Q',struct.pack('d',x['bubbles'][0][1]))[0] for x in s]==b";
    const std::string command = "cd '" + folder.string() + "' && python3 -c \"" + script + "\"";
    EXPECT_EQ(std::system(command.c_str()), 0);  // NOLINT(cert-env33-c)
    std::filesystem::remove_all(folder);
}

}  // namespace
}  // namespace foam
