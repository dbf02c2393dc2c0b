// SPDX-License-Identifier: Apache-2.0

#include "core/io/foam_json.h"
#include "core/library/require.h"
#include "texgen/animation/seed.h"
#include "texgen/api/public_errors.h"
#include "texgen/api/state.h"
#include "texgen/bake/fitted_ranges.h"
#include "texgen/bake/frame_range.h"
#include "texgen/preset/load_preset.h"
#include "texgen/preset/preset_io.h"
#include "texgen/preset/preset_keys.h"

#include <fmt/core.h>
#include <foamtex/texture.h>

#include <utility>

namespace foamtex {

namespace {

using foam::texgen::with_texture_errors;

std::vector<foam::texgen::Assignment> assignments_of(
    const std::map<std::string, std::string>& values) {
    std::vector<foam::texgen::Assignment> assignments;
    assignments.reserve(values.size());
    for (const auto& [key, value] : values) {
        assignments.push_back(
            {fmt::format("{}={}", key, value), key, foam::texgen::read_value(value)});
    }
    return assignments;
}

}  // namespace

Preset::Preset(const std::string& name_or_path, const std::map<std::string, std::string>& values)
    : state_(with_texture_errors([&] {
          return std::make_shared<const State>(State{foam::texgen::load_preset(name_or_path)});
      })) {
    set(values);
}

Preset::Preset(const Preset& other) = default;
Preset::Preset(Preset&& other) noexcept = default;
Preset& Preset::operator=(const Preset& other) = default;
Preset& Preset::operator=(Preset&& other) noexcept = default;
Preset::~Preset() = default;

void Preset::set(const std::map<std::string, std::string>& values) {
    if (values.empty()) {
        return;
    }
    state_ = with_texture_errors([&] {
        foam::texgen::Preset preset = state_->preset;
        foam::texgen::assign(preset, assignments_of(values));
        return std::make_shared<const State>(State{std::move(preset)});
    });
}

std::optional<std::string> Preset::get(const std::string& key) const {
    const foam::texgen::Key<foam::texgen::Preset>* const found = foam::texgen::find_key(key);
    if (found == nullptr) {
        throw ArgumentError("'" + key + "': unknown key");
    }
    const std::optional<foam::texgen::Value> value = found->write(state_->preset);
    return value ? std::optional(foam::texgen::to_toml(*value)) : std::nullopt;
}

std::string Preset::name() const {
    return state_->preset.name;
}

std::string Preset::description() const {
    return state_->preset.description;
}

int Preset::frame_count() const {
    return state_->preset.frames.count;
}

std::vector<std::string> Preset::maps() const {
    return state_->preset.image.maps;
}

int Preset::width() const {
    return state_->preset.image.width;
}

int Preset::height() const {
    return state_->preset.image.height;
}

std::string Preset::toml() const {
    return foam::texgen::to_toml(state_->preset);
}

Foam Preset::seeded_foam() const {
    return with_texture_errors([&] {
        return Foam::from_state(foam::write_foam_json(foam::texgen::seeded_foam(state_->preset)));
    });
}

void Preset::fit_ranges(int threads) {
    state_ = with_texture_errors([&] {
        foam::require_threads(threads);
        foam::texgen::Preset preset = state_->preset;
        // If the pattern names integer files, such as PNGs, fit_automatic_ranges fits the automatic
        // ranges of all drawn maps. For EXR files, it fits only those of the maps in packed images.
        const std::string pattern = std::exchange(preset.output.pattern, "{map}.####.png");
        const foam::texgen::RunOutcome outcome =
            foam::texgen::fit_automatic_ranges(preset,
                                               foam::texgen::simulation_of(preset, threads),
                                               foam::texgen::frames_to(preset.frames.count),
                                               threads);
        foam::texgen::throw_if_failed(outcome);
        preset.output.pattern = pattern;
        return std::make_shared<const State>(State{std::move(preset), true});
    });
}

}  // namespace foamtex
