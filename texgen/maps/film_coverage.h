// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "texgen/maps/albedo_options.h"
#include "texgen/maps/cell_fill.h"
#include "texgen/maps/frame_layers.h"
#include "texgen/maps/map_image.h"

namespace foam::texgen {

/// Returns the fraction of every pixel that films cover, from 0 to 1, in one channel. For even
/// films (FilmProfile::Even: the same width everywhere) the fraction is exact, except at the border
/// of a cross-fade (FadeBorder). Wet films (FilmProfile::Wet) end where the smooth distance
/// (distance_field.h) is half of options.film_width, so that the corners of bubbles are round. At
/// the edge of a wet film the fraction falls linearly from 1 to 0 over the width of a pixel. Throws
/// as film_width_in_pixels does and, for even films, as fill_coverage does. Precondition: if films
/// are wet, the distance field contains the smooth distance and its gradient (film_smooth_images).
Image<float> film_coverage(FrameLayers& layers, const AlbedoOptions& options);

/// Returns the fraction of every pixel that films and bubbles cover together, in one channel.
Image<float> foam_coverage(FrameLayers& layers, const AlbedoOptions& options);
/// Returns the same fraction as the function above, but takes the result of film_coverage as
/// `films`. This image is used only for wet films in a patch; in all other cases it may be empty.
Image<float> foam_coverage(FrameLayers& layers,
                           const AlbedoOptions& options,
                           const Image<float>& films);

/// Returns the weight of the shade's color at every pixel. The weight is options.shade on the
/// center lines of films and falls smoothly to 0 at the smooth distance options.shade_width. The
/// image has one channel. Precondition: options.shade > 0, because otherwise the distance field may
/// lack the smooth distance.
Image<float> film_shade(FrameLayers& layers, const AlbedoOptions& options);

/// Returns an image of one channel. `numbers` gives numbers to the bubbles and to the films. Each
/// pixel is the mean of these numbers, weighted by the part of the pixel that each bubble or film
/// covers. The options give the width and the shape of films. Pixels around a patch are 0.
Image<float> fill_numbers(FrameLayers& layers,
                          const CellNumbers& numbers,
                          const AlbedoOptions& options);

/// Returns which images of the smooth distance the functions of this file need.
SmoothImages film_smooth_images(const AlbedoOptions& options);

/// Paints films over the colors of bubbles. The first three channels of `colors` hold a color for
/// every pixel. The surroundings of a patch become transparent, as in fill_colors. Throws
/// std::invalid_argument if options.film_color is invalid. Also throws as film_coverage does.
ColorPixels paint_films(FrameLayers& layers, const AlbedoOptions& options, ColorPixels colors);

}  // namespace foam::texgen
