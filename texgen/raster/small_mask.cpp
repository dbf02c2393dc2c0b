#include "texgen/raster/small_mask.h"

#include "texgen/raster/arcs/rising_arc.h"
#include "texgen/raster/simd/vector_clones.h"

#include <algorithm>
#include <bit>
#include <cmath>

namespace foam::texgen {

namespace {

// The lower border of each row, in subpixels.
constexpr auto kHeights = [] {
    std::array<double, SmallMask::kMostRows + SmallMask::kGroup> heights{};
    for (std::size_t k = 0; k < heights.size(); ++k) {
        heights[k] = static_cast<double>(k) * kSubpixel;
    }
    return heights;
}();

constexpr std::array<std::uint32_t, SideLanes::kLanes> kBits{1, 2, 4, 8, 16, 32, 64, 128};

// To which doubles are whole numbers.
constexpr double kAllWhole = 0x1p52;

// As rounded (rising_arc.h), to a double.
double rounded_number(double x) {
    constexpr double kBias = 1 << 30;
    const double biased = x + (kBias + 0.5);
    const double nearest = biased + kAllWhole - kAllWhole;
    return nearest - (nearest > biased ? 1.0 : 0.0) - kBias;
}

// A whole number, not below 0.
std::uint64_t whole_bits(double number) {
    return std::bit_cast<std::uint64_t>(number + kAllWhole) -
           std::bit_cast<std::uint64_t>(kAllWhole);
}

}  // namespace

bool SmallMask::fill(const SideLanes& sides,
                     SubpixelPoint translation,
                     int columns,
                     const Rows& rows) {
    pieces_ = kLanes;
    for (std::uint32_t others = orient(sides, translation, rising_[0]); others != 0;
         others &= others - 1) {
        if (!split(sides, translation, static_cast<std::size_t>(std::countr_zero(others)))) {
            return false;
        }
    }
    std::fill(rows_.begin() + rows.begin, rows_.begin() + rows.end, 0);
    for (std::size_t k = 0; k * kLanes < pieces_; ++k) {
        cross(rising_[k], columns, rows, rows_.data());
    }
    return true;
}

// From its lower end up, or without height if it is not one piece that rises or falls; a bit for
// each that is not. As RisingPieces has it.
FOAMTEX_VECTOR_CLONES std::uint32_t SmallMask::orient(const SideLanes& sides,
                                                      SubpixelPoint translation,
                                                      Rising& rising) {
    Lanes<std::int32_t> head_x;
    Lanes<std::int32_t> head_y;
    for (std::size_t k = 0; k < kLanes; ++k) {
        head_x[k] = sides.tail_x[(k + 1) % kLanes];
        head_y[k] = sides.tail_y[(k + 1) % kLanes];
    }
    std::uint32_t others = 0;
    for (std::size_t k = 0; k < kLanes; ++k) {
        const std::int32_t x = head_x[k] - sides.tail_x[k];
        const std::int32_t y = head_y[k] - sides.tail_y[k];
        const double along = std::abs(sides.cosine[k] * y);
        const double across = std::abs(sides.sine[k] * x);
        const bool is_piece = sides.cosine[k] > 0.0 && along >= across;
        const bool is_up = y > 0;
        const std::int32_t low_y = (is_up ? sides.tail_y[k] : head_y[k]) + translation.y;
        const std::int32_t high_y = (is_up ? head_y[k] : sides.tail_y[k]) + translation.y;
        rising.low_x[k] = (is_up ? sides.tail_x[k] : head_x[k]) + translation.x;
        rising.high_x[k] = (is_up ? head_x[k] : sides.tail_x[k]) + translation.x;
        rising.low_y[k] = low_y;
        rising.high_y[k] = is_piece ? high_y : low_y;
        rising.cosine[k] = sides.cosine[k];
        rising.sine[k] = is_up ? sides.sine[k] : -sides.sine[k];
        others |= !is_piece && (x | y) != 0 ? kBits[k] : 0;
    }
    return others;
}

bool SmallMask::split(const SideLanes& sides, SubpixelPoint translation, std::size_t side) {
    const RisingPieces pieces({sides.tail(side) + translation,
                               sides.tail((side + 1) % kLanes) + translation,
                               sides.cosine[side],
                               sides.sine[side]});
    std::size_t place = side;
    for (const SnappedArc& piece : pieces.all()) {
        if (!put(place, piece)) {
            return false;
        }
        place = pieces_;
    }
    return true;
}

bool SmallMask::put(std::size_t k, const SnappedArc& piece) {
    if (k >= kMostPieces) {
        return false;
    }
    if (k == kLanes) {
        rising_[1] = {};
    }
    pieces_ = std::max(pieces_, k + 1);
    Rising& rising = rising_[k / kLanes];
    const std::size_t lane = k % kLanes;
    rising.low_x[lane] = piece.tail.x;
    rising.low_y[lane] = piece.tail.y;
    rising.high_x[lane] = piece.head.x;
    rising.high_y[lane] = piece.head.y;
    rising.cosine[lane] = piece.cosine;
    rising.sine[lane] = piece.sine;
    return true;
}

// Rows go through this in whole groups: one that an arc does not cross takes the nearest height
// that the arc has, and does not change. All numbers have 64 bits, so that as many go through as
// there are rows in a group.
FOAMTEX_VECTOR_CLONES void SmallMask::cross(const Rising& arcs,
                                            int columns,
                                            const Rows& rows,
                                            std::uint64_t* words) {
    const double last_column = columns * kSubpixel;
    for (std::size_t k = 0; k < kLanes; ++k) {
        const int first = std::max(first_middle_from(arcs.low_y[k]), rows.begin);
        const int last = std::min(first_middle_from(arcs.high_y[k]), rows.end);
        if (first >= last) {
            continue;
        }
        const double x = arcs.high_x[k] - arcs.low_x[k];
        const double y = arcs.high_y[k] - arcs.low_y[k];
        const double half_x = 0.5 * x;
        const double half_y = 0.5 * y;
        const double sine = arcs.sine[k];
        const double bulge = 0.25 * sine * (x * x + y * y);
        const double across = arcs.cosine[k] * x;
        const double up = arcs.cosine[k] * y;
        const double middle = arcs.low_y[k] + half_y - 0.5 * kSubpixel;
        const double low_x = arcs.low_x[k];
        const double first_height = first * kSubpixel;
        const double last_height = last * kSubpixel;
        const int groups = (last - first + kGroup - 1) / kGroup;
        for (int row = first; row < first + groups * kGroup; ++row) {
            const double height = kHeights[static_cast<std::size_t>(row)];
            const double raised = max_value(height - middle, -half_y);
            const double at =
                crossing_at(min_value(raised, half_y), half_x, sine, bulge, across, up);
            const double held = min_value(max_value(low_x + rounded_number(at), 0.0), last_column);
            const std::uint64_t column = (whole_bits(held) + kSubpixel / 2 - 1) >> kSubpixelBits;
            const bool is_crossed = and_nonshort(height >= first_height, height < last_height);
            words[row] ^= (is_crossed ? ~std::uint64_t{0} : 0) << column;
        }
    }
}

}  // namespace foam::texgen
