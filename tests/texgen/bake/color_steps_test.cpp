// SPDX-License-Identifier: Apache-2.0

#include "texgen/animation/simulate_frames.h"
#include "texgen/image/colormap.h"
#include "texgen/maps/cell_color.h"
#include "texgen/maps/pressure.h"
#include "texgen/preset/load_preset.h"
#include "texgen/preset/shipped_presets.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <map>
#include <numeric>
#include <string>
#include <vector>

namespace foam::texgen {

namespace {

// The largest step of the color of a bubble from one frame to the next, in codes of 8-bit sRGB.
constexpr int kMaxStep = 30;

// Simulating more bubbles takes too long for a test.
constexpr int kMaxBubbles = 1000;

using BubbleColors = std::map<BubbleIdentity, Srgb8>;

Preset reduced(const std::string& name) {
    Preset preset = load_preset(name);
    preset.seeding.bubbles = std::min(preset.seeding.bubbles, kMaxBubbles);
    return preset;
}

PerBubble<LinearRgb> tone_colors(FrameLayers& layers, const PressureOptions& options) {
    const ColorMap& colormap = find_colormap(options.colormap);
    PerBubble<LinearRgb> colors;
    for (const double tone : pressure_tones(layers, options)) {
        colors.push_back(colormap.at(std::clamp(tone, 0.0, 1.0)));
    }
    return colors;
}

// Returns true if a map of the preset shows the colors of colors_of.
bool shows_cell_colors(const Preset& preset) {
    const std::vector<std::string>& maps = preset.image.maps;
    const auto lists = [&](const char* map) { return std::ranges::count(maps, map) > 0; };
    const bool is_lit = lists("lit") && preset.maps.lit.colors == LitColors::Albedo;
    return is_lit || lists("albedo") || lists("pressure");
}

// Returns the color that the map of a preset gives every bubble, before light and films.
BubbleColors colors_of(const SimulatedFrame& shown, const Preset& preset) {
    const Frame& frame = *shown.frame;
    const FoamRecord& record = *shown.record;
    const bool shows_tones = preset.image.maps.front() == "pressure";
    FrameLayers layers({frame, record}, RasterGrid{64, 64}, 1);
    const PerBubble<LinearRgb> linear = shows_tones
                                            ? tone_colors(layers, preset.maps.pressure)
                                            : cell_colors(frame, record, preset.maps.albedo);
    const PerBubble<BubbleIdentity> identities = identities_of(frame);
    BubbleColors colors;
    for (std::size_t k = 0; k < identities.size(); ++k) {
        colors[identities[k]] = to_srgb8(linear[k]);
    }
    return colors;
}

int largest_step(const BubbleColors& before, const BubbleColors& after) {
    int largest = 0;
    for (const auto& [identity, color] : after) {
        const auto old = before.find(identity);
        if (old != before.end()) {
            const Srgb8& was = old->second;
            largest = std::max({largest,
                                std::abs(color.r - was.r),
                                std::abs(color.g - was.g),
                                std::abs(color.b - was.b)});
        }
    }
    return largest;
}

class ColorSteps : public testing::TestWithParam<std::string> {};

std::vector<std::string> preset_names() {
    std::vector<std::string> names;
    for (const ShippedPreset& preset : shipped_presets()) {
        names.emplace_back(preset.name);
    }
    return names;
}

}  // namespace

// The colors of bubbles change gradually in every shipped preset, also where a neighbor vanishes.
TEST_P(ColorSteps, AreSmallInEveryShippedPreset) {
    const Preset preset = reduced(GetParam());
    if (!shows_cell_colors(preset)) {
        GTEST_SKIP() << "no map of this preset shows colors that depend on the state of the foam";
    }
    std::vector<int> numbers(static_cast<std::size_t>(preset.frames.count));
    std::iota(numbers.begin(), numbers.end(), 1);
    BubbleColors first;
    BubbleColors previous;
    int largest = 0;
    int largest_frame = 0;
    const RunOutcome outcome =
        simulate_frames(preset, 2, numbers, NextFrames::Omitted, [&](const SimulatedFrame& shown) {
            BubbleColors colors = colors_of(shown, preset);
            const int step = largest_step(previous, colors);
            if (step > largest) {
                largest = step;
                largest_frame = shown.frame->number;
            }
            if (first.empty()) {
                first = colors;
            }
            previous = std::move(colors);
        });
    ASSERT_EQ(outcome.status, RunStatus::Complete);
    RecordProperty("largest_step", largest);
    EXPECT_LT(largest, kMaxStep) << "frame " << largest_frame;
    if (preset.loop.is_cycle()) {
        EXPECT_LT(largest_step(previous, first), kMaxStep) << "from the last to the first frame";
    }
}

INSTANTIATE_TEST_SUITE_P(Presets,
                         ColorSteps,
                         testing::ValuesIn(preset_names()),
                         [](const auto& preset) { return preset.param; });

}  // namespace foam::texgen
