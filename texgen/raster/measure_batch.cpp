#include "texgen/raster/measure_batch.h"

namespace foam::texgen {

namespace {

// A film of a chord below this part of its distance adds less than 1e-8 to a smooth distance, and
// its functions might leave the range of floats.
constexpr double kLeastChord = 1e-4;
// Where a circle is cut off.
constexpr float kNowhere = 1e15F;

FloatQuadratic in_floats(const Quadratic& q) {
    return {static_cast<float>(2.0 * q.value),
            static_cast<float>(q.gradient.x()),
            static_cast<float>(q.gradient.y()),
            static_cast<float>(q.curvature)};
}

void measure_smooth(const SmoothFilms& all, double reach, PixelBatch& batch) {
    batch.begin_smooth();
    for (const FieldArc& film : all.films) {
        const double far = (batch.middle() - film.middle).norm() + reach;
        if (film.chord <= kLeastChord * far) {
            continue;
        }
        const Pencil pencil = pencil_at(film, batch.middle());
        batch.add_film(
            in_floats(pencil.across),
            all.whole_circle ? FloatQuadratic{kNowhere, 0.0F, 0.0F, 0.0F} : in_floats(pencil.along),
            static_cast<float>(film.chord));
    }
    batch.finish_smooth();
}

}  // namespace

void measure(NearSides& sides,
             const SmoothFilms& films,
             double reach,
             DistanceNeeds needs,
             PixelBatch& batch) {
    const bool gradient = needs.gradient || needs.smooth;
    sides.measure(reach, gradient, batch);
    if (gradient) {
        batch.normalize_gradients();
    }
    if (needs.smooth) {
        measure_smooth(films, reach, batch);
    }
}

}  // namespace foam::texgen
