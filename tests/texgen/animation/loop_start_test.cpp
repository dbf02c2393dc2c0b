// SPDX-License-Identifier: Apache-2.0

#include "texgen/animation/loop_start.h"

#include "core/dynamics/cycle.h"
#include "core/files/file_io.h"
#include "core/io/foam_json.h"
#include "tests/support/test_files.h"
#include "texgen/animation/simulation.h"
#include "texgen/preset/assignment.h"
#include "texgen/preset/load_preset.h"
#include "texgen/preset/preset_io.h"
#include "texgen/preset/shipped_presets.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <functional>
#include <span>
#include <string>
#include <utility>
#include <vector>

namespace foam::texgen {

namespace {

Preset small_boil() {
    Preset preset;
    preset.seeding.bubbles = 40;
    preset.frames.count = 24;
    preset.loop.kind = LoopKind::Boil;
    return preset;
}

// A simulation that begins with the start of a closed loop, stored and read again, shows the same
// frames as the simulation that found the loop.
TEST(LoopStart, GivesTheFramesOfTheLoop) {
    const Preset preset = small_boil();
    Simulation found(preset, 1);
    ASSERT_TRUE(found.advance());
    const std::string text = write_loop_start(found.loop_start(), loop_hash(preset));
    Simulation stored(preset, read_loop_start(text, "loop.json"), 1);
    ASSERT_TRUE(stored.advance());
    EXPECT_LT(stored.closing_error().value(), Simulation::kClosed);
    EXPECT_EQ(stored.record().first_pressures, found.record().first_pressures);
    for (int frame = 1; frame <= preset.frames.count; ++frame) {
        EXPECT_LT(closing_error(stored.foam(), found.foam()), 1e-8) << frame;
        ASSERT_TRUE(stored.advance() && found.advance());
        EXPECT_EQ(stored.equilibrium().t1, found.equilibrium().t1) << frame;
        EXPECT_EQ(stored.events().size(), found.events().size()) << frame;
    }
}

TEST(LoopStart, FilesReadBackToTheSameBytes) {
    const Preset preset = small_boil();
    Simulation simulation(preset, 1);
    ASSERT_TRUE(simulation.advance());
    const std::string text = write_loop_start(simulation.loop_start(), "hash");
    EXPECT_EQ(write_loop_start(read_loop_start(text, "loop.json"), "hash"), text);
}

TEST(LoopStart, RejectsOtherFiles) {
    Simulation simulation(small_boil(), 1);
    ASSERT_TRUE(simulation.advance());
    const LoopStart start = simulation.loop_start();
    EXPECT_THROW(read_loop_start(write_foam_json(start.foam), "foam.json"), InputError);
    std::string text = write_loop_start(start, "hash");
    text.replace(text.find("\"phase\":"), 8, "\"phrase\"");
    EXPECT_THROW(read_loop_start(text, "loop.json"), InputError);
}

// A file in a cache may come from a stranger, who can write the right hash into it.
TEST(LoopStart, MatchesOnlyAPresetForWhichItIsPossible) {
    const Preset preset = small_boil();
    Simulation simulation(preset, 1);
    ASSERT_TRUE(simulation.advance());
    const LoopStart start = simulation.loop_start();
    const auto match = [&](const LoopStart& other) {
        const std::string text = write_loop_start(other, loop_hash(preset));
        return matching_loop_start(preset, text, "loop.json").has_value();
    };
    EXPECT_TRUE(match(start));
    EXPECT_FALSE(matching_loop_start(preset, write_loop_start(start, "hash"), "loop.json"));
    const auto expect_impossible = [&](const std::function<void(LoopStart&)>& change) {
        LoopStart other = start;
        change(other);
        EXPECT_THROW(match(other), InputError);
    };
    const BubbleIdentity none = start.foam.next_identity;
    expect_impossible([&](LoopStart& other) { other.drive.boiling[0].identity = none; });
    expect_impossible([&](LoopStart& other) { other.drive.boiling[0].neighbors->insert(none); });
    expect_impossible([&](LoopStart& other) { other.drive.boiling[0].birth = 24; });
    expect_impossible([&](LoopStart& other) { other.drive.oscillating[0].bubble = none; });
    expect_impossible([](LoopStart& other) {
        other.drive.oscillating[0].bubble = other.drive.oscillating[1].bubble;
    });
    expect_impossible([](LoopStart& other) { other.drive.oscillating[0].amplitude = 2.0; });
    expect_impossible([](LoopStart& other) { other.foam.next_identity = 1U << 31U; });
}

TEST(LoopStart, HashIgnoresHowTheLoopIsShown) {
    const Preset preset = load_preset("fizz");
    const auto with = [&](const char* argument) {
        Preset changed = preset;
        assign(changed, std::vector{read_set_argument(argument)});
        return loop_hash(changed);
    };
    for (const char* shown : {"loop.drift=[1, 0]",
                              "loop.current=0.2",
                              "frames.smoothing=4",
                              "albedo.film_width=0.1",
                              "image.size=[512, 512]"}) {
        EXPECT_EQ(with(shown), loop_hash(preset)) << shown;
    }
    for (const char* simulated : {"foam.seed=5",
                                  "foam.bubbles=221",
                                  "loop.boiling=0.1",
                                  "loop.amplitude=0.2",
                                  "frames.count=47",
                                  "frames.warm_up=61",
                                  "foam.tolerance=1e-8",
                                  "image.size=[512, 256]"}) {
        EXPECT_NE(with(simulated), loop_hash(preset)) << simulated;
    }
}

struct Restart {
    int cycles = 0;  // number of cycles until the loop closed; 0 if it did not close
    LoopStart start;
};

// Begins the loop of a preset with a stored state.
Restart restarted(const Preset& preset, const LoopStart& start) {
    Restart result;
    Simulation simulation(preset, start, 2, [&](const RunProgress& progress) {
        EXPECT_EQ(progress.phase, Phase::LoopClosing);
        result.cycles = progress.cycle;
    });
    if (!simulation.advance()) {
        return {};
    }
    result.start = simulation.loop_start();
    return result;
}

// The shipped presets whose loops take long to close: `fizz`, `potion` and `surf` boil, and
// `leather` has thousands of bubbles.
class LongLoopStartTest : public testing::TestWithParam<const char*> {};

INSTANTIATE_TEST_SUITE_P(Presets,
                         LongLoopStartTest,
                         testing::Values("fizz", "potion", "surf", "leather"),
                         [](const auto& preset) { return std::string(preset.param); });

// The file of a preset in presets/loops has the same bytes as the file that the search for the loop
// gives today. If FOAMTEX_UPDATE_GOLDEN is set, writes the file instead; the program must be built
// again afterwards.
TEST_P(LongLoopStartTest, FileIsWhatTheSearchFinds) {
    const Preset preset = load_preset(GetParam());
    Simulation simulation(preset, 2);
    ASSERT_TRUE(simulation.advance());
    const std::string text = write_loop_start(simulation.loop_start(), loop_hash(preset));
    const std::filesystem::path path =
        foam::test::readme().parent_path() / "presets" / "loops" / (preset.name + ".json");
    if (std::getenv("FOAMTEX_UPDATE_GOLDEN") != nullptr) {
        write_file(path, std::as_bytes(std::span(text)));
        GTEST_SKIP() << "made " << path << " anew";
    }
    EXPECT_TRUE(find_shipped_preset(preset.name).loop_start == text)
        << path << " is not what the search finds";
}

// From the stored state, the loop closes in the first cycle, and its first state is the one that
// the search finds.
TEST(LoopStart, StoredStatesCloseInOneCycle) {
    for (const ShippedPreset& shipped : shipped_presets()) {
        if (shipped.loop_start.empty()) {
            continue;
        }
        const Preset preset = load_preset(std::string(shipped.name));
        const std::optional<LoopStart> start = stored_loop_start(preset);
        ASSERT_TRUE(start) << shipped.name << ": the file in presets/loops is for other keys";
        const Restart restart = restarted(preset, *start);
        EXPECT_EQ(restart.cycles, 1) << shipped.name;
        EXPECT_LT(closing_error(start->foam, restart.start.foam), Simulation::kClosed)
            << shipped.name;
    }
}

}  // namespace

}  // namespace foam::texgen
