// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "texgen/image/color.h"

#include <array>
#include <cstdint>
#include <span>
#include <string_view>

namespace foam::texgen {

/// The 256 entries of a color map. An entry is an sRGB color in the form 0xRRGGBB.
using ColorTable = std::array<std::uint32_t, 256>;

/// A color map: a function from [0, 1] to colors that interpolates between the entries of a table.
class ColorMap {
  public:
    /// Borrows the table, which must outlive the map.
    explicit constexpr ColorMap(const ColorTable& table) : table_(&table) {}

    /// Returns entry i. Precondition: 0 <= i < 256.
    Srgb8 entry(int i) const;

    /// Returns the color at t. t is clamped to [0, 1]; NaN counts as 0. Two neighboring entries are
    /// interpolated in sRGB, not in linear light, because steps in sRGB look more uniform.
    LinearRgb at(double t) const;

  private:
    const ColorTable* table_;
};

/// Returns the color map with the given name. Throws std::invalid_argument for an unknown name; the
/// message lists all names.
const ColorMap& find_colormap(std::string_view name);

/// Returns the names of all color maps.
std::span<const std::string_view> colormap_names();

}  // namespace foam::texgen
