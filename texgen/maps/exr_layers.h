#pragma once

#include "texgen/image/exr.h"
#include "texgen/maps/map_image.h"

#include <cstdint>
#include <deque>
#include <span>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace foam::texgen {

/// Maps as the channels of an EXR: colours as light from 0 to 1, multiplied by their opacity, in
/// half; numbers in their own unit; ids as integers.
class ExrLayers {
  public:
    /// `numbers` is what numbers are stored as.
    explicit ExrLayers(ExrType numbers) : numbers_(numbers) {}

    /// Takes a map in. `names` of its channels, with spaces between; an opacity is A. They lie in
    /// the layer, or in none if that has no name.
    void add(std::string_view layer, std::string_view names, MapImage map);

    /// All channels so far; borrowed.
    std::span<const ExrChannel> channels() const { return channels_; }

    /// Whether there are colours among them.
    bool has_colors() const { return has_colors_; }

  private:
    using Pixels = std::variant<Image<float>, Image<std::uint32_t>>;

    ExrType type_of(const MapImage& map) const;

    ExrType numbers_;
    bool has_colors_ = false;
    std::deque<Pixels> pixels_;  // stay where they are
    std::vector<ExrChannel> channels_;
};

/// Straight colours of a scale to 65535 as EXR has them: from 0 to 1, multiplied by their opacity.
Image<float> premultiplied(const ColorPixels& colors);

}  // namespace foam::texgen
