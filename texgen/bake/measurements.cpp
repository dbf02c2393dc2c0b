// SPDX-License-Identifier: Apache-2.0

#include "texgen/bake/measurements.h"

#include "core/dynamics/shear_modulus.h"
#include "core/files/input_limits.h"
#include "core/library/foam_records.h"
#include "texgen/json/json_writer.h"

#include <fmt/core.h>

#include <algorithm>
#include <cstdint>
#include <stdexcept>
#include <type_traits>
#include <vector>

namespace foam::texgen {

namespace {

bool is_among(const char* word, std::span<const std::string> measurements) {
    return std::ranges::find(measurements, word) != measurements.end();
}

template <class Member>
Json column(const std::vector<foamtex::Bubble>& bubbles, Member foamtex::Bubble::*member) {
    Json numbers = Json::array();
    for (const foamtex::Bubble& bubble : bubbles) {
        if constexpr (std::is_integral_v<Member>) {
            numbers.push_back(bubble.*member);
        } else {
            numbers.push_back(number_or_null(bubble.*member));
        }
    }
    return numbers;
}

Json table_of(const std::vector<foamtex::Bubble>& bubbles) {
    using foamtex::Bubble;
    return {{"area", column(bubbles, &Bubble::area)},
            {"elongation", column(bubbles, &Bubble::elongation)},
            {"identity", column(bubbles, &Bubble::identity)},
            {"orientation", column(bubbles, &Bubble::orientation)},
            {"perimeter", column(bubbles, &Bubble::perimeter)},
            {"pressure", column(bubbles, &Bubble::pressure)},
            {"sides", column(bubbles, &Bubble::sides)},
            {"target_area", column(bubbles, &Bubble::target_area)},
            {"x", column(bubbles, &Bubble::x)},
            {"y", column(bubbles, &Bubble::y)}};
}

Json list_of(const std::vector<TopologyEvent>& events) {
    Json list = Json::array();
    for (const TopologyEvent& event : events) {
        list.push_back({{"bubbles", event.bubbles},
                        {"kind", name_of(event.kind)},
                        {"time", event.time},
                        {"x", event.position.x()},
                        {"y", event.position.y()}});
    }
    return list;
}

}  // namespace

std::string measurements_json(const SimulatedFrame& shown,
                              std::span<const std::string> measurements) {
    if (measurements.empty()) {
        return {};
    }
    // The members are in alphabetical order. A manifest that is read and written again has the same
    // order, because JsonValue::object_text sorts the members.
    Json value = Json::object();
    if (is_among("bubbles", measurements)) {
        value["bubbles"] = table_of(bubble_records(*shown.frame));
    }
    if (is_among("events", measurements)) {
        value["events"] = list_of(shown.effort.events);
    }
    if (is_among("shear_modulus", measurements)) {
        value["shear_modulus"] = number_or_null(shear_modulus(*shown.frame, 1));
    }
    return json_text(value);
}

bool has_measurements(const std::string& json, std::span<const std::string> measurements) {
    const Json value = json.empty() ? Json::object() : Json::parse(json);
    return std::ranges::all_of(measurements,
                               [&](const std::string& word) { return value.contains(word); });
}

void check_measurements(const Preset& preset, std::size_t frames) {
    constexpr std::uint64_t kBytesPerBubble = 180;  // estimate: ten numbers and commas
    if (!is_among("bubbles", preset.output.measurements)) {
        return;
    }
    const std::uint64_t bytes =
        kBytesPerBubble * frames * static_cast<std::uint64_t>(preset.seeding.bubbles);
    if (bytes > kDescriptionInput.max_bytes) {
        throw std::invalid_argument(fmt::format(
            "output.measurements: the measurement 'bubbles' of {} bubbles in {} frames would make "
            "manifest.json larger than {} MiB; bake tables instead (--out 'x.####.csv')",
            preset.seeding.bubbles,
            frames,
            kDescriptionInput.max_bytes / kMebibyte));
    }
}

}  // namespace foam::texgen
