#pragma once

#include "texgen/maps/map_image.h"

namespace foam::texgen {

class FrameLayers;
struct MapOptions;

/// The map whose colours are lit.
enum class LitColors { Albedo, ThinFilm };

/// A surface under one light far away, seen from straight above, and how it shines.
struct LitOptions {
    LitColors colors = LitColors::Albedo;
    double azimuth = 135.0;   // degrees from the right, counterclockwise: where light comes from
    double elevation = 50.0;  // degrees above the plane
    double ambient = 0.4;     // the part of the light that comes from an even sky
    double gloss = 0.25;      // brightness of highlights
    double shininess = 40.0;  // the larger, the smaller they are
    double rim = 0.0;         // light on what is steep, as on bubbles before a bright ground
    double glow = 0.0;        // the part of films and their shade that shine by themselves
    int samples = 2;          // a pixel is the mean of so many in either direction
};

/// The foam as a picture: its colours on its relief, under a light. Flat ground keeps its colour.
/// By N. Blinn's highlights ("Models of light reflection for computer synthesized pictures", 1977),
/// and with the sky that draw_occlusion leaves. Transparent around a patch.
ColorPixels draw_lit(FrameLayers& layers, const MapOptions& options);

}  // namespace foam::texgen
