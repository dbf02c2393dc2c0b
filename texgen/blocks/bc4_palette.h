// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "core/parallel/kernel_array.h"
#include "texgen/blocks/lanes.h"

namespace foam::texgen {

/// The palette of a BC4 block: the values that its texels can have. They are evenly spaced, from
/// the lower endpoint with the index 0 to the higher endpoint with the index `kSteps`. With five
/// steps, the palette also has the extra values 0 and 255.
template <class Simd, int kSteps>
class Palette {
  public:
    using Floats = typename Simd::Floats;
    using Ints = typename Simd::Ints;
    static constexpr bool kHasExtremes = kSteps == 5;

    FOAM_INLINE Palette(const Floats& low, const Floats& high)
        : low_(low),
          step_(high - low),
          scale_(Floats(kSteps) / Simd::larger(step_, Floats(1.0F))) {}

    /// The value of the palette that is nearest to a texel.
    struct Nearest {
        Floats index;     // from 0 to kSteps; unspecified for the extra values
        Floats square;    // squared error
        Ints is_between;  // 0 if the value is an extra value, otherwise -1
        Ints code;        // the index that a block stores
    };

    /// Returns the nearest value and its index.
    FOAM_INLINE Nearest nearest(const Floats& texel) const {
        Nearest result;
        const Floats position = (texel - low_) * scale_ + Floats(0.5F);
        result.index =
            Simd::truncated(Simd::smaller(Simd::larger(position, Floats()), Floats(kSteps + 0.5F)));
        // The 0.5 keeps the sum away from multiples of the number of steps. In spite of rounding
        // errors, truncation therefore gives the result of the integer division in a decoder.
        constexpr int kHalf = kSteps / 2;
        const Floats value =
            Simd::truncated((low_ * Floats(kSteps) + step_ * result.index + Floats(kHalf + 0.5F)) *
                            Floats(1.0F / kSteps));
        result.square = (texel - value) * (texel - value);
        result.is_between = Ints(-1);
        result.code = code_of(Simd::whole(result.index));
        if constexpr (kHasExtremes) {
            const Floats below = texel * texel;
            const Floats above = (texel - Floats(255.0F)) * (texel - Floats(255.0F));
            const Ints is_below = Simd::less(below, result.square);
            const Ints is_above = Simd::less(above, result.square);
            result.is_between = Simd::equal(is_below | is_above, Ints());
            result.square = Simd::smaller(result.square, Simd::smaller(below, above));
            result.code = Simd::select(is_below, Ints(6), result.code);
            result.code = Simd::select(is_above, Ints(7), result.code);
        }
        return result;
    }

  private:
    // A block with the extra values stores the lower endpoint first, other blocks the higher one.
    FOAM_INLINE static Ints code_of(const Ints& index) {
        const Ints rank = kHasExtremes ? index : Ints(kSteps) - index;
        const Ints code = Simd::select(Simd::equal(rank, Ints(kSteps)), Ints(0), rank) + Ints(1);
        return Simd::select(Simd::equal(rank, Ints()), Ints(), code);
    }

    Floats low_;
    Floats step_;
    Floats scale_;
};

}  // namespace foam::texgen
