// SPDX-License-Identifier: Apache-2.0

#include "texgen/studio/picture.h"

#include "core/parallel/parallel_for.h"
#include "texgen/animation/drawable_frame.h"
#include "texgen/bake/fitted_ranges.h"
#include "texgen/bake/frame_range.h"
#include "texgen/bake/reduced_image.h"
#include "texgen/image/pixel_hash.h"
#include "texgen/maps/all_maps.h"
#include "texgen/maps/number_extent.h"
#include "texgen/maps/quantize.h"
#include "texgen/preset/preset_io.h"
#include "texgen/preset/preset_keys.h"
#include "texgen/preset/simulation_keys.h"
#include "texgen/studio/samples.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <span>
#include <utility>
#include <variant>
#include <vector>

namespace foam::texgen {

namespace {

// The data that the maps of a frame share is kept for several frames. The pictures of these frames
// together have at most this number of pixels, except that the newest data is always kept.
constexpr std::size_t kMaxKeptPixels = 4UL * 1024 * 1024;
// The largest number of pictures that are drawn from the same kept data. Each picture may add to
// the data, because some of the data depends on options, such as the width of films.
constexpr int kMaxUses = 64;
constexpr std::size_t kMaxRanges = 1000;  // largest number of remembered ranges

/// Changes the range of an image so that the range contains all numbers of the image, as
/// fit_automatic_ranges does for all frames. `value` is the present value of the option that sets
/// the range.
void fit_to_picture(NumberPixels& numbers, double value) {
    const NumberExtent extent = extent_of(numbers);
    const double largest =
        std::max(std::abs(extent.smallest), std::abs(extent.largest)) / numbers.high;
    const double factor = fitted_range(value, largest) / value;
    numbers.low *= factor;
    numbers.high *= factor;
}

DistanceNeeds joined(const DistanceNeeds& a, const DistanceNeeds& b) {
    return {.distance = a.distance || b.distance,
            .gradient = a.gradient || b.gradient,
            .smooth = std::max(a.smooth, b.smooth)};
}

bool includes(const DistanceNeeds& all, const DistanceNeeds& some) {
    return (all.distance || !some.distance) && (all.gradient || !some.gradient) &&
           all.smooth >= some.smooth;
}

}  // namespace

// A frame on a grid, and the data that its maps share. `drawable` refers to `frame`, so objects are
// neither copied nor moved.
struct Painter::SharedData {
    SharedData(SimulatedFrame simulated, const RasterGrid& grid, const DistanceNeeds& distance)
        : frame(std::move(simulated)),
          needs(distance),
          drawable(frame, grid, distance, thread_count(0)) {}

    std::size_t pixels() const {
        const RasterGrid& grid = drawable.layers().layers.grid();
        return static_cast<std::size_t>(grid.width) * static_cast<std::size_t>(grid.height);
    }

    SimulatedFrame frame;
    DistanceNeeds needs;
    DrawableFrame drawable;
    int uses = 0;      // number of further pictures that were drawn from the data
    std::mutex mutex;  // held while a map is drawn
};

struct Painter::DrawnMap {
    MapImage image;
    bool is_exact = false;
    std::optional<double> unit_width = {};  // of the map `height`: its unit in image widths
};

Painter::Painter(FrameStore& store) : store_(store) {}
Painter::~Painter() = default;

std::shared_ptr<Painter::SharedData> Painter::shared_data(const Preset& preset,
                                                          const PictureRequest& request) {
    const bool is_draft = request.quality == PictureQuality::Draft;
    const ReducedImage reduced = reduced_image(preset, request.side);
    const std::string key = fmt::format("{} {} {} {}x{} {} {} {} {}",
                                        simulation_hash(preset),
                                        is_draft,
                                        request.frame,
                                        reduced.width,
                                        reduced.height,
                                        preset.camera.center[0],
                                        preset.camera.center[1],
                                        preset.camera.zoom,
                                        preset.camera.margin);
    const std::vector<std::string> names = {request.map};
    DistanceNeeds needs = distance_needs(names, preset.maps);
    NextFrames next_frames =
        find_map(request.map).needs_next ? NextFrames::Included : NextFrames::Omitted;
    {
        const std::scoped_lock lock(mutex_);
        const auto found = std::ranges::find(
            kept_, key, [](const auto& one) { return std::string_view(one.first); });
        if (found != kept_.end()) {
            std::shared_ptr<SharedData> kept = found->second;
            const bool has_next = kept->frame.next != nullptr;
            if (includes(kept->needs, needs) && ++kept->uses < kMaxUses &&
                (has_next || next_frames == NextFrames::Omitted)) {
                kept_.splice(kept_.begin(), kept_, found);
                return kept;
            }
            needs = joined(needs, kept->needs);
            next_frames = has_next ? NextFrames::Included : next_frames;
            kept_.erase(found);
        }
    }
    SimulatedFrame frame = is_draft
                               ? store_.draft(preset)
                               : store_.frame(preset, request.frame, next_frames, request.page);
    const RasterGrid grid = reduced.grid(frame.view);
    auto made = std::make_shared<SharedData>(std::move(frame), grid, needs);
    const std::scoped_lock lock(mutex_);
    kept_.emplace_front(key, made);
    std::size_t pixels = 0;
    kept_.remove_if([&](const auto& one) {
        pixels += one.second->pixels();
        return pixels > kMaxKeptPixels && one.second != made;
    });
    return made;
}

// If the map has an automatic range, stores the fitted value of the range in the options. Returns
// false if this value is neither known nor can be found; the options are then unchanged.
bool Painter::fit_range(const Preset& preset, const PictureRequest& request, MapOptions& options) {
    const Map& map = find_map(request.map);
    AutoReal* const range = range_option_of(map, options);
    if (range == nullptr || !range->is_automatic) {
        return true;
    }
    Preset measured = preset;
    measured.image.maps = {request.map};
    measured.output = {};
    const std::string key = simulation_hash(preset) + request.map +
                            text_hash(to_toml(measured) + file_hashes(measured));
    const auto is_known = [&] {
        const std::scoped_lock lock(mutex_);
        const auto found = ranges_.find(key);
        if (found != ranges_.end()) {
            range->value = found->second;
        }
        return found != ranges_.end();
    };
    if (is_known()) {
        return true;
    }
    if (request.quality != PictureQuality::Exact) {
        return false;
    }
    // A page requests several exact pictures at once. The first request fits the range for all.
    const std::scoped_lock fitting(fitting_mutex_);
    if (is_known()) {
        return true;
    }
    const FrameSource source = store_.source(preset);
    if (!source) {
        return false;
    }
    fit_automatic_ranges(measured, source, frames_to(preset.frames.count), 0);
    range->value = range_option_of(map, measured.maps)->value;
    const std::scoped_lock lock(mutex_);
    if (ranges_.size() >= kMaxRanges) {
        ranges_.clear();
    }
    ranges_[key] = range->value;
    return true;
}

Painter::DrawnMap Painter::draw_map(const Preset& preset,
                                    const PictureRequest& request,
                                    SharedData& frame) {
    ReducedImage reduced = reduced_image(preset, request.side);
    const bool has_range = fit_range(preset, request, reduced.options);
    const Map& map = find_map(request.map);
    const std::scoped_lock lock(frame.mutex);
    DrawnMap drawn{texgen::draw(map, frame.drawable.layers(), reduced.options), has_range};
    if (!has_range) {
        fit_to_picture(std::get<NumberPixels>(drawn.image),
                       range_option_of(map, reduced.options)->value);
    }
    if (map.name == kHeightMap.name) {
        drawn.unit_width = height_unit(frame.drawable.layers().layers, reduced.options.relief);
    }
    drawn.is_exact = has_range && request.quality != PictureQuality::Draft;
    return drawn;
}

HttpResponse Painter::draw(const Preset& preset, const PictureRequest& request) {
    const std::shared_ptr<SharedData> frame = shared_data(preset, request);
    const DrawnMap map = draw_map(preset, request, *frame);
    const MapSize size = size_of(map.image);
    const auto* const numbers = std::get_if<NumberPixels>(&map.image);
    const Json header = {{"width", size.width},
                         {"height", size.height},
                         {"channels", request.floats ? size.channels : kRgba},
                         {"frame", request.frame},
                         {"exact", map.is_exact},
                         {"unit_width", number_or_null(map.unit_width)},
                         {"low", numbers != nullptr ? Json(numbers->low) : Json(nullptr)},
                         {"high", numbers != nullptr ? Json(numbers->high) : Json(nullptr)}};
    HttpResponse response{.content_type = "application/octet-stream",
                          .headers = {{"X-Foamtex-Picture", json_text(header)}}};
    if (request.floats) {
        response.body = floats_from_top(map.image);
    } else {
        constexpr int kBits = 8;
        response.body =
            rgba_from_top(std::get<Image<std::uint8_t>>(quantize(map.image, kBits).codes));
    }
    return response;
}

Json Painter::pick(const Preset& preset, const PictureRequest& request, int x, int y) {
    const std::shared_ptr<SharedData> frame = shared_data(preset, request);
    const DrawnMap map = draw_map(preset, request, *frame);
    const MapSize size = size_of(map.image);
    x = std::clamp(x, 0, size.width - 1);
    const int row = size.height - 1 - std::clamp(y, 0, size.height - 1);
    Json numbers = Json::array();
    for (int channel = 0; channel < size.channels; ++channel) {
        numbers.push_back(number_or_null(number_of(map.image, x, row, channel)));
    }
    Json picked = {{"numbers", numbers},
                   {"unit", drawn_traits(find_map(request.map), preset.maps).unit},
                   {"color", nullptr},
                   {"bubble", nullptr}};
    if (const auto* const colors = std::get_if<ColorPixels>(&map.image)) {
        const Image<std::uint8_t> codes = srgb_codes(*colors);
        const std::span<const std::uint8_t> pixel = codes.pixel(x, row);
        picked["color"] = color_text({pixel[0], pixel[1], pixel[2]});
    }
    const std::scoped_lock lock(frame->mutex);
    FrameLayers& layers = frame->drawable.layers().layers;
    const std::uint32_t id = layers.distance().ids.pixel(x, row)[0];
    const Frame& foam = layers.frame();
    if (id < foam.bubbles.size()) {
        const BubbleId bubble{id};
        const FrameBubble& found = foam.bubbles[bubble];
        picked["bubble"] = {{"id", found.identity},
                            {"area", found.area},
                            {"target_area", found.target_area},
                            {"sides", foam.network.sides(bubble)},
                            {"pressure", found.pressure}};
    }
    return picked;
}

}  // namespace foam::texgen
