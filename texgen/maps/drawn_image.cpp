// SPDX-License-Identifier: Apache-2.0

#include "texgen/maps/drawn_image.h"

#include "texgen/maps/all_maps.h"

#include <fmt/core.h>

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <utility>

namespace foam::texgen {

namespace {

constexpr std::string_view kChannelNames = "RGBA";

// Returns a text that says what a channel of a packed image contains. If the map of the channel has
// a key for its range, the text also gives the value of this key: "height with height.full = 0.63".
std::string describe(const PackedChannel& channel, const MapOptions& options) {
    const AutoReal* const range =
        channel.map != nullptr ? range_option_of(*channel.map, options) : nullptr;
    return range == nullptr
               ? channel.text
               : fmt::format("{} with {} = {}", channel.text, channel.map->full_key, range->value);
}

}  // namespace

DrawnImage::Packed::Packed(Packing source)
    : packing(std::move(source)),
      traits{.name = packing.name,
             .meaning = "channels of several maps",
             .unit = packing.is_color ? "light" : "0 to 1",
             .channels = packing.channels.size() > 3 ? "R G B A" : "R G B",
             .kind = packing.is_color ? MapKind::Color : MapKind::Number,
             .png_bits = packing.bits,
             .png_filter = PngFilter::Up} {}

DrawnImage::DrawnImage(const Map& map, const MapOptions& options)
    : maps_{&map}, map_traits_(&drawn_traits(map, options)) {}

DrawnImage::DrawnImage(Packing packing)
    : maps_(maps_in(packing)), packed_(std::make_shared<Packed>(std::move(packing))) {}

const MapTraits& DrawnImage::traits() const {
    return packed_ ? packed_->traits : *map_traits_;
}

std::vector<std::string> DrawnImage::packed_channels() const {
    std::vector<std::string> texts;
    if (packed_) {
        std::ranges::transform(
            packed_->packing.channels, std::back_inserter(texts), &PackedChannel::text);
    }
    return texts;
}

std::vector<std::size_t> DrawnImage::ranged_channels() const {
    std::vector<std::size_t> channels;
    const auto count = static_cast<std::size_t>(channel_count(traits()));
    for (std::size_t k = 0; k < count; ++k) {
        const PackedChannel* const packed = packed_channel(k);
        const Map* const map = packed != nullptr ? packed->map : this->map();
        if (map != nullptr && !map->full_key.empty()) {
            channels.push_back(k);
        }
    }
    return channels;
}

std::vector<std::string_view> DrawnImage::range_keys() const {
    std::vector<std::string_view> keys;
    for (const Map* const map : maps_) {
        if (!map->full_key.empty()) {
            keys.push_back(map->full_key);
        }
    }
    return keys;
}

const PackedChannel* DrawnImage::packed_channel(std::size_t channel) const {
    return packed_ && channel < packed_->packing.channels.size()
               ? &packed_->packing.channels[channel]
               : nullptr;
}

MapImage DrawnImage::draw(ShownLayers& content, const MapOptions& options) const {
    return packed_ ? draw_packed(packed_->packing, content, options)
                   : texgen::draw(*maps_.front(), content, options);
}

std::string DrawnImage::note(const MapOptions& options) const {
    if (!packed_) {
        return maps_.front()->note != nullptr ? maps_.front()->note(options) : "";
    }
    std::string text;
    for (std::size_t k = 0; k < packed_->packing.channels.size(); ++k) {
        text += fmt::format("{}{}: {}",
                            k > 0 ? "; " : "",
                            kChannelNames[k],
                            describe(packed_->packing.channels[k], options));
    }
    for (const Map* const map : maps_) {
        text += map->note != nullptr ? fmt::format("; {}", map->note(options)) : "";
    }
    return text;
}

}  // namespace foam::texgen
