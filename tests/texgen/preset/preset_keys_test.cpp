// SPDX-License-Identifier: Apache-2.0

#include "texgen/preset/preset_keys.h"

#include "tests/texgen/keys/limits.h"
#include "texgen/maps/all_maps.h"
#include "texgen/preset/assignment.h"

#include <fmt/core.h>
#include <gtest/gtest.h>

#include <set>
#include <string>
#include <utility>
#include <vector>

namespace foam::texgen {
namespace {

bool accepts(const std::string& path, const std::string& value) {
    Preset preset;
    return find_key(path)->read(read_value(value), preset);
}

TEST(PresetKeys, EveryKeyIsListedOnceWithItsTexts) {
    std::set<std::string_view> paths;
    for (const Key<Preset>& key : preset_keys()) {
        EXPECT_TRUE(paths.insert(key.path).second) << key.path;
        EXPECT_FALSE(key.allowed.empty()) << key.path;
        EXPECT_FALSE(key.meaning.empty()) << key.path;
        EXPECT_TRUE(is_table(key.table())) << key.path;
        EXPECT_EQ(find_key(key.path), &key);
    }
}

TEST(PresetKeys, EveryDefaultIsAllowed) {
    const Preset defaults;
    for (const Key<Preset>& key : preset_keys()) {
        Preset preset;
        EXPECT_TRUE(key.read(*key.write(defaults), preset)) << key.path;
        EXPECT_EQ(key.write(defaults), key.default_value) << key.path;
    }
}

TEST(PresetKeys, NoKeyTakesADateOrATable) {
    for (const Key<Preset>& key : preset_keys()) {
        Preset preset;
        EXPECT_FALSE(key.read({Value::Opaque{"2020-01-02"}}, preset)) << key.path;
        EXPECT_FALSE(key.read({Value::Table{}}, preset)) << key.path;
        EXPECT_FALSE(key.read({true}, preset)) << key.path;
    }
}

TEST(PresetKeys, LimitsHoldOnBothSides) {
    test::expect_limits(preset_keys(),
                        {{"foam.bubbles", "3", "4", "1000000", "1000001"},
                         {"foam.seed", "-1", "0", "9223372036854775807", "9223372036854775808"},
                         {"foam.lloyd", "-1", "0", "1000", "1001"},
                         {"foam.area_ratio", "0.99", "1", "100", "100.1"},
                         {"foam.surface_tension", "0", "1e-6", "1e3", "1001"},
                         {"foam.outline_aspect", "0.06", "0.0625", "16", "16.1"},
                         {"foam.tolerance", "0.9e-9", "1e-9", "0.01", "0.011"},
                         {"dynamics.kappa", "-0.1", "0", "1000", "1001"},
                         {"dynamics.t1_distance", "0.0009", "0.001", "0.25", "0.26"},
                         {"dynamics.t2_area", "0.00009", "0.0001", "0.25", "0.26"}});
}

TEST(PresetKeys, RealsAreFiniteAndAcceptIntegersButNotViceVersa) {
    EXPECT_TRUE(accepts("dynamics.kappa", "1"));
    EXPECT_FALSE(accepts("foam.bubbles", "100.0"));
    EXPECT_FALSE(accepts("dynamics.kappa", "nan"));
    EXPECT_FALSE(accepts("albedo.pressure_high", "inf"));
    EXPECT_FALSE(accepts("dynamics.kappa", "\"1\""));
    EXPECT_TRUE(accepts("foam.area_ratio", "0"));  // 0 stands for no ratio
}

TEST(PresetKeys, WordsAreTheOnesListed) {
    EXPECT_TRUE(accepts("albedo.colormap", "labyrinth_blue"));
    EXPECT_FALSE(accepts("albedo.colormap", "jet"));
    EXPECT_TRUE(accepts("albedo.film_color", "#00ff7F"));
    EXPECT_FALSE(accepts("albedo.film_color", "white"));
    EXPECT_TRUE(accepts("image.maps", "albedo"));
    EXPECT_TRUE(accepts("image.maps", "[\"albedo\"]"));
    EXPECT_FALSE(accepts("image.maps", "[\"albedo\", \"albedo\"]"));
    EXPECT_FALSE(accepts("image.maps", "[]"));
    EXPECT_FALSE(accepts("output.pattern", "\"\""));
    EXPECT_TRUE(accepts("preset.description", "\"\""));
}

TEST(PresetKeys, ChoicesReachTheirMembers) {
    Preset preset;
    EXPECT_TRUE(find_key("albedo.pressure_unit")->read(read_value("seed"), preset));
    EXPECT_TRUE(find_key("albedo.film_unit")->read(read_value("diameter"), preset));
    EXPECT_EQ(preset.maps.albedo.pressure_unit, PressureUnit::Seed);
    EXPECT_EQ(preset.maps.albedo.film_unit, WidthUnit::Diameters);
    EXPECT_FALSE(find_key("albedo.film_unit")->read(read_value("mm"), preset));
}

TEST(PresetKeys, AnOutlineIsAWordOrAPolygon) {
    EXPECT_TRUE(accepts("foam.outline", "disc"));
    EXPECT_TRUE(accepts("foam.outline", "rectangle"));
    EXPECT_TRUE(accepts("foam.outline", "POLYGON((0 0, 1 0, 1 1))"));
    EXPECT_TRUE(accepts("foam.outline", "POLYGON((0 0, 4 0, 4 4, 0 4), (1 1, 1 2, 2 2, 2 1))"));
    EXPECT_FALSE(accepts("foam.outline", "circle"));
    EXPECT_FALSE(accepts("foam.outline", "POLYGON((0 0, 1 1, 1 0, 0 1))"));  // crosses itself
    EXPECT_FALSE(accepts("foam.outline", "POLYGON((0 0, 1 0, 2 0))"));
    EXPECT_FALSE(accepts("foam.outline", "POLYGON((0 0, 1e200 0, 1e200 1e200))"));
    EXPECT_FALSE(accepts("foam.outline", "POLYGON EMPTY"));
    EXPECT_FALSE(accepts("foam.outline", "\"\""));
}

TEST(PresetKeys, EverySolverHasItsWord) {
    const Key<Preset>* key = find_key("foam.solver");
    EXPECT_EQ(key->allowed, R"(one of "newton", "gauss-seidel", "gauss-seidel-colored")");
    Preset preset;
    for (const auto& [word, solver] :
         {std::pair("gauss-seidel", Solver::GaussSeidel),
          std::pair("gauss-seidel-colored", Solver::ColoredGaussSeidel),
          std::pair("newton", Solver::Newton)}) {
        EXPECT_TRUE(key->read(read_value(word), preset));
        EXPECT_EQ(preset.equilibrium.solver, solver);
        EXPECT_EQ(to_toml(*key->write(preset)), fmt::format("\"{}\"", word));
    }
    EXPECT_FALSE(accepts("foam.solver", "jacobi"));
}

// A preset may set a number, and a preset that extends it, "auto". The result must be the same as
// if no number had been set, since both are written as the same TOML.
TEST(PresetKeys, TheWordAutoRemovesANumber) {
    int tested = 0;
    for (const Map& map : all_maps()) {
        Preset preset;
        const AutoReal* const full = range_option_of(map, preset.maps);
        EXPECT_EQ(full != nullptr, !map.full_key.empty()) << map.name;  // find_full in all_maps.cpp
        if (full != nullptr) {
            const Key<Preset>* const key = find_key(map.full_key);
            const AutoReal automatic = *full;
            EXPECT_TRUE(key->read(read_value("2.5"), preset));
            EXPECT_EQ(*full, AutoReal{2.5});
            EXPECT_TRUE(key->read(read_value("auto"), preset));
            EXPECT_EQ(*full, automatic) << map.full_key;
            ++tested;
        }
    }
    EXPECT_GE(tested, 7);
}

TEST(PresetKeys, ARejectedValueChangesNothing) {
    Preset preset;
    EXPECT_FALSE(find_key("image.size")->read(read_value("[7, 0]"), preset));
    EXPECT_EQ(preset.image.width, ImageOptions{}.width);
}

}  // namespace
}  // namespace foam::texgen
