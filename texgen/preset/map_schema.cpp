#include "texgen/preset/map_schema.h"

#include "texgen/image/colormap.h"
#include "texgen/maps/foam_record.h"
#include "texgen/preset/value_kinds.h"
#include "texgen/preset/key_of_member.h"
#include "texgen/preset/map_choices.h"
#include "texgen/preset/refusal.h"

#include <fmt/core.h>

#include <array>
#include <string_view>

namespace foam::texgen {

namespace {

constexpr Choices<PressureScaling, 3> kPressureScalings = {
    {{{"range", PressureScaling::Range},
      {"percentile", PressureScaling::Percentile},
      {"rank", PressureScaling::Rank}}}};
constexpr Choices<AgeSince> kAgeSince = {
    {{{"birth", AgeSince::Birth}, {"change", AgeSince::Change}}}};

std::span<const std::string_view> colormaps_and_none() {
    static const std::vector<std::string_view> words = [] {
        std::vector<std::string_view> all{"none"};
        all.insert(all.end(), colormap_names().begin(), colormap_names().end());
        return all;
    }();
    return words;
}

std::vector<Key> pressure_keys() {
    using Options = PressureOptions;
    const auto one = keys_in(&MapOptions::pressure);
    return {
        one("pressure.scaling",
            kPressureScalings,
            "tones by a range of pressures, by the range of most bubbles of the first frame, or "
            "by the share of its bubbles with a lower pressure",
            &Options::scaling),
        one("pressure.percentile",
            Reals{0.0, 49.0},
            "of \"percentile\": percentage of the bubbles left out at either end",
            &Options::percentile),
        one("pressure.low",
            Reals{-kLargestPressure, kLargestPressure},
            "of \"range\": pressure of tone 0",
            &Options::low),
        one("pressure.high",
            Reals{-kLargestPressure, kLargestPressure},
            "of \"range\": pressure of tone 1; above low",
            &Options::high),
        one("pressure.unit",
            kPressureUnits,
            "of low and high: as albedo.pressure_unit",
            &Options::unit),
        one("pressure.exaggeration",
            Reals{0.0, 1000.0},
            "factor on what differs from the middle tone: a large one leaves only walls and "
            "passages",
            &Options::exaggeration),
        one("pressure.colormap",
            Words{colormaps_and_none()},
            "colours of the tones; none leaves grey numbers",
            &Options::colormap)};
}

std::vector<Key> area_keys() {
    using Options = AreaOptions;
    const auto one = keys_in(&MapOptions::area);
    return {one("area.unit",
                kMeanBubbles,
                "mean area of the seeded foam or of this frame",
                &Options::unit),
            one("area.full",
                Reals{1e-3, 1e6},
                "area that a PNG has as its largest code, in the unit",
                &Options::full)};
}

std::vector<Key> roughness_keys() {
    using Options = RoughnessOptions;
    const auto one = keys_in(&MapOptions::roughness);
    constexpr Reals kParts{0.0, 1.0};
    return {one("roughness.cell", kParts, "of bubbles; 0 is a mirror", &Options::cell),
            one("roughness.film", kParts, "of films, as wide as albedo.film_width", &Options::film),
            one("roughness.variation",
                kParts,
                "width of the range around roughness.cell that bubbles have",
                &Options::variation)};
}

std::vector<Key> age_keys() {
    using Options = AgeOptions;
    const auto one = keys_in(&MapOptions::age);
    return {one("age.since",
                kAgeSince,
                "a bubble's birth, of the seeded ones at time 0, or when its neighbours last "
                "changed",
                &Options::since),
            one("age.full",
                Reals{1e-6, 1e9},
                "age that a PNG has as its largest code, foam time",
                &Options::full)};
}

std::vector<Key> growth_keys() {
    const auto one = keys_in(&MapOptions::growth);
    return {one("growth.full",
                Reals{1e-9, 1e6},
                "growth that a PNG has as its largest code, area per foam time; its negative is 0",
                &GrowthOptions::full)};
}

// "event" is taken by what happens to the foam.
std::vector<Key> event_map_keys() {
    using Options = EventMapOptions;
    const auto one = keys_in(&MapOptions::event_map);
    return {one("event_map.radius",
                Reals{0.01, 100.0},
                "of the spots of map event, in diameters of a mean bubble of the seeded foam",
                &Options::radius),
            one("event_map.fade",
                Integers{1, kRecordedFrames},
                "frames until a spot is gone",
                &Options::fade)};
}

// Two keys of which the one must be below the other.
struct OrderedKeys {
    std::string_view low;
    std::string_view high;
    double low_value;
    double high_value;
};

// The assignments were good before this batch, so one of the batch is to blame: the last.
void check_order(const OrderedKeys& keys, std::span<const Assignment> assignments) {
    if (keys.low_value < keys.high_value) {
        return;
    }
    for (auto last = assignments.rbegin(); last != assignments.rend(); ++last) {
        if (last->key == keys.high) {
            refuse(*last, fmt::format("must be above {} = {}", keys.low, keys.low_value));
        }
        if (last->key == keys.low) {
            refuse(*last, fmt::format("must be below {} = {}", keys.high, keys.high_value));
        }
    }
}

}  // namespace

std::vector<Key> map_keys() {
    std::vector<Key> all;
    for (const auto& keys : {look_keys(),
                             pressure_keys(),
                             area_keys(),
                             roughness_keys(),
                             age_keys(),
                             growth_keys(),
                             event_map_keys(),
                             place_map_keys()}) {
        all.insert(all.end(), keys.begin(), keys.end());
    }
    return all;
}

void check_maps(const Preset& preset, std::span<const Assignment> assignments) {
    const AlbedoOptions& albedo = preset.maps.albedo;
    const PressureOptions& pressure = preset.maps.pressure;
    check_order(
        {"albedo.pressure_low", "albedo.pressure_high", albedo.pressure_low, albedo.pressure_high},
        assignments);
    check_order({"pressure.low", "pressure.high", pressure.low, pressure.high}, assignments);
}

}  // namespace foam::texgen
