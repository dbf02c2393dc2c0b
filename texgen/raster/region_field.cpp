#include "texgen/raster/region_field.h"

#include "texgen/raster/measure_batch.h"
#include "texgen/raster/runs.h"

#include <cmath>
#include <limits>

namespace foam::texgen {

namespace {

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
    if (arc.cosine >= kLeastSideCosine) {
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
        for_each_run_of_bits(mask.whole_row(k), [&](int begin, int count) {
            batch_.add_run(begin, pixels.first_row + k, count);
        });
    }
}

void RegionField::take_tile(const Pixels& pixels, int x, int y) {
    const int column = x * kTileColumns;
    const int row = y * kTileRows;
    batch_.clear(Vec2(column + 0.5 * kTileColumns, pixels.first_row + row + 0.5 * kTileRows));
    for (int k = row; k < std::min(row + kTileRows, pixels.mask.rows()); ++k) {
        for_each_run_of_bits(pixels.mask.sixteen(x, k), [&](int begin, int count) {
            batch_.add_run(column + begin, pixels.first_row + k, count);
        });
    }
}

void RegionField::measure_batch(double reach, DistanceNeeds needs) {
    texgen::measure(few_, {films_, kind_ == Kind::Circle}, reach, needs, batch_);
}

}  // namespace foam::texgen
