#include "texgen/image/colormap.h"
#include "texgen/preset/value_kinds.h"
#include "texgen/preset/key_of_member.h"
#include "texgen/preset/map_choices.h"
#include "texgen/preset/map_schema.h"

namespace foam::texgen {

namespace {

constexpr Choices<ColorBy, 4> kColorBys = {{{{"pressure", ColorBy::Pressure},
                                             {"area", ColorBy::Area},
                                             {"sides", ColorBy::Sides},
                                             {"random", ColorBy::Random}}}};
constexpr Choices<ColorMix> kColorMixes = {
    {{{"blend", ColorMix::Blend}, {"pick", ColorMix::Pick}}}};
constexpr Choices<WidthUnit> kWidthUnits = {
    {{{"px", WidthUnit::Pixels}, {"diameter", WidthUnit::Diameters}}}};
constexpr Choices<FilmProfile> kFilmProfiles = {
    {{{"even", FilmProfile::Even}, {"wet", FilmProfile::Wet}}}};
constexpr Choices<LitColors> kLitColors = {
    {{{"albedo", LitColors::Albedo}, {"thin_film", LitColors::ThinFilm}}}};
constexpr Reals kParts{0.0, 1.0};

std::vector<Key> bubble_keys() {
    using Options = AlbedoOptions;
    const auto one = keys_in(&MapOptions::albedo);
    return {
        one("albedo.color_by",
            kColorBys,
            "what decides the colour of a bubble: its pressure, its area, where the mean is the "
            "middle of the colours, its sides from 3 to 9, or chance, for life",
            &Options::color_by),
        one("albedo.colormap", Words{colormap_names()}, "the colours", &Options::colormap),
        one("albedo.colors",
            ColorLists{},
            "colours of your own instead, from the first to the last",
            &Options::colors),
        one("albedo.color_mix",
            kColorMixes,
            "colours of your own turn into each other, or only they themselves are used",
            &Options::color_mix),
        one("albedo.variation",
            kParts,
            "bubbles are lighter or darker by up to this part, each for life",
            &Options::variation),
        one("albedo.pressure_low",
            Reals{-kLargestPressure, kLargestPressure},
            "pressure of the first colour",
            &Options::pressure_low),
        one("albedo.pressure_high",
            Reals{-kLargestPressure, kLargestPressure},
            "pressure of the last; above pressure_low",
            &Options::pressure_high),
        one("albedo.pressure_unit",
            kPressureUnits,
            "film tension over the root of the mean area: of the seeded foam or of this frame",
            &Options::pressure_unit),
        one("albedo.shade_color",
            Colors{},
            "sRGB colour that bubbles turn to beside films",
            &Options::shade_color),
        one("albedo.shade_width",
            Reals{0.001, 10.0},
            "how far it reaches, in diameters of a mean bubble of the seeded foam",
            &Options::shade_width),
        one("albedo.shade",
            kParts,
            "the part of it right beside a film; 0 leaves bubbles flat",
            &Options::shade)};
}

std::vector<Key> film_keys() {
    using Options = AlbedoOptions;
    const auto one = keys_in(&MapOptions::albedo);
    return {one("albedo.film_color", Colors{}, "sRGB colour of the films", &Options::film_color),
            one("albedo.film_width",
                Reals{0.0, 1000.0},
                "whole width of a film; 0 draws none",
                &Options::film_width),
            one("albedo.film_unit",
                kWidthUnits,
                "pixels, or diameters of a mean bubble of the seeded foam",
                &Options::film_unit),
            one("albedo.film_profile",
                kFilmProfiles,
                "films as wide everywhere, or wider where they meet, which gives bubbles round "
                "corners",
                &Options::film_profile)};
}

std::vector<Key> lit_keys() {
    using Options = LitOptions;
    const auto one = keys_in(&MapOptions::lit);
    return {
        one("lit.colors", kLitColors, "the map that is lit", &Options::colors),
        one("lit.azimuth",
            Reals{-360.0, 360.0},
            "where the light comes from: degrees from the right, counterclockwise",
            &Options::azimuth),
        one("lit.elevation",
            Reals{1.0, 90.0},
            "its height, degrees; flat ground keeps its colour under any",
            &Options::elevation),
        one("lit.ambient", kParts, "the part of the light that the sky gives", &Options::ambient),
        one("lit.gloss", Reals{0.0, 1000.0}, "brightness of highlights", &Options::gloss),
        one("lit.shininess",
            Reals{1.0, 10000.0},
            "the larger, the smaller highlights are",
            &Options::shininess),
        one("lit.rim", Reals{0.0, 1000.0}, "brightness of what is steep", &Options::rim),
        one("lit.glow",
            kParts,
            "the part of films and of the shade beside them that shines by itself",
            &Options::glow),
        one("lit.samples",
            Integers{1, 8},
            "a pixel is the mean of so many in either direction",
            &Options::samples)};
}

}  // namespace

std::vector<Key> look_keys() {
    std::vector<Key> all;
    for (const auto& keys : {bubble_keys(), film_keys(), lit_keys()}) {
        all.insert(all.end(), keys.begin(), keys.end());
    }
    return all;
}

}  // namespace foam::texgen
