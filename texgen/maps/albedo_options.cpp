// SPDX-License-Identifier: Apache-2.0

#include "texgen/maps/albedo_options.h"

#include "texgen/image/colormap.h"
#include "texgen/keys/value_kinds.h"
#include "texgen/maps/color_scale.h"
#include "texgen/pictures/palette.h"

#include <fmt/core.h>

#include <numbers>
#include <string_view>
#include <utility>

namespace foam::texgen {

namespace {

// The keys colormap, colors and colors.from exclude each other: the key that is assigned last
// determines the colors. For this reason, setting a color map removes the colors of a preset. An
// empty colors.from removes only colors that were taken from a picture.

// Returns a copy of a key that calls effect(before, options) after its value has been stored in
// `options`. `before` is a copy of the options as they were before the value was stored.
template <class Function>
Key<AlbedoOptions> with_effect(Key<AlbedoOptions> key, const Function& effect) {
    key.read = [read = std::move(key.read), effect](const Value& value, AlbedoOptions& options) {
        const AlbedoOptions before = options;
        if (!read(value, options)) {
            return false;
        }
        effect(before, options);
        return true;
    };
    return key;
}

// If options.colors_from is set, replaces options.colors by the main colors of this picture. If it
// is not set, but before.colors_from is, removes options.colors, which are the main colors of the
// earlier picture.
void update_colors(const AlbedoOptions& before, AlbedoOptions& options) {
    if (before.colors_from.is_set() || options.colors_from.is_set()) {
        options.colors.clear();
    }
    if (!options.colors_from.is_set()) {
        return;
    }
    for (const Srgb8& color : palette_of(*options.colors_from.picture, options.colors_count)) {
        options.colors.push_back(color_text(color));
    }
}

bool is_transparent(const PictureFile& file) {
    return file.is_set() && palette_of(*file.picture, 1).empty();
}

// The kind of values of colors.from: pictures that have a color.
struct ColorPictures : PictureFiles {
    bool read(const Value& value, PictureFile& member) const {
        PictureFile file;
        if (!PictureFiles::read(value, file) || is_transparent(file)) {
            return false;
        }
        member = std::move(file);
        return true;
    }
    std::string fault(const Value& value) const {
        PictureFile file;
        if (PictureFiles::read(value, file) && is_transparent(file)) {
            return fmt::format("'{}' has no colors: it is entirely transparent", file.path);
        }
        return PictureFiles::fault(value);
    }
};

// In the TOML of a preset, albedo.colors is either a list of colors or a table that contains this
// key.
constexpr std::string_view kColorsFrom = "albedo.colors.from";

Keys<AlbedoOptions> color_keys() {
    using Options = AlbedoOptions;
    const auto drop_picture = [](const Options&, Options& options) { options.colors_from = {}; };
    const auto drop_colors = [=](const Options& before, Options& options) {
        options.colors.clear();
        drop_picture(before, options);
    };
    Key<Options> colormap = with_effect(key("colormap",
                                            Words{colormap_names()},
                                            "color map of the bubbles; replaces albedo.colors and "
                                            "albedo.colors.from that were set before",
                                            &Options::colormap),
                                        drop_colors);
    colormap.use = Condition{"albedo.colors", {"[]"}};
    return {std::move(colormap),
            with_effect(key("colors",
                            Gradients{},
                            "list of colors from the start to the end of the scale; replaces an "
                            "albedo.colormap or albedo.colors.from that was set before",
                            &Options::colors),
                        drop_picture)
                .written_if(kColorsFrom, {""}),
            with_effect(key("colors.from",
                            ColorPictures{},
                            "a picture whose main colors, from the darkest to the lightest, are "
                            "the list of colors; replaces an albedo.colormap or albedo.colors that "
                            "were set before",
                            &Options::colors_from),
                        update_colors)
                .with_files(is_picture_name)
                .written_unless(kColorsFrom, {""}),
            with_effect(key("colors.count",
                            Integers{1, 64},
                            "largest number of colors that are taken from the picture",
                            &Options::colors_count)
                            .in("colors"),
                        update_colors)
                .unused_with(kColorsFrom, {""})
                .written_unless(kColorsFrom, {""})};
}

constexpr Choices<ColorBy, 5> kColorBys = {{{{"pressure", ColorBy::Pressure},
                                             {"area", ColorBy::Area},
                                             {"sides", ColorBy::Sides},
                                             {"random", ColorBy::Random},
                                             {"picture", ColorBy::Picture}}}};
constexpr Choices<PictureSampling> kPictureSamplings = {
    {{{"first_frame", PictureSampling::FirstFrame}, {"every_frame", PictureSampling::EveryFrame}}}};
constexpr Choices<ColorMix> kColorMixes = {
    {{{"blend", ColorMix::Blend}, {"pick", ColorMix::Pick}}}};

Keys<AlbedoOptions> color_by_keys() {
    using Options = AlbedoOptions;
    return {
        key("color_by",
            kColorBys,
            "what determines the color of a bubble: its pressure, its area (the mean area has the "
            "middle color), its number of sides (3 to 9), a random value that it keeps for life, "
            "or the "
            "mean color of albedo.picture under it",
            &Options::color_by),
        key("picture",
            PictureFiles{},
            "picture that colors bubbles; it is stretched over the torus, or over the bounding box "
            "of a patch in frame 1",
            &Options::picture)
            .with_files(is_picture_name)
            .used_with("albedo.color_by", {"picture"}),
        key("picture_sampling",
            kPictureSamplings,
            "first_frame: a bubble keeps for life the color under it in frame 1, and bubbles that "
            "are born later take the color under them in each frame; every_frame: all bubbles "
            "take the color under them in each frame",
            &Options::picture_sampling)
            .used_with("albedo.color_by", {"picture"})};
}

Keys<AlbedoOptions> bubble_keys() {
    using Options = AlbedoOptions;
    return {
        key("color_mix",
            kColorMixes,
            "blend interpolates between albedo.colors; pick uses only these colors themselves, "
            "each from its position on the scale to the position of the next color",
            &Options::color_mix)
            .unused_with("albedo.colors", {"[]"}),
        key("variation",
            kFractions,
            "largest random change of brightness of a bubble, as a fraction; constant for its life",
            &Options::variation)
            .in("fraction of the brightness"),
        key("pressure_low", kPressures, "pressure of the first color", &Options::pressure_low)
            .in("film tension / sqrt(mean area of the seeded foam or of the drawn frame), "
                "selected by albedo.pressure_unit")
            .used_with("albedo.color_by", {"pressure"})
            .below("pressure_high"),
        key("pressure_high",
            kPressures,
            "pressure of the last color; above pressure_low",
            &Options::pressure_high)
            .in("film tension / sqrt(mean area of the seeded foam or of the drawn frame), "
                "selected by albedo.pressure_unit")
            .used_with("albedo.color_by", {"pressure"}),
        key("pressure_unit",
            kPressureUnits,
            "unit of both pressures: film tension / sqrt(mean area), with the mean area of the "
            "seeded foam (seed) or of the drawn frame (current)",
            &Options::pressure_unit)
            .used_with("albedo.color_by", {"pressure"})};
}

// Returns the keys of the shade and the grain within bubbles.
Keys<AlbedoOptions> shade_keys() {
    using Options = AlbedoOptions;
    return {
        key("shade_color", Colors{}, "sRGB color of the shade beside films", &Options::shade_color)
            .unused_with("albedo.shade", {"0.0"}),
        key("shade_width",
            Reals{0.001, 10.0},
            "width of the shade on each side of a film, in diameters of a mean bubble of the "
            "seeded foam",
            &Options::shade_width)
            .in("mean bubble diameters of the seeded foam")
            .unused_with("albedo.shade", {"0.0"}),
        key("shade",
            kFractions,
            "strength of the shade right beside a film; 0 disables it",
            &Options::shade),
        key("grain",
            kFractions,
            "strength of a fine grain that moves with each bubble: the change of brightness rarely "
            "exceeds this fraction; 0 disables it",
            &Options::grain)
            .in("fraction of the brightness"),
        key("grain_size",
            Reals{0.01, 10.0},
            "size of the largest features of the grain, in diameters of a mean bubble of the "
            "seeded foam",
            &Options::grain_size)
            .in("mean bubble diameters of the seeded foam")
            .unused_with("albedo.grain", {"0.0"})};
}

Keys<AlbedoOptions> film_keys() {
    using Options = AlbedoOptions;
    constexpr Choices<WidthUnit> kWidthUnits = {
        {{{"px", WidthUnit::Pixels}, {"diameter", WidthUnit::Diameters}}}};
    constexpr Choices<FilmProfile> kFilmProfiles = {
        {{{"even", FilmProfile::Even}, {"wet", FilmProfile::Wet}}}};
    return {
        key("film_color", Colors{}, "sRGB color of the films", &Options::film_color)
            .unused_with("albedo.film_width", {"0.0"}),
        key("film_width",
            Reals{0.0, 1000.0},
            "full width of a film; 0 draws no films",
            &Options::film_width)
            .in("pixels or mean bubble diameters of the seeded foam, selected by albedo.film_unit"),
        key("film_unit",
            kWidthUnits,
            "unit of film_width: pixels, or diameters of a mean bubble of the seeded foam",
            &Options::film_unit)
            .unused_with("albedo.film_width", {"0.0"}),
        key("film_profile",
            kFilmProfiles,
            "even: films of constant width; wet: films that are wider where they meet, which gives "
            "bubbles rounded corners",
            &Options::film_profile)
            .unused_with("albedo.film_width", {"0.0"})};
}

}  // namespace

Keys<AlbedoOptions> albedo_keys() {
    return joined({color_by_keys(), color_keys(), bubble_keys(), shade_keys(), film_keys()});
}

double diameters_in_pixels(double diameters, const RasterGrid& grid, const Domain& domain) {
    const double diameter = 2.0 * std::numbers::inv_sqrtpi;  // diameter of a circle of area 1
    return diameters * diameter * pixels_per_unit(grid, domain);
}

double film_width_in_pixels(const AlbedoOptions& options,
                            const RasterGrid& grid,
                            const Domain& domain) {
    if (options.film_unit == WidthUnit::Pixels) {
        return options.film_width;
    }
    return diameters_in_pixels(options.film_width, grid, domain);
}

}  // namespace foam::texgen
