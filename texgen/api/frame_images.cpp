// SPDX-License-Identifier: Apache-2.0

#include "texgen/api/frame_images.h"

#include "core/library/require.h"
#include "core/parallel/parallel_for.h"
#include "texgen/animation/drawable_frame.h"
#include "texgen/maps/all_maps.h"
#include "texgen/maps/number_channels.h"
#include "texgen/maps/quantize.h"
#include "texgen/preset/drawn_images.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <stdexcept>
#include <utility>
#include <variant>

namespace foam::texgen {

namespace {

constexpr int kBitsPerByte = 8;

MapImage draw_map(const foamtex::Frame::State& state, const Map& map, int threads) {
    require_threads(threads);
    const Preset& preset = state.preset.state().preset;
    const SimulatedFrame& simulated = state.simulated;
    if (map.needs_next && simulated.next == nullptr) {
        throw std::invalid_argument(
            fmt::format("the map '{0}' needs the next frame; list it in the key image.maps of the "
                        "preset: image.maps=[\"{0}\"]",
                        map.name));
    }
    const std::array names{std::string(map.name)};
    const DistanceNeeds distance = distance_needs(names, preset.maps);
    const RasterGrid grid{preset.image.width, preset.image.height, 0, 0, simulated.view};
    DrawableFrame drawable(simulated, grid, distance, thread_count(threads));
    return draw(map, drawable.layers(), preset.maps);
}

void check_range(const foamtex::Preset::State& state, const Map& map) {
    const AutoReal* const range = range_option_of(map, state.preset.maps);
    if (range == nullptr || !range->is_automatic) {
        return;
    }
    const std::vector<const Map*> fitted = source_maps(state.preset);
    if (!state.has_fitted_ranges || std::ranges::find(fitted, &map) == fitted.end()) {
        throw std::invalid_argument(
            fmt::format("the map '{0}' has an automatic range, which must be fitted before the map "
                        "can be drawn as integers: call fit_ranges on a preset "
                        "whose key image.maps contains the map, or set {1} to a number",
                        map.name,
                        map.full_key));
    }
}

}  // namespace

foamtex::ImageShape shape_of(const foamtex::Frame::State& frame,
                             const std::string& map_name,
                             bool integers) {
    const Preset& preset = frame.preset.state().preset;
    const MapTraits& map = drawn_traits(find_map(map_name), preset.maps);
    const bool has_opacity = map.kind == MapKind::Color && frame.simulated.frame->domain.is_plane();
    int channels = channel_count(map) + (has_opacity ? 1 : 0);
    channels = integers && map.kind == MapKind::Number && channels == 2 ? 3 : channels;
    return {preset.image.width, preset.image.height, channels};
}

Image<float> number_image(const foamtex::Frame::State& frame,
                          const std::string& map_name,
                          int threads) {
    const Map& map = find_map(map_name);
    MapImage image = draw_map(frame, map, threads);
    const MapTraits& traits = drawn_traits(map, frame.preset.state().preset.maps);
    ChannelGroup group =
        number_channels(std::move(image), {"", traits.channels}, SampleType::Float);
    if (auto* const numbers = std::get_if<Image<float>>(&group.samples)) {
        return std::move(*numbers);
    }
    const auto& ids = std::get<Image<std::uint32_t>>(group.samples);
    Image<float> numbers(ids.width(), ids.height(), ids.channels());
    std::ranges::transform(ids.samples(), numbers.samples().begin(), [](std::uint32_t id) {
        return static_cast<float>(id);
    });
    return numbers;
}

template <class Sample>
Image<Sample> code_image(const foamtex::Frame::State& frame,
                         const std::string& map_name,
                         int threads) {
    const Map& map = find_map(map_name);
    const foamtex::Preset::State& preset = frame.preset.state();
    check_range(preset, map);
    constexpr int kBits = kBitsPerByte * static_cast<int>(sizeof(Sample));
    if (drawn_traits(map, preset.preset.maps).kind == MapKind::Color && kBits != kBitsPerByte) {
        throw std::invalid_argument(
            fmt::format("the map '{}' has colors, which a PNG stores with 8 bits", map.name));
    }
    CodedImage coded = quantize(draw_map(frame, map, threads), kBits);
    return std::get<Image<Sample>>(std::move(coded.codes));
}

template Image<std::uint8_t> code_image(const foamtex::Frame::State&, const std::string&, int);
template Image<std::uint16_t> code_image(const foamtex::Frame::State&, const std::string&, int);

}  // namespace foam::texgen
