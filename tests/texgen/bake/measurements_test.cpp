// SPDX-License-Identifier: Apache-2.0

#include "texgen/bake/measurements.h"

#include "core/dynamics/shear_modulus.h"
#include "core/foam/frame.h"
#include "tests/support/temporary_folder.h"
#include "tests/texgen/small_preset.h"
#include "texgen/manifest/manifest_file.h"
#include "texgen/manifest/recorded_bake.h"
#include "texgen/manifest/set_choice.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <stdexcept>
#include <string>
#include <vector>

namespace foam::texgen {
namespace {

const std::vector<std::string> kAll = {"shear_modulus", "bubbles", "events"};

// A preset whose bubbles vanish and swap neighbors, and its frames from 1 to `last`.
std::vector<SimulatedFrame> frames_of(const Preset& preset, int last) {
    std::vector<int> numbers;
    for (int k = 1; k <= last; ++k) {
        numbers.push_back(k);
    }
    std::vector<SimulatedFrame> frames;
    simulation_of(preset, 1)(numbers,
                             NextFrames::Omitted,
                             [&](const SimulatedFrame& shown) { frames.push_back(shown); },
                             {});
    return frames;
}

Preset coarsening_preset(const std::filesystem::path& pattern) {
    Preset preset = small_preset(pattern);
    preset.frames.time_step = 3.0;
    return preset;
}

TEST(Measurements, AreEmptyIfNothingIsAskedFor) {
    const TemporaryFolder folder;
    const SimulatedFrame shown = frames_of(small_preset(folder.path() / "a.####.png"), 1).front();
    EXPECT_EQ(measurements_json(shown, {}), "");
}

TEST(Measurements, ContainWhatIsAskedFor) {
    const TemporaryFolder folder;
    const std::vector<SimulatedFrame> frames =
        frames_of(coarsening_preset(folder.path() / "a.####.png"), 4);
    std::size_t events = 0;
    for (const SimulatedFrame& shown : frames) {
        const nlohmann::json value = nlohmann::json::parse(measurements_json(shown, kAll));
        EXPECT_EQ(value["shear_modulus"], *shear_modulus(*shown.frame, 1));
        const std::size_t bubbles = shown.frame->bubbles.size();
        EXPECT_EQ(value["bubbles"].size(), 10U);
        for (const auto& [name, numbers] : value["bubbles"].items()) {
            EXPECT_EQ(numbers.size(), bubbles) << name;
        }
        EXPECT_EQ(value["events"].size(), shown.effort.events.size());
        events += value["events"].size();
    }
    EXPECT_GT(events, 0U);
    const std::string only_events =
        measurements_json(frames.back(), std::vector<std::string>{"events"});
    EXPECT_EQ(nlohmann::json::parse(only_events).size(), 1U);
}

// A patch has no shear modulus.
TEST(Measurements, OfAPatchHaveNoShearModulus) {
    const TemporaryFolder folder;
    Preset preset = small_preset(folder.path() / "a.####.png");
    preset.shape.kind = FoamKind::Patch;
    const SimulatedFrame shown = frames_of(preset, 1).front();
    const nlohmann::json value = nlohmann::json::parse(measurements_json(shown, kAll));
    EXPECT_TRUE(value["shear_modulus"].is_null());
}

// Images do not depend on the measurements, so bakes with and without them belong to one set.
TEST(Measurements, AreInTheManifest) {
    const TemporaryFolder folder;
    Preset preset = coarsening_preset(folder.path() / "{map}.####.png");
    bake_recorded(preset, {.frames = {1, 2}, .threads = 1}, {});
    preset.output.measurements = kAll;
    preset.image.maps = {"film"};
    bake_recorded(preset, {.frames = {2, 3}, .threads = 1}, {});
    const Manifest manifest = read_manifest(folder.path());
    ASSERT_EQ(manifest.sets.size(), 1U);
    const BakedSet& set = manifest.sets.front();
    EXPECT_EQ(set.find_frame(1)->measurements, "");
    const std::vector<SimulatedFrame> frames = frames_of(preset, 3);
    EXPECT_EQ(set.find_frame(3)->measurements, measurements_json(frames[2], kAll));
    // A bake without measurements keeps them.
    preset.output.measurements.clear();
    preset.image.maps = {"id"};
    bake_recorded(preset, {.frames = {3}, .threads = 1}, {});
    EXPECT_EQ(read_manifest(folder.path()).sets.front().find_frame(3)->measurements,
              set.find_frame(3)->measurements);
}

// A manifest that the program could not read again would end the bake.
TEST(Measurements, ThatAreTooLargeAreRejectedBeforeTheBake) {
    Preset preset;
    preset.seeding.bubbles = 10000;
    EXPECT_NO_THROW(check_measurements(preset, 100000));
    preset.output.measurements = kAll;
    EXPECT_NO_THROW(check_measurements(preset, 298));
    EXPECT_THROW(check_measurements(preset, 299), std::invalid_argument);
    preset.output.measurements = {"events"};
    EXPECT_NO_THROW(check_measurements(preset, 100000));
}

// A frame is only kept if it has the measurements that the preset asks for.
TEST(Measurements, ResumingAddsThem) {
    const TemporaryFolder folder;
    Preset preset = coarsening_preset(folder.path() / "{map}.####.png");
    const auto frames_baked = [&] {
        int count = 0;
        bake_recorded(preset,
                      {.frames = {1, 2}, .threads = 1},
                      {.on_baked = [&](const BakedFrame&) { ++count; }},
                      {.resume = Resume::Yes});
        return count;
    };
    EXPECT_EQ(frames_baked(), 2);
    EXPECT_EQ(frames_baked(), 0);
    preset.output.measurements = {"events"};
    EXPECT_EQ(frames_baked(), 2);
    EXPECT_EQ(frames_baked(), 0);
    preset.output.measurements = {"bubbles", "events"};
    EXPECT_EQ(frames_baked(), 2);
    preset.output.measurements.clear();
    EXPECT_EQ(frames_baked(), 0);
}

}  // namespace
}  // namespace foam::texgen
