// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "texgen/maps/packing.h"

#include <cstddef>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace foam::texgen {

/// An image that is drawn for every frame: a map, or a packing of channels of several maps.
class DrawnImage {
  public:
    /// The image of a map that is drawn with the given options.
    DrawnImage(const Map& map, const MapOptions& options);
    explicit DrawnImage(Packing packing);

    /// Returns the name, unit, channels and bits of the image. For a map, these are its
    /// drawn_traits (all_maps.h). The result is valid as long as this object or a copy of it
    /// exists.
    const MapTraits& traits() const;
    std::string_view name() const { return traits().name; }

    /// Returns the map, or nullptr for a packing.
    const Map* map() const { return packed_ ? nullptr : maps_.front(); }
    /// Returns the maps whose samples the image contains, each once. A packing of constants has
    /// none.
    std::span<const Map* const> sources() const { return maps_; }
    /// Returns the texts of the channels of a packing (PackedChannel::text); empty for a map.
    std::vector<std::string> packed_channels() const;
    /// Returns the indices of the channels whose map has a key for its range (Map::full_key).
    std::vector<std::size_t> ranged_channels() const;
    /// Returns the keys of the ranges of the maps in the image, such as "height.full", each once.
    std::vector<std::string_view> range_keys() const;
    /// Returns what a channel of a packing contains, or nullptr if the image has no such channel or
    /// is a map.
    const PackedChannel* packed_channel(std::size_t channel) const;
    /// Returns true if the image is a packing of colors (Packing::is_color).
    bool packs_colors() const { return packed_ && packed_->packing.is_color; }

    /// Draws the image of a frame with the given content.
    MapImage draw(ShownLayers& content, const MapOptions& options) const;

    /// Returns the text of Map::note, or, for a packing, a list of its channels with the ranges of
    /// their maps, followed by the notes of these maps. May be empty for a map.
    std::string note(const MapOptions& options) const;

  private:
    struct Packed {
        explicit Packed(Packing source);

        Packing packing;
        MapTraits traits;  // refers to the name in `packing`
    };

    std::vector<const Map*> maps_;
    const MapTraits* map_traits_ = nullptr;  // nullptr for a packing
    std::shared_ptr<const Packed> packed_;   // nullptr for a map
};

}  // namespace foam::texgen
