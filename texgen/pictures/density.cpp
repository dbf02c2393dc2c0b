// SPDX-License-Identifier: Apache-2.0

#include "texgen/pictures/density.h"

#include "core/foam/random.h"
#include "core/geometry/elementary.h"
#include "texgen/image/format.h"
#include "texgen/keys/value_kinds.h"
#include "texgen/pictures/tone_grid.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <limits>
#include <numbers>
#include <span>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

namespace foam::texgen {

namespace {

constexpr std::array<std::string_view, 4> kBuiltIn{"even", "gradient", "radial", "noise"};
// A picture is reduced to a grid of cells. The largest number of cells along its longer side:
constexpr int kMaxSeedingCells = 1024;  // for the density of the seeded bubbles
constexpr int kMaxEdgeCells = 256;      // for the comparison of opposite edges
// The number of cells along the longer side of a density that is built in.
constexpr int kBuiltInCells = 512;
constexpr int kOctaves = 3;  // number of octaves of the noise
// A picture may be stretched by this factor in one direction without a remark.
constexpr double kUnnoticedStretch = 1.02;

// The kind of values of foam.density.
struct DensitySources {
    std::string allowed() const {
        return fmt::format(
            "\"even\", \"gradient\", \"radial\", \"noise\", or the path of a picture, which ends "
            "in {}",
            format_suffixes());
    }
    std::string schema() const {
        return fmt::format(R"({{"type": "string", "pattern": "^({})$|{}$"}})",
                           fmt::join(kBuiltIn, "|"),
                           picture_suffix_pattern());
    }
    std::span<const std::string_view> words() const { return kBuiltIn; }
    bool read(const Value& value, DensitySource& member) const {
        const auto* const text = std::get_if<std::string>(&value.data);
        if (text == nullptr) {
            return false;
        }
        if (std::ranges::find(kBuiltIn, *text) != kBuiltIn.end()) {
            member = {*text, {}};
            return true;
        }
        DensitySource source{*text, {}};
        const bool allowed = is_picture_name(*text) && PictureFiles{}.read(value, source.picture);
        member = allowed ? source : member;
        return allowed;
    }
    Value write(const DensitySource& member) const { return {member.name}; }
    std::optional<NamedFile> file(const DensitySource& member) const {
        return PictureFiles{}.file(member.picture);
    }
    std::string fault(const Value& value) const {
        const auto* const text = std::get_if<std::string>(&value.data);
        return text != nullptr && is_picture_name(*text) ? PictureFiles{}.fault(value) : "";
    }
};

// A function that returns the darkness at a point of the rectangle of the foam (DensityDomain).
// Both coordinates run from 0 to 1 across the rectangle.
using Tone = std::function<double(double x, double y)>;

// Returns (1 - cos(2 pi x)) / 2, which is 0 at both edges and 1 in the middle.
double wave(double x) {
    return 0.5 - 0.5 * ieee::cos(2.0 * std::numbers::pi * x);
}

Tone gradient(bool is_torus) {
    return [is_torus](double, double y) { return is_torus ? wave(y) : 1.0 - y; };
}

Tone radial(bool is_torus) {
    return [is_torus](double x, double y) {
        const double distance = 2.0 * Vec2(x - 0.5, y - 0.5).norm();
        return is_torus ? wave(x) * wave(y) : std::max(0.0, 1.0 - distance);
    };
}

// Value noise that is periodic across the rectangle: random values at the points of a lattice,
// which quintic polynomials interpolate.
class LatticeNoise {
  public:
    LatticeNoise(int columns, int rows, Random& random)
        : columns_(columns),
          values_(static_cast<std::size_t>(columns) * static_cast<std::size_t>(rows)),
          rows_(rows) {
        for (double& value : values_) {
            value = random.uniform();
        }
    }

    double at(double x, double y) const {
        const double column = std::floor(x * columns_);
        const double row = std::floor(y * rows_);
        const double u = quintic(x * columns_ - column);
        const double v = quintic(y * rows_ - row);
        const int i = static_cast<int>(column);
        const int j = static_cast<int>(row);
        const double lower = value(i, j) + u * (value(i + 1, j) - value(i, j));
        const double upper = value(i, j + 1) + u * (value(i + 1, j + 1) - value(i, j + 1));
        return lower + v * (upper - lower);
    }

  private:
    static double quintic(double t) { return t * t * t * (t * (t * 6.0 - 15.0) + 10.0); }
    double value(int column, int row) const {
        return values_[static_cast<std::size_t>(row % rows_) * static_cast<std::size_t>(columns_) +
                       static_cast<std::size_t>(column % columns_)];
    }

    int columns_;
    std::vector<double> values_;
    int rows_;
};

// Returns the sum of several octaves of noise (kOctaves). The features of each further octave have
// half the size and half the height of those of the octave before.
Tone noise(const DensityOptions& options, double aspect) {
    Random random(static_cast<std::uint64_t>(options.noise_seed));
    // The size of the rectangle, in units of its shorter side.
    const double width = std::max(aspect, 1.0);
    const double height = std::max(1.0 / aspect, 1.0);
    std::vector<LatticeNoise> octaves;
    for (int k = 0; k < kOctaves; ++k) {
        const auto cells = [&](double extent) {
            const double features = std::ldexp(options.noise_scale * extent, k);
            return std::max(1, static_cast<int>(std::lround(features)));
        };
        octaves.emplace_back(cells(width), cells(height), random);
    }
    return [octaves](double x, double y) {
        double sum = 0.0;
        for (std::size_t k = 0; k < octaves.size(); ++k) {
            sum += std::ldexp(octaves[k].at(x, y), -static_cast<int>(k));
        }
        return sum;
    };
}

Tone built_in_tone(const DensityOptions& options, const DensityDomain& domain) {
    if (options.source.name == "gradient") {
        return gradient(domain.is_torus);
    }
    if (options.source.name == "radial") {
        return radial(domain.is_torus);
    }
    return noise(options, domain.aspect);
}

ToneGrid built_in_tones(const DensityOptions& options, const DensityDomain& domain) {
    // Returns the number of cells along a side. `ratio` is this side divided by the other side.
    const auto cells = [](double ratio) {
        return std::max(1, static_cast<int>(std::lround(kBuiltInCells * std::min(1.0, ratio))));
    };
    ToneGrid grid(cells(domain.aspect), cells(1.0 / domain.aspect), 1);
    const Tone tone = built_in_tone(options, domain);
    for (int row = 0; row < grid.height(); ++row) {
        for (int column = 0; column < grid.width(); ++column) {
            grid.pixel(column, row)[0] =
                tone((column + 0.5) / grid.width(), (row + 0.5) / grid.height());
        }
    }
    return grid;
}

ToneGrid picture_tones(const DensityOptions& options, bool is_torus) {
    ToneGrid grid = darkness_of(*options.source.picture.picture, kMaxSeedingCells);
    if (is_torus && options.edges == PictureEdges::Mirror) {
        return mirrored(grid);
    }
    if (is_torus && options.edges == PictureEdges::Blend) {
        blend_edges(grid);
    }
    return grid;
}

}  // namespace

Keys<DensityOptions> density_keys() {
    using Options = DensityOptions;
    constexpr Choices<PictureEdges, 3> kEdges = {{{{"keep", PictureEdges::Keep},
                                                   {"mirror", PictureEdges::Mirror},
                                                   {"blend", PictureEdges::Blend}}}};
    constexpr Choices<bool> kSwitch = {{{{"on", true}, {"off", false}}}};
    constexpr std::int64_t kMaxSeed = std::numeric_limits<std::int64_t>::max();
    return {
        key("density",
            DensitySources{},
            "where the seeded bubbles are small; path of a picture: where the picture is dark; "
            "gradient: in the middle of the height of a torus, at the bottom of a patch; radial: "
            "in the middle; noise: in random places; even: nowhere, because the mean size is the "
            "same everywhere. With any value but even, foam.area_ratio is the ratio of the largest "
            "to the smallest area among the bubbles near one place, not of the whole foam",
            &Options::source)
            .with_files(is_picture_name),
        key("density_ratio",
            Reals{1.0, 400.0},
            "ratio of the largest to the smallest bubble area of the density",
            &Options::ratio)
            .unused_with("foam.density", {"even"}),
        key("density_invert",
            kSwitch,
            "on: exchanges the places of large and of small bubbles",
            &Options::is_inverted)
            .unused_with("foam.density", {"even"}),
        key("density_edges",
            kEdges,
            "edges of a picture on a torus: keep leaves a step if the picture does not tile; "
            "mirror adds mirror images, so that it appears four times; blend adjusts the tones "
            "near the edges",
            &Options::edges)
            .unused_with("foam.density", {kBuiltIn.begin(), kBuiltIn.end()}),
        key("density_scale",
            Reals{0.5, 100.0},
            "number of features of the noise along the shorter side",
            &Options::noise_scale)
            .in("features along the shorter side")
            .used_with("foam.density", {"noise"}),
        key("density_seed", Integers{0, kMaxSeed}, "seed of the noise", &Options::noise_seed)
            .used_with("foam.density", {"noise"})};
}

std::optional<AreaField> area_field_of(const DensityOptions& options, const DensityDomain& domain) {
    if (options.source.name == "even") {
        return std::nullopt;
    }
    ToneGrid grid = options.source.picture.is_set() ? picture_tones(options, domain.is_torus)
                                                    : built_in_tones(options, domain);
    stretch_tones(grid);
    const double min_root = 1.0 / std::sqrt(options.ratio);
    std::vector<double> areas;
    areas.reserve(grid.samples().size());
    for (const double tone : grid.samples()) {
        const double root = min_root + (1.0 - min_root) * (options.is_inverted ? 1.0 - tone : tone);
        areas.push_back(1.0 / (root * root));
    }
    return AreaField(grid.width(), grid.height(), std::move(areas));
}

std::vector<std::string> density_remarks(const DensityOptions& options,
                                         const DensityDomain& domain) {
    std::vector<std::string> remarks;
    if (!options.source.picture.is_set()) {
        return remarks;
    }
    const SourcePicture& picture = *options.source.picture.picture;
    const double stretch = domain.aspect * picture.height() / picture.width();
    if (std::max(stretch, 1.0 / stretch) > kUnnoticedStretch) {
        remarks.push_back(
            fmt::format("foam.density: '{}' of {} x {} pixels is stretched to the aspect ratio of "
                        "the foam, {:.3g}",
                        options.source.name,
                        picture.width(),
                        picture.height(),
                        domain.aspect));
    }
    if (domain.is_torus && options.edges == PictureEdges::Keep &&
        has_visible_edges(darkness_of(picture, kMaxEdgeCells))) {
        remarks.push_back(
            fmt::format("foam.density: '{}' does not tile, because opposite edges differ; "
                        "foam.density_edges = \"blend\" or \"mirror\" avoids the step",
                        options.source.name));
    }
    return remarks;
}

}  // namespace foam::texgen
