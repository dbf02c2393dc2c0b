#pragma once

#include "texgen/image/color.h"

#include <array>
#include <cstdint>
#include <span>
#include <string_view>

namespace foam::texgen {

/// The 256 entries of a colour map, 0xRRGGBB in sRGB.
using ColorTable = std::array<std::uint32_t, 256>;

/// A ramp of colours over [0, 1].
class ColorMap {
  public:
    /// Borrows the table, which has to outlive the map.
    explicit constexpr ColorMap(const ColorTable& table) : table_(&table) {}

    /// Entry i, 0 <= i < 256.
    Srgb8 entry(int i) const;

    /// The colour at t, clamped to [0, 1]; NaN counts as 0. Between two entries it is interpolated
    /// in sRGB, the space in which the maps are designed to run evenly to the eye; light would bend
    /// them.
    LinearRgb at(double t) const;

  private:
    const ColorTable* table_;
};

/// Throws std::invalid_argument that lists the names there are.
const ColorMap& find_colormap(std::string_view name);

std::span<const std::string_view> colormap_names();

}  // namespace foam::texgen
