// SPDX-License-Identifier: Apache-2.0

#include "texgen/animation/loop_start.h"

#include "core/files/file_io.h"
#include "core/files/input_limits.h"
#include "core/io/foam_json.h"
#include "texgen/json/json_value.h"
#include "texgen/json/json_writer.h"
#include "texgen/preset/shipped_presets.h"
#include "texgen/preset/simulation_keys.h"

#include <fmt/core.h>

#include <cstdint>
#include <set>

// The state after a cycle is a function of the state before it, a stroboscopic Poincaré map (S. H.
// Strogatz, "Nonlinear Dynamics and Chaos", 1994). A loop that closes is a fixed point of this map.
// The cycles of Simulation::close_loop are the search for the fixed point. In a boil, the search
// also changes the drive and thus the map. This file stores a fixed point as text: the foam, its
// drive and the first pressures, in decimal numbers that are read as the same bits. The text begins
// with a hash of the keys that determine the map. Because the text may come from an untrusted
// source, all numbers are checked before a simulation uses them. The format is our own.

namespace foam::texgen {

namespace {

// Limits of the numbers of a LoopStart, in foam units (a mean bubble has an area of about 1):
constexpr double kMaxNumber = 1e15;  // the largest magnitude of a number
constexpr double kMinArea = 1e-15;   // the smallest mean area of an oscillating bubble

Json boiling_to_json(const BoilingBubble& bubble) {
    return {{"bubble", bubble.identity},
            {"birth", bubble.birth},
            {"area_rise", bubble.area_rise},
            {"min_area_rise", bubble.min_area_rise},
            {"last_position", {bubble.last_position.x(), bubble.last_position.y()}},
            {"neighbors", bubble.neighbors.value_or(std::set<BubbleIdentity>())}};
}

BubbleIdentity identity_in(const JsonValue& json) {
    return static_cast<BubbleIdentity>(json.integer(0, kMaxIdentity - 1));
}

// Returns the number in a JSON value. Rejects a number that is not from `low` to `high`, because
// the file may come from an untrusted source.
double number_in(const JsonValue& json, double low, double high) {
    const double number = json.number();
    if (!(number >= low && number <= high)) {
        json.reject(fmt::format("a number from {} to {}", low, high));
    }
    return number;
}

std::vector<double> numbers_in(const JsonValue& json) {
    std::vector<double> numbers;
    for (const JsonValue& item : json.items()) {
        numbers.push_back(number_in(item, -kMaxNumber, kMaxNumber));
    }
    return numbers;
}

BoilingBubble boiling_in(const JsonValue& json) {
    BoilingBubble bubble{.identity = identity_in(json["bubble"]),
                         .birth = json["birth"].count(),
                         .area_rise = number_in(json["area_rise"], 0.0, kMaxNumber),
                         .min_area_rise = number_in(json["min_area_rise"], 0.0, kMaxNumber)};
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
            number_in(json["mean_area"], kMinArea, kMaxNumber),
            number_in(json["amplitude"], 0.0, 1.0),
            number_in(json["phase"], 0.0, 1.0)};
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

// Returns true if a start is possible for a preset. A start may come from an untrusted source:
// simulate_states relies on these conditions.
bool is_start_for(const Preset& preset, const LoopStart& start) {
    const BubbleIdentity limit = start.foam.next_identity;
    std::set<BubbleIdentity> driven;
    bool fits = limit <= kMaxIdentity &&
                start.foam.domain.is_plane() == (preset.shape.kind == FoamKind::Patch);
    for (const BoilingBubble& bubble : start.drive.boiling) {
        const auto& neighbors = *bubble.neighbors;
        fits = fits && bubble.identity < limit && driven.insert(bubble.identity).second &&
               bubble.birth < preset.frames.count &&
               (neighbors.empty() || *neighbors.rbegin() < limit);
    }
    for (const OscillatingBubble& bubble : start.drive.oscillating) {
        fits = fits && bubble.bubble < limit && driven.insert(bubble.bubble).second;
    }
    return fits;
}

// Returns the first characters of every text that write_loop_start returns for the loop_hash of a
// preset. The hash comes first, so that texts for other presets are not parsed.
std::string opening_for(const Preset& preset) {
    return fmt::format("{{\n\"loop\": {{\"hash\":\"{}\"", loop_hash(preset));
}

// Returns the start that a text describes, or nullopt if the text does not begin with `opening`.
std::optional<LoopStart> start_in(std::string_view text,
                                  std::string_view opening,
                                  const Preset& preset,
                                  const std::string& file) {
    if (!text.starts_with(opening)) {
        return std::nullopt;
    }
    LoopStart start = read_loop_start(text, file);
    if (!is_start_for(preset, start)) {
        fail_to_read(file, "this is not the start of a loop of the preset");
    }
    return start;
}

}  // namespace

std::string loop_hash(const Preset& preset) {
    Preset hashed = preset;
    const LoopOptions defaults;
    hashed.loop.drift = defaults.drift;
    hashed.loop.current = defaults.current;
    hashed.loop.eddies = defaults.eddies;
    hashed.frames.smoothing = 0.0;
    return simulation_hash(hashed);
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

std::optional<LoopStart> matching_loop_start(const Preset& preset,
                                             std::string_view text,
                                             const std::string& file) {
    return start_in(text, opening_for(preset), preset, file);
}

std::optional<LoopStart> stored_loop_start(const Preset& preset) {
    if (!preset.loop.is_cycle()) {
        return std::nullopt;
    }
    const std::string opening = opening_for(preset);
    for (const ShippedPreset& shipped : shipped_presets()) {
        const std::string file = std::string(shipped.name) + ".json";
        if (auto start = start_in(shipped.loop_start, opening, preset, file)) {
            return start;
        }
    }
    return std::nullopt;
}

}  // namespace foam::texgen
