// SPDX-License-Identifier: Apache-2.0

#include "texgen/preset/simulation_keys.h"

#include "tests/texgen/preset/rejection.h"
#include "texgen/preset/assignment.h"
#include "texgen/preset/preset_io.h"

#include <gtest/gtest.h>

#include <memory>
#include <string>
#include <vector>

namespace foam::texgen {
namespace {

TEST(SimulationKeys, AnUnknownTableAffectsTheSimulation) {
    EXPECT_TRUE(table_affects_simulation("gravity"));
    EXPECT_TRUE(table_affects_simulation(""));
}

TEST(SimulationKeys, AppearanceTablesDoNotAffectTheSimulation) {
    for (const char* table : {"foam", "dynamics", "frames", "loop"}) {
        EXPECT_TRUE(table_affects_simulation(table)) << table;
    }
    for (const char* table :
         {"preset", "image", "camera", "output", "albedo", "relief", "height", "event_map"}) {
        EXPECT_FALSE(table_affects_simulation(table)) << table;
    }
}

Preset changed(Preset preset, const std::string& argument) {
    assign(preset, std::vector{read_set_argument(argument)});
    return preset;
}

TEST(SimulationKeys, TheHashDependsOnKeysThatAffectTheSimulation) {
    const Preset preset;
    const std::string hash = simulation_hash(preset);
    for (const char* argument : {"foam.seed=2",
                                 "dynamics.kappa=0.5",
                                 "frames.time_step=2",
                                 "loop.kind=breathe",
                                 "image.size=[512, 256]"}) {
        EXPECT_NE(simulation_hash(changed(preset, argument)), hash) << argument;
    }
    for (const char* argument : {"preset.description=new",
                                 "image.size=[512, 512]",
                                 "image.maps=normal",
                                 "albedo.film_width=4",
                                 "output.pattern=####.exr"}) {
        EXPECT_EQ(simulation_hash(changed(preset, argument)), hash) << argument;
    }
}

Preset patch_with(const std::string& events) {
    return parse_preset("[foam]\ndomain = \"patch\"\n" + events, "a", "a.toml");
}

TEST(SimulationKeys, TheCameraAffectsTheSimulationIfEventsHavePositions) {
    const Preset without = patch_with("[[event]]\nkind = \"collapse\"\nframe = 3\nbubble = 4\n");
    const Preset with = patch_with("[[event]]\nkind = \"collapse\"\nframe = 3\nat = [0, 0]\n");
    EXPECT_EQ(simulation_hash(changed(without, "camera.zoom=2")), simulation_hash(without));
    EXPECT_NE(simulation_hash(changed(with, "camera.zoom=2")), simulation_hash(with));
    EXPECT_EQ(simulation_hash(changed(without, "image.size=[9, 5]")), simulation_hash(without));
    EXPECT_NE(simulation_hash(changed(with, "image.size=[9, 5]")), simulation_hash(with));
}

std::string rejection(const Preset& simulated, const Preset& now) {
    return test::rejection_of([&] { check_same_simulation(simulated, now); });
}

TEST(SimulationKeys, AChangedPresetNamesTheKey) {
    const Preset preset;
    EXPECT_EQ(rejection(preset, changed(preset, "albedo.film_width=4")), "no failure");
    EXPECT_EQ(rejection(preset, changed(preset, "preset.vary=[\"foam.lloyd=1,2\"]")), "no failure");
    EXPECT_EQ(rejection(preset, changed(preset, "frames.warm_up=2")),
              "key 'frames.warm_up' = 2.0: must be 0.0, as in the cache; with a cache, only "
              "preset.description, preset.vary and keys of images, output, drawings, meshes and "
              "maps can be changed; for a patch without events at positions, also the camera");
    EXPECT_EQ(rejection(preset, changed(preset, "image.size=[512, 256]")),
              "key 'image.size' = [512, 256]: must have the aspect ratio 1:1 of the cache, such as "
              "[1024, 1024]");
    Preset with_event = preset;
    with_event.events.push_back({});
    EXPECT_EQ(rejection(preset, with_event).find("key 'event': must be the same as in the cache"),
              0U);
}

// A cache made with another picture under the same name belongs to another simulation.
TEST(SimulationKeys, TheHashDependsOnTheContentOfThePictureOfTheDensity) {
    Preset preset;
    preset.density.source = {"x.png", {"x.png", std::make_shared<const SourcePicture>(), "1"}};
    const std::string before = simulation_hash(preset);
    preset.density.source.picture.hash = "2";
    EXPECT_NE(simulation_hash(preset), before);
    preset.density.source.picture.hash = "1";
    preset.maps.albedo.picture = {"y.png", std::make_shared<const SourcePicture>(), "3"};
    EXPECT_EQ(simulation_hash(preset), before);
}

}  // namespace
}  // namespace foam::texgen
