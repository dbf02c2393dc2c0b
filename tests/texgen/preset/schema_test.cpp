#include "texgen/preset/schema.h"

#include "tests/texgen/preset/bounds.h"
#include "texgen/preset/assignment.h"

#include <fmt/core.h>
#include <gtest/gtest.h>

#include <cstddef>
#include <limits>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace foam::texgen {
namespace {

using test::Bounds;

constexpr std::size_t kKeys = 100;

bool accepts(const std::string& path, const std::string& value) {
    Preset preset;
    return find_key(path)->read(read_value(value), preset);
}

TEST(Schema, EveryKeyIsThereOnceWithAllItSays) {
    std::set<std::string_view> paths;
    for (const Key& key : preset_keys()) {
        EXPECT_TRUE(paths.insert(key.path).second) << key.path;
        EXPECT_FALSE(key.allowed.empty()) << key.path;
        EXPECT_FALSE(key.meaning.empty()) << key.path;
        EXPECT_TRUE(is_table(key.table())) << key.path;
        EXPECT_EQ(find_key(key.path), &key);
    }
    EXPECT_EQ(paths.size(), kKeys);
}

TEST(Schema, EveryDefaultIsAllowed) {
    const Preset defaults;
    for (const Key& key : preset_keys()) {
        Preset preset;
        EXPECT_TRUE(key.read(key.write(defaults), preset)) << key.path;
    }
}

TEST(Schema, NoKeyTakesADateOrATable) {
    for (const Key& key : preset_keys()) {
        Preset preset;
        EXPECT_FALSE(key.read({Value::Opaque{"2020-01-02"}}, preset)) << key.path;
        EXPECT_FALSE(key.read({Value::Table{}}, preset)) << key.path;
        EXPECT_FALSE(key.read({true}, preset)) << key.path;
    }
}

class Limits : public testing::TestWithParam<Bounds> {};

TEST_P(Limits, HoldOnBothSides) {
    const Bounds& bounds = GetParam();
    EXPECT_FALSE(accepts(bounds.key, bounds.below));
    EXPECT_TRUE(accepts(bounds.key, bounds.low));
    EXPECT_TRUE(accepts(bounds.key, bounds.high));
    EXPECT_FALSE(accepts(bounds.key, bounds.above));
}

INSTANTIATE_TEST_SUITE_P(
    Schema,
    Limits,
    testing::Values(Bounds{"foam.bubbles", "3", "4", "1000000", "1000001"},
                    Bounds{"foam.seed", "-1", "0", "9223372036854775807", "9223372036854775808"},
                    Bounds{"foam.lloyd", "-1", "0", "1000", "1001"},
                    Bounds{"foam.area_ratio", "0.99", "1", "100", "100.1"},
                    Bounds{"foam.surface_tension", "0", "1e-6", "1e3", "1001"},
                    Bounds{"foam.outline_aspect", "0.06", "0.0625", "16", "16.1"},
                    Bounds{"foam.tolerance", "0.9e-9", "1e-9", "0.01", "0.011"},
                    Bounds{"dynamics.kappa", "-0.1", "0", "1000", "1001"},
                    Bounds{"dynamics.t1_distance", "0.0009", "0.001", "0.25", "0.26"},
                    Bounds{"dynamics.t2_area", "0.00009", "0.0001", "0.25", "0.26"},
                    Bounds{"frames.count", "0", "1", "100000", "100001"},
                    Bounds{"frames.time_step", "-1", "0", "1e6", "1000001"},
                    Bounds{"frames.warm_up", "-1", "0", "1e6", "1000001"},
                    Bounds{"image.size", "[0, 4]", "[1, 1]", "[16384, 16384]", "[4, 16385]"},
                    Bounds{"loop.amplitude", "-0.1", "0", "0.9", "1"},
                    Bounds{"loop.cycles", "0", "1", "1000", "1001"},
                    Bounds{"loop.drift", "[-101, 0]", "[-100, 100]", "[100, -1]", "[0, 101]"},
                    Bounds{"camera.zoom", "0.009", "0.01", "1000", "1001"},
                    Bounds{"camera.center", "[-11, 0]", "[-10, 10]", "[10, 0.5]", "[0, 10.1]"},
                    Bounds{"camera.margin", "-0.1", "0", "0.45", "0.46"},
                    Bounds{"albedo.pressure_low", "-1e7", "-1e6", "1e6", "1e7"},
                    Bounds{"albedo.film_width", "-1", "0", "1000", "1001"},
                    Bounds{"albedo.variation", "-0.1", "0", "1", "1.1"},
                    Bounds{"albedo.shade", "-0.1", "0", "1", "1.1"},
                    Bounds{"albedo.shade_width", "0", "0.001", "10", "11"},
                    Bounds{"lit.azimuth", "-361", "-360", "360", "361"},
                    Bounds{"lit.elevation", "0.9", "1", "90", "91"},
                    Bounds{"lit.ambient", "-0.1", "0", "1", "1.1"},
                    Bounds{"lit.gloss", "-0.1", "0", "1000", "1001"},
                    Bounds{"lit.shininess", "0.9", "1", "10000", "10001"},
                    Bounds{"lit.rim", "-0.1", "0", "1000", "1001"},
                    Bounds{"lit.glow", "-0.1", "0", "1", "1.1"},
                    Bounds{"lit.samples", "0", "1", "8", "9"},
                    Bounds{"pressure.percentile", "-1", "0", "49", "50"},
                    Bounds{"pressure.exaggeration", "-1", "0", "1000", "1001"},
                    Bounds{"area.full", "0", "0.001", "1e6", "1000001"},
                    Bounds{"roughness.cell", "-0.1", "0", "1", "1.1"},
                    Bounds{"roughness.film", "-0.1", "0", "1", "1.1"},
                    Bounds{"roughness.variation", "-0.1", "0", "1", "1.1"},
                    Bounds{"age.full", "0", "1e-6", "1e9", "1e10"},
                    Bounds{"growth.full", "0", "1e-9", "1e6", "1e7"},
                    Bounds{"event_map.radius", "0", "0.01", "100", "101"},
                    Bounds{"event_map.fade", "0", "1", "100", "101"},
                    Bounds{"motion.multiplier", "0", "1e-6", "10", "11"},
                    Bounds{"distance.full", "0", "1e-6", "1e6", "1e7"},
                    Bounds{"relief.angle", "0.9", "1", "85", "86"},
                    Bounds{"relief.width", "0", "0.001", "10", "11"},
                    Bounds{"relief.strength", "-1", "0", "100", "101"},
                    Bounds{"height.full", "0", "1e-6", "1e6", "1e7"},
                    Bounds{"occlusion.strength", "-1", "0", "100", "101"},
                    Bounds{"curvature.radius", "0", "0.001", "10", "11"},
                    Bounds{"curvature.full", "0", "1e-6", "1e6", "1e7"},
                    Bounds{"thin_film.thickness", "-1", "0", "3000", "3001"},
                    Bounds{"thin_film.variation", "-1", "0", "2", "2.1"},
                    Bounds{"thin_film.drainage", "-1", "0", "10", "11"},
                    Bounds{"thin_film.exposure", "-1", "0", "100", "101"}));

TEST(Schema, EveryChoiceOfAMapHasItsWord) {
    for (const auto& [path, words] : std::vector<std::pair<std::string, std::vector<std::string>>>{
             {"pressure.scaling", {"range", "percentile", "rank"}},
             {"pressure.colormap", {"none", "magma"}},
             {"area.unit", {"seed", "current"}},
             {"age.since", {"birth", "change"}},
             {"motion.unit", {"image", "px"}},
             {"motion.y", {"up", "down"}},
             {"distance.kind", {"plain", "signed"}},
             {"distance.unit", {"foam", "px"}},
             {"albedo.color_by", {"pressure", "area", "sides", "random"}},
             {"albedo.color_mix", {"blend", "pick"}},
             {"albedo.film_profile", {"even", "wet"}},
             {"lit.colors", {"albedo", "thin_film"}},
             {"relief.profile", {"dome", "ridge", "wet"}},
             {"relief.mean_bubble", {"seed", "current"}},
             {"normal.y", {"gl", "dx"}}}) {
        for (const std::string& word : words) {
            Preset preset;
            EXPECT_TRUE(find_key(path)->read(read_value(word), preset)) << path;
            EXPECT_EQ(to_toml(find_key(path)->write(preset)), '"' + word + '"');
        }
        EXPECT_FALSE(accepts(path, "beer")) << path;
    }
}

TEST(Schema, RealsAreFiniteAndTakeIntegersButNotTheOtherWayRound) {
    EXPECT_TRUE(accepts("dynamics.kappa", "1"));
    EXPECT_FALSE(accepts("foam.bubbles", "100.0"));
    EXPECT_FALSE(accepts("dynamics.kappa", "nan"));
    EXPECT_FALSE(accepts("albedo.pressure_high", "inf"));
    EXPECT_FALSE(accepts("dynamics.kappa", "\"1\""));
    EXPECT_TRUE(accepts("foam.area_ratio", "0"));  // the value that stands for none
}

TEST(Schema, WordsAreTheOnesListed) {
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

TEST(Schema, ChoicesReachTheirMembers) {
    Preset preset;
    EXPECT_TRUE(find_key("albedo.pressure_unit")->read(read_value("seed"), preset));
    EXPECT_TRUE(find_key("albedo.film_unit")->read(read_value("diameter"), preset));
    EXPECT_EQ(preset.maps.albedo.pressure_unit, PressureUnit::Seed);
    EXPECT_EQ(preset.maps.albedo.film_unit, WidthUnit::Diameters);
    EXPECT_FALSE(find_key("albedo.film_unit")->read(read_value("mm"), preset));
}

TEST(Schema, AnOutlineIsAWordOrAPolygon) {
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

TEST(Schema, EverySolverHasItsWord) {
    const Key* key = find_key("foam.solver");
    EXPECT_EQ(key->allowed, R"(one of "newton", "gauss-seidel", "gauss-seidel-colored")");
    Preset preset;
    for (const auto& [word, solver] :
         {std::pair("gauss-seidel", Solver::GaussSeidel),
          std::pair("gauss-seidel-colored", Solver::ColoredGaussSeidel),
          std::pair("newton", Solver::Newton)}) {
        EXPECT_TRUE(key->read(read_value(word), preset));
        EXPECT_EQ(preset.equilibrium.solver, solver);
        EXPECT_EQ(to_toml(key->write(preset)), fmt::format("\"{}\"", word));
    }
    EXPECT_FALSE(accepts("foam.solver", "jacobi"));
}

TEST(Schema, ARefusedValueChangesNothing) {
    Preset preset;
    EXPECT_FALSE(find_key("image.size")->read(read_value("[7, 0]"), preset));
    EXPECT_EQ(preset.image.width, ImageOptions{}.width);
}

}  // namespace
}  // namespace foam::texgen
