#pragma once

#include "core/geometry/vec2.h"

#include <array>
#include <cstddef>
#include <span>

namespace foam::texgen {

/// An arc that rises, and goes neither back in x nor in y.
struct RisingPiece {
    Vec2 low{0.0, 0.0};
    Vec2 high{0.0, 0.0};
    double sine = 0.0;  // of half the angle by which it turns left, at most 45 degrees
};

/// What stands for an arc in a box: the part of it that is inside, and for the part on the box's
/// left the same heights on its border. What is below, above, or on the right is left out.
class ClippedPiece {
  public:
    ClippedPiece(const RisingPiece& piece, const Vec2& low, const Vec2& high);

    std::span<const RisingPiece> pieces() const { return std::span(pieces_).first(count_); }

  private:
    void append(const RisingPiece& piece);
    void clip_in_x(const RisingPiece& piece, double left, double right);

    std::array<RisingPiece, 2> pieces_;
    std::size_t count_ = 0;
};

}  // namespace foam::texgen
