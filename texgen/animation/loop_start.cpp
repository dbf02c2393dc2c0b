// SPDX-License-Identifier: Apache-2.0

#include "texgen/animation/loop_start.h"

#include "core/io/foam_json.h"
#include "texgen/json/json_value.h"
#include "texgen/json/json_writer.h"
#include "texgen/preset/shipped_presets.h"
#include "texgen/preset/simulation_keys.h"

#include <fmt/core.h>

#include <cstdint>
#include <limits>
#include <set>

namespace foam::texgen {

namespace {

Json boiling_to_json(const BoilingBubble& bubble) {
    return {{"bubble", bubble.identity},
            {"birth", bubble.birth},
            {"area_rise", bubble.area_rise},
            {"min_area_rise", bubble.min_area_rise},
            {"last_position", {bubble.last_position.x(), bubble.last_position.y()}},
            {"neighbors", bubble.neighbors.value_or(std::set<BubbleIdentity>())}};
}

BubbleIdentity identity_in(const JsonValue& json) {
    return static_cast<BubbleIdentity>(json.integer(0, std::numeric_limits<BubbleIdentity>::max()));
}

std::vector<double> numbers_in(const JsonValue& json) {
    std::vector<double> numbers;
    for (const JsonValue& item : json.items()) {
        numbers.push_back(item.number());
    }
    return numbers;
}

BoilingBubble boiling_in(const JsonValue& json) {
    BoilingBubble bubble{.identity = identity_in(json["bubble"]),
                         .birth = json["birth"].count(),
                         .area_rise = json["area_rise"].number(),
                         .min_area_rise = json["min_area_rise"].number()};
    const std::vector<double> position = numbers_in(json["last_position"]);
    if (position.size() != 2) {
        json["last_position"].reject("two numbers");
    }
    bubble.last_position = {position[0], position[1]};
    bubble.neighbors.emplace();
    for (const JsonValue& neighbor : json["neighbors"].items()) {
        bubble.neighbors->insert(identity_in(neighbor));
    }
    bubble.neighbors_changed = false;  // since the loop of a LoopStart has closed
    return bubble;
}

OscillatingBubble oscillating_in(const JsonValue& json) {
    return {identity_in(json["bubble"]),
            json["mean_area"].number(),
            json["amplitude"].number(),
            json["phase"].number()};
}

CycleDrive drive_in(const JsonValue& json) {
    CycleDrive drive;
    for (const JsonValue& bubble : json["boiling"].items()) {
        drive.boiling.push_back(boiling_in(bubble));
    }
    for (const JsonValue& bubble : json["oscillating"].items()) {
        drive.oscillating.push_back(oscillating_in(bubble));
    }
    return drive;
}

}  // namespace

std::string loop_hash(const Preset& preset) {
    Preset closed = preset;
    const LoopOptions shown_as_simulated;
    closed.loop.drift = shown_as_simulated.drift;
    closed.loop.current = shown_as_simulated.current;
    closed.loop.eddies = shown_as_simulated.eddies;
    closed.frames.smoothing = 0.0;
    return simulation_hash(closed);
}

std::string write_loop_start(const LoopStart& start, const std::string& hash) {
    Json loop = {{"hash", hash},
                 {"first_pressures", start.first_pressures},
                 {"boiling", Json::array()},
                 {"oscillating", Json::array()}};
    for (const BoilingBubble& bubble : start.drive.boiling) {
        loop["boiling"].push_back(boiling_to_json(bubble));
    }
    for (const OscillatingBubble& bubble : start.drive.oscillating) {
        loop["oscillating"].push_back({{"bubble", bubble.bubble},
                                       {"mean_area", bubble.mean_area},
                                       {"amplitude", bubble.amplitude},
                                       {"phase", bubble.phase}});
    }
    const std::string foam = write_foam_json(start.foam);
    return "{\n\"loop\": " + json_text(loop) + "," + foam.substr(1);
}

LoopStart read_loop_start(std::string_view text, const std::string& file) {
    const JsonDocument document(text, file);
    const JsonValue loop = document.root()["loop"];
    return {read_foam_json(text, file), drive_in(loop), numbers_in(loop["first_pressures"])};
}

// The content of a file of presets/loops begins with the hash, so that the search does not parse
// whole files.
std::optional<LoopStart> stored_loop_start(const Preset& preset) {
    if (!preset.loop.is_cycle()) {
        return std::nullopt;
    }
    const std::string begin = fmt::format("{{\n\"loop\": {{\"hash\":\"{}\"", loop_hash(preset));
    for (const ShippedPreset& shipped : shipped_presets()) {
        if (shipped.loop_start.starts_with(begin)) {
            return read_loop_start(shipped.loop_start, std::string(shipped.name) + ".json");
        }
    }
    return std::nullopt;
}

}  // namespace foam::texgen
