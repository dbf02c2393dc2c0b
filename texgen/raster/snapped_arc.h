#pragma once

#include "texgen/raster/coords/fixed_point.h"

#include <array>
#include <cmath>
#include <cstddef>
#include <span>

namespace foam::texgen {

/// An arc between ends that were rounded to subpixels; by the cosine and the sine of its half
/// angle.
struct SnappedArc {
    SubpixelPoint tail;
    SubpixelPoint head;
    double cosine = 1.0;
    double sine = 0.0;
};

/// Pieces of an arc that rise, each from its lower end up; what is level is left out. The pieces of
/// an arc and of its other side are the same.
class RisingPieces {
  public:
    explicit RisingPieces(const SnappedArc& arc);

    std::span<const SnappedArc> all() const& { return std::span(pieces_).first(count_); }
    void all() && = delete;  // what it returns would be gone

  private:
    void split(const SnappedArc& side);
    void append(SubpixelPoint from, SubpixelPoint to, double cosine, double sine);

    std::array<SnappedArc, 5> pieces_;
    std::size_t count_ = 0;
};

/// Where an arc that rises crosses a height, relative to the middle of its chord in y, and to its
/// lower end in x. As RisingArc::x_at, of an arc that may go back in x: `chord` is its chord,
/// `bulge` a quarter of its square times the sine, `across` and `up` are the chord times the
/// cosine.
[[gnu::always_inline]] inline double crossing_at(
    double y, double half_chord_x, double sine, double bulge, double across, double up) {
    const double c = bulge + y * (across - sine * y);
    const double squared = up * up + 4.0 * sine * c;
    const double root = std::sqrt(squared > 0.0 ? squared : 0.0);
    return half_chord_x + 2.0 * c / (up + root);
}

}  // namespace foam::texgen
