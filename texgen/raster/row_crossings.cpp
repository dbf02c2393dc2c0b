#include "texgen/raster/row_crossings.h"

#include "texgen/raster/arcs/rising_arc.h"
#include "texgen/raster/simd/kernel.h"
#include "texgen/raster/simd/vector_clones.h"

namespace foam::texgen {

namespace {

constexpr std::size_t kLanes = 4;  // crossings found at once

}  // namespace

void RowCrossings::add(const SnappedArc& arc, const CellMask& mask) {
    const RisingPieces pieces(arc);
    for (const SnappedArc& piece : pieces.all()) {
        add_rising(piece, mask);
    }
}

void RowCrossings::add_rising(const SnappedArc& arc, const CellMask& mask) {
    const auto [begin, end] = mask.rows_between(arc.tail.y, arc.head.y);
    if (begin >= end) {
        return;
    }
    const auto rows = static_cast<std::size_t>(end - begin);
    const SubpixelPoint chord = arc.head - arc.tail;
    const double x = chord.x;
    const double y = chord.y;
    constexpr std::int32_t kMiddle = kSubpixel / 2;
    arcs_.push_back({0.5 * x,
                     0.5 * y,
                     arc.sine,
                     0.25 * arc.sine * (x * x + y * y),
                     arc.cosine * x,
                     arc.cosine * y,
                     static_cast<double>(begin * kSubpixel + kMiddle - arc.tail.y),
                     arc.tail.x,
                     begin,
                     count_,
                     rows});
    count_ += (rows + kLanes - 1) / kLanes * kLanes;
}

void RowCrossings::mark(CellMask& mask) {
    grow(xs_, count_);
    find(arcs_, xs_.data());
    for (const Rising& arc : arcs_) {
        for (std::size_t k = 0; k < arc.count; ++k) {
            mask.cross(arc.row + static_cast<int>(k), arc.x + xs_[arc.first + k]);
        }
    }
    mask.close();
    arcs_.clear();
    count_ = 0;
}

// Rows beyond the arc's fill the last vector.
FOAMTEX_VECTOR_CLONES void RowCrossings::find(std::span<const Rising> arcs, std::int32_t* xs) {
    for (const Rising& a : arcs) {
        for (std::size_t from = 0; from < a.count; from += kLanes) {
            const double y = a.y + static_cast<double>(from) * kSubpixel - a.half_y;
            for (std::size_t k = 0; k < kLanes; ++k) {
                const double q = y + static_cast<double>(static_cast<int>(k)) * kSubpixel;
                xs[a.first + from + k] =
                    rounded(crossing_at(q, a.half_x, a.sine, a.bulge, a.across, a.up));
            }
        }
    }
}

}  // namespace foam::texgen
