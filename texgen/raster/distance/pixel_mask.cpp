#include "texgen/raster/distance/pixel_mask.h"

#include "texgen/raster/arcs/arc_crossings.h"
#include "texgen/raster/arcs/pixel_arc.h"
#include "texgen/raster/simd/kernel.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace foam::texgen {

namespace {

constexpr std::size_t kLanes = 8;  // rows that are crossed at once
constexpr double kWhole = 0x1p52;  // adding it rounds a double to a whole number
constexpr double kHalf = 0.5 * kSubpixel;

constexpr std::array<double, kLanes> kRowSteps = [] {
    std::array<double, kLanes> steps{};
    for (std::size_t k = 0; k < kLanes; ++k) {
        steps[k] = static_cast<double>(k) * kSubpixel;
    }
    return steps;
}();

// Returns all bits of a word from a position on, which may be outside of it.
[[gnu::always_inline]] inline std::uint64_t bits_from(std::int64_t position) {
    const std::int64_t within =
        min_value(max_value(position, std::int64_t{0}), std::int64_t{PixelMask::kWordColumns});
    const auto half = static_cast<std::uint64_t>(within) / 2;  // as a shift by 64 is undefined
    return ~std::uint64_t{0} << half << (static_cast<std::uint64_t>(within) - half);
}

// Returns the first column whose middle is at or to the right of an x in [0, 2^31), a whole number.
[[gnu::always_inline]] inline std::uint64_t first_column_from(double x) {
    return std::bit_cast<std::uint64_t>((x - 0.5) / kSubpixel + kWhole) -
           std::bit_cast<std::uint64_t>(kWhole);
}

// Added before a crossing is rounded down.
constexpr double kToNearest = 0.5;
constexpr double kUp = 1.0 - 0x1p-27;  // a crossing of an edge is a fraction of its height

// Rows of a mask: the first words of the rows, which lie side by side, and the distance from there
// to the next words of the same rows.
struct MaskRows {
    std::uint64_t* words;
    std::size_t stride;
    int count;
    int columns;  // pixels
};

// Flips the pixels of kLanes rows from a column on, in the rows that are crossed.
[[gnu::always_inline]] inline void flip_from(const std::array<std::uint64_t, kLanes>& column,
                                             const std::array<std::uint64_t, kLanes>& is_crossed,
                                             MaskRows rows,
                                             std::uint64_t* word) {
    for (int first = 0; first <= rows.columns; first += PixelMask::kWordColumns) {
        for (std::size_t k = 0; k < kLanes; ++k) {
            word[k] ^= is_crossed[k] & bits_from(static_cast<std::int64_t>(column[k]) - first);
        }
        word += rows.stride;
    }
}

// Flips the pixels to the right of an arc, whose lower end has this x. The middle of the first row
// is at the height y above that end. Words of rows beyond the last are written, but do not change.
void flip_rows(
    const CrossingSolver<double>& arc, double low_x, double y, double round_up, MaskRows rows) {
    at_simd_level([=] {
        const double last_x = rows.columns * kSubpixel;
        for (int from = 0; from < rows.count; from += static_cast<int>(kLanes)) {
            const double begin = from * kSubpixel;
            const double end = rows.count * kSubpixel;
            std::array<std::uint64_t, kLanes> column{};
            std::array<std::uint64_t, kLanes> is_crossed{};
            for (std::size_t k = 0; k < kLanes; ++k) {
                const double step = begin + kRowSteps[k];
                const double x = low_x + std::floor(arc.unbounded_x_at(y + step) + round_up);
                column[k] = first_column_from(min_value(max_value(x, 0.0), last_x));
                is_crossed[k] = step < end ? ~std::uint64_t{0} : 0;
            }
            flip_from(column, is_crossed, rows, rows.words + from);
        }
    });
}

// Returns the first row whose middle is at or above a height in subpixels, clamped to the rows.
int first_row_from(double y, PixelRows rows) {
    return static_cast<int>(std::clamp<double>(
        std::ceil((y - kHalf) / kSubpixel), rows.begin, std::max(rows.begin, rows.end)));
}

}  // namespace

void PixelMask::reset(int columns, PixelRows rows, bool full) {
    columns_ = columns;
    rows_ = rows;
    stride_ = static_cast<std::size_t>(std::max(rows.end - rows.begin, 0)) + kLanes;
    const int word_columns = columns / kWordColumns + 1;
    words_.assign(stride_ * static_cast<std::size_t>(word_columns), 0);
    for (int k = 0; full && k < word_columns; ++k) {
        const int here = columns - k * kWordColumns;
        std::fill_n(
            words_.begin() + static_cast<std::ptrdiff_t>(stride_) * k, stride_, ~bits_from(here));
    }
}

// A side whose tangent is nowhere horizontal is one piece.
void PixelMask::flip_right_of(const DistanceArc& side) {
    const PixelArc& shape = side.shape;
    const Vec2 chord = side.to - side.from;
    if (shape.cosine > 0.0 &&
        std::abs(shape.cosine * chord.y()) >= std::abs(shape.sine * chord.x())) {
        flip_right_of_piece(side.from, side.to, shape.cosine, shape.sine, kToNearest);
    } else if (chord != Vec2::Zero()) {
        split(side);
    }
}

void PixelMask::flip_right_of(const Edge& edge) {
    flip_right_of_piece(edge.from, edge.to, 1.0, 0.0, kUp);
}

// From the lower end on, or from the left one, so that both sides of a film have the same pieces.
void PixelMask::split(const DistanceArc& side) {
    const Vec2 ahead = side.to - side.from;
    const bool is_up = ahead.y() > 0.0 || (ahead.y() == 0.0 && ahead.x() > 0.0);
    const Vec2 tail = is_up ? side.from : side.to;
    const MonotonePieces all({is_up ? ahead : Vec2(-ahead),
                              side.shape.cosine,
                              is_up ? side.shape.sine : -side.shape.sine});
    Vec2 from = tail;
    for (const MonotonePieces::Piece& piece : all.pieces()) {
        const bool is_last = &piece == &all.pieces().back();
        const Vec2 whole = (piece.head.array() + 0.5).floor();
        const Vec2 to = is_last ? Vec2(is_up ? side.to : side.from) : Vec2(tail + whole);
        flip_right_of_piece(
            from, to, std::sqrt(1.0 - piece.sine * piece.sine), piece.sine, kToNearest);
        from = to;
    }
}

void PixelMask::flip_right_of_piece(
    Vec2 from, Vec2 to, double cosine, double sine, double round_up) {
    if (to.y() < from.y()) {
        std::swap(from, to);
        sine = -sine;
    }
    const int first = first_row_from(from.y(), rows_);
    const int last = first_row_from(to.y(), rows_);
    if (first >= last) {
        return;
    }
    flip_rows(CrossingSolver<double>(to - from, cosine, sine),
              from.x(),
              first * kSubpixel + kHalf - from.y(),
              round_up,
              {words_.data() + (first - rows_.begin), stride_, last - first, columns_});
}

}  // namespace foam::texgen
