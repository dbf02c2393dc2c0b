#pragma once

#include "texgen/raster/arcs/pixel_arc.h"

#include <array>
#include <span>

namespace foam::texgen {

/// Whether an arc of this chord goes back neither in x nor in y: if it turns by less than half a
/// turn, and all its tangents lie between those at its ends.
[[gnu::always_inline]] inline bool is_monotone(double x, double y, double cosine, double sine) {
    const double first_x = cosine * x + sine * y;
    const double first_y = cosine * y - sine * x;
    const double last_x = cosine * x - sine * y;
    const double last_y = cosine * y + sine * x;
    return (cosine > 0.0) & (first_x * last_x >= 0.0) & (first_y * last_y >= 0.0);
}

/// A piece of an arc that goes neither back in x nor in y.
struct MonotonePiece {
    Vec2 head{0.0, 0.0};  // relative to the arc's tail
    double sine = 0.0;    // of its half angle, which is at most 45 degrees
};

/// An arc of less than a whole turn, in pieces from its tail on.
class MonotonePieces {
  public:
    explicit MonotonePieces(const PixelArc& arc);

    std::span<const MonotonePiece> pieces() const { return std::span(pieces_).first(count_); }

  private:
    void split(const PixelArc& arc);
    void append(const Vec2& head, double sine) { pieces_[count_++] = {head, sine}; }

    std::array<MonotonePiece, 5> pieces_;
    std::size_t count_ = 0;
};

/// Twice the area between an arc's chord and the arc, which turns by at most 90 degrees; positive
/// as the sine of half that angle. A series of E1, to a part of 2.5e-3 of it at 90 degrees, of 6e-5
/// at 60, of 6e-9 at 23.
template <class Real>
Real twice_segment(Real squared_chord, Real sine) {
    const Real z = sine * sine;
    const Real series =
        1 + z * (Real(3) / 10 + z * (Real(9) / 56 + z * (Real(5) / 48 + z * (Real(105) / 1408))));
    return squared_chord * sine * (Real(1) / 3) * series;
}

}  // namespace foam::texgen
