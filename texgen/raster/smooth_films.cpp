#include "texgen/raster/smooth_films.h"

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

}  // namespace

void measure_smooth(std::span<const FieldArc> films,
                    bool whole_circle,
                    double reach,
                    PixelBatch& batch) {
    batch.begin_smooth();
    for (const FieldArc& film : films) {
        const double far = (batch.middle() - film.middle).norm() + reach;
        if (film.chord <= kLeastChord * far) {
            continue;
        }
        const Pencil pencil = pencil_at(film, batch.middle());
        batch.add_film(
            in_floats(pencil.across),
            whole_circle ? FloatQuadratic{kNowhere, 0.0F, 0.0F, 0.0F} : in_floats(pencil.along),
            static_cast<float>(film.chord));
    }
    batch.finish_smooth();
}

}  // namespace foam::texgen
