// SPDX-License-Identifier: Apache-2.0

#include "core/library/foam_records.h"
#include "texgen/api/frame_images.h"
#include "texgen/api/public_errors.h"
#include "texgen/api/state.h"

#include <foamtex/texture.h>

#include <algorithm>
#include <variant>

namespace foamtex {

namespace {

using foam::texgen::Image;
using foam::texgen::with_texture_errors;

// Copies an image, whose row 0 is the bottom row, to a buffer whose first row is the top row.
template <class Sample>
void copy_from_top(const Image<Sample>& image, std::span<Sample> samples) {
    if (samples.size() != image.samples().size()) {
        throw ArgumentError("the buffer must have " + std::to_string(image.samples().size()) +
                            " samples, but has " + std::to_string(samples.size()));
    }
    auto to = samples.begin();
    for (int y = image.height() - 1; y >= 0; --y) {
        to = std::ranges::copy(image.row(y), to).out;
    }
}

template <class Sample>
void draw_codes(const Frame::State& frame,
                const std::string& map,
                std::span<Sample> samples,
                int threads) {
    with_texture_errors(
        [&] { copy_from_top(foam::texgen::code_image<Sample>(frame, map, threads), samples); });
}

}  // namespace

int Frame::number() const {
    return state_->simulated.frame->number;
}

double Frame::time() const {
    return state_->simulated.frame->time;
}

Extent Frame::extent() const {
    return foam::extent_of(state_->simulated.frame->domain);
}

double Frame::energy() const {
    return state_->simulated.effort.energy;
}

std::vector<Event> Frame::events() const {
    return foam::event_records(state_->simulated.effort.events);
}

Stress Frame::stress() const {
    return foam::stress_record(state_->simulated.effort.stress);
}

const FoamRecords& Frame::records() const {
    std::call_once(state_->has_records,
                   [&] { state_->records = foam::records_of(*state_->simulated.frame); });
    return state_->records;
}

ImageShape Frame::shape(const std::string& map, bool integers) const {
    return with_texture_errors([&] { return foam::texgen::shape_of(*state_, map, integers); });
}

void Frame::draw(const std::string& map, std::span<float> samples, int threads) const {
    with_texture_errors(
        [&] { copy_from_top(foam::texgen::number_image(*state_, map, threads), samples); });
}

void Frame::draw(const std::string& map, std::span<std::uint8_t> samples, int threads) const {
    draw_codes(*state_, map, samples, threads);
}

void Frame::draw(const std::string& map, std::span<std::uint16_t> samples, int threads) const {
    draw_codes(*state_, map, samples, threads);
}

}  // namespace foamtex
