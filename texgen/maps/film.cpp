#include "texgen/maps/film.h"

#include "texgen/maps/film_look.h"

#include <utility>

namespace foam::texgen {

NumberPixels draw_film(FrameLayers& layers, const AlbedoOptions& options) {
    FilmLook look = film_look(layers, options);
    return {std::move(look.films), 0.0, 1.0};
}

}  // namespace foam::texgen
