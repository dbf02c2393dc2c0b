#include "texgen/raster/region_field.h"

#include <bit>
#include <cmath>
#include <limits>

namespace foam::texgen {

namespace {

constexpr double kLeastCosine = 0.5;  // of the half angle of a side
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

// Calls visit(begin, count) for the runs of bits that are set; not all are.
template <class Visit>
void for_each_run(std::uint64_t bits, const Visit& visit) {
    while (bits != 0) {
        const int begin = std::countr_zero(bits);
        const int count = std::countr_one(bits >> begin);
        visit(begin, count);
        bits &= ~(((std::uint64_t{1} << count) - 1) << begin);
    }
}

bool turns_right(const FieldArc& before, const FieldArc& after) {
    return cross(head_tangent(before), tail_tangent(after)) < 0.0;
}

}  // namespace

void RegionField::clear(Kind kind) {
    kind_ = kind;
    sides_.clear();
    films_.clear();
    boundary_ = 0;
}

void RegionField::add_side(const FieldArc& arc) {
    if (kind_ == Kind::Bubble || (kind_ == Kind::Circle && films_.empty())) {
        films_.push_back(arc);
    }
    if (arc.cosine >= kLeastCosine) {
        sides_.push_back({arc, false});
        return;
    }
    const auto [first, second] = halves(arc);
    const Kind kind = std::exchange(kind_, Kind::Around);  // halves are no films
    add_side(first);
    add_side(second);
    kind_ = kind;
}

void RegionField::close_boundary() {
    for (std::size_t k = boundary_; k < sides_.size(); ++k) {
        const RegionSide& before = k == boundary_ ? sides_.back() : sides_[k - 1];
        sides_[k].corner = turns_right(before.arc, sides_[k].arc);
    }
    boundary_ = sides_.size();
}

void RegionField::start() {
    near_.resize(sides_.size());
    for (std::size_t k = 0; k < near_.size(); ++k) {
        near_[k] = static_cast<std::uint32_t>(k);
    }
}

// Appends those of a range that may be nearest to some point within reach of the middle.
void RegionField::narrow(std::size_t begin, std::size_t end, const Vec2& middle, double reach) {
    distances_.clear();
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t k = begin; k < end; ++k) {
        distances_.push_back(distance(sides_[near_[k]].arc, middle));
        least = std::min(least, distances_.back());
    }
    for (std::size_t k = begin; k < end; ++k) {
        if (distances_[k - begin] <= least + 2.0 * reach + PixelBatch::kMargin) {
            near_.push_back(near_[k]);
        }
    }
}

void RegionField::take_sides(std::size_t begin) {
    few_.clear();
    for (std::size_t k = begin; k < near_.size(); ++k) {
        few_.add(sides_[near_[k]]);
    }
}

// With all sides.
void RegionField::take_all(const Pixels& pixels) {
    few_.clear();
    for (const RegionSide& side : sides_) {
        few_.add(side);
    }
    const CellMask& mask = pixels.mask;
    batch_.clear(Vec2(mask.columns() / 2, pixels.rows / 2));
    for (int k = 0; k < mask.rows(); ++k) {
        for_each_run(mask.whole_row(k), [&](int begin, int count) {
            batch_.add_run(begin, pixels.first_row + k, count);
        });
    }
}

void RegionField::take_tile(const Pixels& pixels, int x, int y) {
    const int column = x * kTileColumns;
    const int row = y * kTileRows;
    batch_.clear(Vec2(column + 0.5 * kTileColumns, pixels.first_row + row + 0.5 * kTileRows));
    for (int k = row; k < std::min(row + kTileRows, pixels.mask.rows()); ++k) {
        for_each_run(pixels.mask.sixteen(x, k), [&](int begin, int count) {
            batch_.add_run(column + begin, pixels.first_row + k, count);
        });
    }
}

void RegionField::measure_batch(double reach, DistanceNeeds needs) {
    few_.measure(reach, needs.gradient || needs.smooth, batch_);
    if (needs.gradient || needs.smooth) {
        batch_.normalize_gradients();
    }
    if (needs.smooth) {
        measure_smooth(reach);
    }
}

void RegionField::measure_smooth(double reach) {
    batch_.begin_smooth();
    for (const FieldArc& film : films_) {
        const double far = (batch_.middle() - film.middle).norm() + reach;
        if (film.chord <= kLeastChord * far) {
            continue;
        }
        const Pencil pencil = pencil_at(film, batch_.middle());
        batch_.add_film(in_floats(pencil.across),
                        kind_ == Kind::Circle ? FloatQuadratic{kNowhere, 0.0F, 0.0F, 0.0F}
                                              : in_floats(pencil.along),
                        static_cast<float>(film.chord));
    }
    batch_.finish_smooth();
}

}  // namespace foam::texgen
