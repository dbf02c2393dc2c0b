// SPDX-License-Identifier: Apache-2.0

#include "texgen/image/colormap.h"

#include "core/geometry/trigonometric.h"
#include "texgen/image/brewer_colors.h"
#include "texgen/image/colormap_tables.h"
#include "texgen/image/hue_tables.h"

#include <fmt/core.h>
#include <fmt/format.h>

#include <algorithm>
#include <cassert>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <numbers>
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

// Rounds a number that is not negative to the nearest integer; std::lround is not constexpr.
constexpr std::uint32_t rounded(double value) {
    const double raised = value + 0.5;
    return static_cast<std::uint32_t>(raised);
}

// Interpolates evenly spaced colors in sRGB.
template <std::size_t count>
constexpr ColorTable interpolated(const std::array<std::uint32_t, count>& colors) {
    ColorTable table{};
    for (std::size_t i = 0; i < table.size(); ++i) {
        const double position = static_cast<double>(i * (count - 1)) / kLastEntry;
        const std::size_t below = std::min(static_cast<std::size_t>(position), count - 2);
        const double part = position - static_cast<double>(below);
        for (const std::uint32_t shift : {16U, 8U, 0U}) {
            const double from = (colors[below] >> shift) & 0xffU;
            const double to = (colors[below + 1] >> shift) & 0xffU;
            table[i] |= rounded(from + part * (to - from)) << shift;
        }
    }
    return table;
}

constexpr ColorTable kSpectralTable = interpolated(kSpectral);
constexpr ColorTable kRdBuTable = interpolated(kRdBu);
constexpr ColorTable kRdYlBuTable = interpolated(kRdYlBu);
constexpr ColorTable kBrBGTable = interpolated(kBrBG);
constexpr ColorTable kPuOrTable = interpolated(kPuOr);
constexpr ColorTable kYlGnBuTable = interpolated(kYlGnBu);
constexpr ColorTable kYlOrRdTable = interpolated(kYlOrRd);
constexpr ColorTable kBluesTable = interpolated(kBlues);
constexpr ColorTable kGreensTable = interpolated(kGreens);

// Returns the color map cubehelix, a helix around the gray axis. It has the parameters of its
// author: start = 0.5, rotations = -1.5, hue = 1 and gamma = 1. Source: D. A. Green, "A colour
// scheme for the display of astronomical intensity images", 2011.
ColorTable cubehelix_table() {
    constexpr double kStart = 0.5;
    constexpr double kRotations = -1.5;
    ColorTable table{};
    for (std::size_t i = 0; i < table.size(); ++i) {
        const double gray = static_cast<double>(i) / kLastEntry;
        const double radius = 0.5 * gray * (1.0 - gray);
        const ieee::SineAndCosine turn =
            ieee::sincos(2.0 * std::numbers::pi * (kStart / 3.0 + 1.0 + kRotations * gray));
        const auto code = [&](double along_cosine, double along_sine) {
            const double value =
                gray + radius * (along_cosine * turn.cosine + along_sine * turn.sine);
            return rounded(255.0 * std::clamp(value, 0.0, 1.0));
        };
        table[i] =
            code(-0.14861, 1.78277) << 16U | code(-0.29227, -0.90649) << 8U | code(1.97294, 0.0);
    }
    return table;
}

const ColorTable cubehelix_colors = cubehelix_table();

// The names of the color maps, and the color maps in the same order.
constexpr std::array<std::string_view, 20> kNames = {
    "viridis",   "magma", "inferno",   "plasma", "cividis", "grey",    "labyrinth_blue",
    "sea_water", "turbo", "cubehelix", "Blues",  "Greens",  "YlGnBu",  "YlOrRd",
    "Spectral",  "RdBu",  "RdYlBu",    "BrBG",   "PuOr",    "twilight"};
constexpr std::array<ColorMap, kNames.size()> kMaps = {
    ColorMap(kViridis),         ColorMap(kMagma),       ColorMap(kInferno),
    ColorMap(kPlasma),          ColorMap(kCividis),     ColorMap(kGray),
    ColorMap(kLabyrinthBlue),   ColorMap(kSeaWater),    ColorMap(kTurbo),
    ColorMap(cubehelix_colors), ColorMap(kBluesTable),  ColorMap(kGreensTable),
    ColorMap(kYlGnBuTable),     ColorMap(kYlOrRdTable), ColorMap(kSpectralTable),
    ColorMap(kRdBuTable),       ColorMap(kRdYlBuTable), ColorMap(kBrBGTable),
    ColorMap(kPuOrTable),       ColorMap(kTwilight)};

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
