// SPDX-License-Identifier: Apache-2.0

#include "texgen/image/colormap.h"

#include "texgen/image/colormap_tables.h"

#include <fmt/core.h>
#include <fmt/format.h>

#include <algorithm>
#include <cassert>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <stdexcept>

namespace foam::texgen {

namespace {

constexpr int kLastEntry = 255;

constexpr ColorTable gray_table() {
    ColorTable table{};
    for (std::size_t i = 0; i < table.size(); ++i) {
        table[i] = static_cast<std::uint32_t>(i * 0x010101);
    }
    return table;
}

constexpr ColorTable kGray = gray_table();

// The names of the color maps, and the color maps in the same order.
constexpr std::array<std::string_view, 8> kNames = {
    "viridis", "magma", "inferno", "plasma", "cividis", "grey", "labyrinth_blue", "sea_water"};
constexpr std::array<ColorMap, kNames.size()> kMaps = {ColorMap(kViridis),
                                                       ColorMap(kMagma),
                                                       ColorMap(kInferno),
                                                       ColorMap(kPlasma),
                                                       ColorMap(kCividis),
                                                       ColorMap(kGray),
                                                       ColorMap(kLabyrinthBlue),
                                                       ColorMap(kSeaWater)};

/// Interpolates between two sRGB codes and returns the result as linear light.
double mixed(int from, int to, double weight) {
    return srgb_to_linear((from + weight * (to - from)) / 255.0);
}

}  // namespace

Srgb8 ColorMap::entry(int i) const {
    assert(i >= 0 && i <= kLastEntry);
    const std::uint32_t packed = (*table_)[static_cast<std::size_t>(i)];
    return {static_cast<std::uint8_t>(packed >> 16),
            static_cast<std::uint8_t>((packed >> 8) & 0xff),
            static_cast<std::uint8_t>(packed & 0xff)};
}

LinearRgb ColorMap::at(double t) const {
    const double position = kLastEntry * std::clamp(std::isnan(t) ? 0.0 : t, 0.0, 1.0);
    const int below = std::min(static_cast<int>(position), kLastEntry - 1);
    const double weight = position - below;
    const Srgb8 a = entry(below);
    const Srgb8 b = entry(below + 1);
    return {mixed(a.r, b.r, weight), mixed(a.g, b.g, weight), mixed(a.b, b.b, weight)};
}

const ColorMap& find_colormap(std::string_view name) {
    const auto index = static_cast<std::size_t>(
        std::distance(kNames.begin(), std::find(kNames.begin(), kNames.end(), name)));
    if (index == kNames.size()) {
        throw std::invalid_argument(
            fmt::format("colormap '{}': must be one of {}", name, fmt::join(kNames, ", ")));
    }
    return kMaps[index];
}

std::span<const std::string_view> colormap_names() {
    return kNames;
}

}  // namespace foam::texgen
