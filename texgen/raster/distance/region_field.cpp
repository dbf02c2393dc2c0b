// SPDX-License-Identifier: Apache-2.0

#include "texgen/raster/distance/region_field.h"

#include "texgen/raster/simd/kernel.h"

#include <algorithm>
#include <bit>

// Arcs are culled as J. E. Warnock culls polygons ("A hidden surface algorithm for computer
// generated halftone pictures", 1969). A block of pixels is divided into quarters, and a quarter
// starts with the arcs that its block has kept. The bound by which arcs are dropped follows from
// the triangle inequality. Let d be the distance of the middle of the block from the nearest arc.
// Let r be the distance of the middle from the farthest pixel of the block. The distance of every
// pixel from this arc is at most d + r. An arc whose distance from the middle is above d + 2 r has
// a distance above d + r from every pixel. It is therefore not the nearest arc of any pixel.
// ArcView::horizon adds a margin to d + 2 r.

namespace foam::texgen {

namespace {

// The largest number of columns and of rows of a region that is measured as one batch.
constexpr int kMaxBatchSide = 40;
// The largest number of arcs of a region that is measured as one batch. A region that exceeds one
// of the two limits is divided into blocks of tiles of kTileColumns x kTileRows pixels. Each block
// starts with the arcs of the block that encloses it. If these are more than kMaxUnculledArcs arcs,
// those that are too far away to be the nearest arc of any pixel in the block are dropped.
constexpr std::size_t kMaxUnculledArcs = 24;
// A film is ignored in smooth distances if its chord is at most this fraction of its distance from
// the farthest pixel of a batch. The smooth distance s is defined by 1/s² = Σ 1/phi², summed over
// the films (README.md). The film would add only about 1e-8 / distance² to this sum, and its
// functions could leave the range of floats.
constexpr double kMinChord = 1e-4;
// The value of FloatQuadratic::twice_value in FilmFunctions::along of a circle. The film of a
// circle has no ends. The function is therefore a constant, so large that every pixel counts as
// beside the film, not beyond its ends.
constexpr float kNoEnd = 1e15F;

}  // namespace

void RegionField::measure(const Region& region,
                          const RegionPixels& pixels,
                          DistanceNeeds needs,
                          const Visit& visit) {
    needs_ = needs;
    visit_ = &visit;
    region_ = &region;
    offset_ = pixels.offset();
    const Arcs arcs = region.boundary.arcs();
    const PixelMask& mask = pixels.mask();
    const PixelBox box{0, mask.columns(), 0, pixels.box().rows()};
    if (std::max(box.columns(), box.rows()) <= kMaxBatchSide && arcs.size() <= kMaxUnculledArcs) {
        measure_box(mask, arcs, box);
        return;
    }
    const int first = mask.rows().begin / kTileRows * kTileRows;
    const int tiles =
        std::max((mask.columns() - 1) / kTileColumns, (mask.rows().end - first - 1) / kTileRows) +
        1;
    const int side = static_cast<int>(std::bit_ceil(static_cast<unsigned>(tiles)));
    subdivide(mask, arcs, {0, side * kTileColumns, first, first + side * kTileRows}, 0);
}

// Measures a block of tiles. The number of rows of tiles equals the number of columns of tiles and
// is a power of two. `arcs` contains all arcs that may be the nearest arc of a pixel in the block.
// `level` is the number of enclosing blocks for which arcs were dropped, so that near_[level] is
// the next free list of arcs. If there are more than kMaxUnculledArcs arcs, those that cannot be
// the nearest arc of any pixel in the block are dropped before its quarters are measured.
void RegionField::subdivide(const PixelMask& mask,
                            Arcs arcs,
                            const PixelBox& block,
                            std::size_t level) {
    const Vec2 size(std::min(mask.columns() - block.left, block.columns()),
                    std::min(mask.rows().end - block.bottom, block.rows()));
    if (size.minCoeff() <= 0.0) {
        return;
    }
    if (block.columns() == kTileColumns) {
        measure_box(mask, arcs, block);
        return;
    }
    if (arcs.size() > kMaxUnculledArcs) {
        if (level == near_.size()) {
            near_.emplace_back();
        }
        view_.evaluate(arcs, Vec2(block.left, block.bottom) + 0.5 * size - offset_);
        const double horizon = view_.horizon(0.5 * size.norm());
        std::vector<DistanceArc>& near = near_[level++];
        near.clear();
        for (std::size_t k = 0; k < arcs.size(); ++k) {
            if (view_.is_within(k, horizon)) {
                near.push_back(arcs[k]);
            }
        }
        arcs = near;
    }
    const int middle_x = block.left + block.columns() / 2;
    const int middle_y = block.bottom + block.rows() / 2;
    subdivide(mask, arcs, {block.left, middle_x, block.bottom, middle_y}, level);
    subdivide(mask, arcs, {middle_x, block.right, block.bottom, middle_y}, level);
    subdivide(mask, arcs, {block.left, middle_x, middle_y, block.top}, level);
    subdivide(mask, arcs, {middle_x, block.right, middle_y, block.top}, level);
}

// Measures the pixels of the region in a box as one batch, and passes the batch to the visitor.
// `arcs` contains all arcs that may be the nearest arc of one of these pixels. Precondition: in
// each row, the columns of the box are in one 64-bit word of the mask.
void RegionField::measure_box(const PixelMask& mask, Arcs arcs, const PixelBox& box) {
    batch_.clear(Vec2(box.left + box.columns() / 2, box.bottom + box.rows() / 2));
    const PixelRows rows{std::max(box.bottom, mask.rows().begin),
                         std::min(box.top, mask.rows().end)};
    at_simd_level([&mask, &box, rows, &batch = batch_] {
        const std::uint64_t columns = ~(~std::uint64_t{0} << box.columns());
        for (int row = rows.begin; row < rows.end; ++row) {
            const std::uint64_t word = mask.word(box.left / PixelMask::kWordColumns, row);
            for_each_span_of_bits(
                word >> box.left % PixelMask::kWordColumns & columns,
                [&](int begin, int count) { batch.add_span(box.left + begin, row, count); });
        }
    });
    if (batch_.is_empty()) {
        return;
    }
    const double reach = (Vec2(box.right, box.top) - batch_.middle() - Vec2::Constant(0.5)).norm();
    // If only smooth distances are needed, plain distances are measured only where they replace the
    // smooth ones: around a patch, and in the middle of enormous bubbles.
    const bool has_distances =
        needs_.distance || needs_.gradient || region_->kind == RegionKind::Surroundings;
    if (has_distances) {
        measure_distances(arcs, reach);
    }
    if (needs_.smooth != SmoothImages::None && !measure_smooth(reach) && !has_distances) {
        measure_distances(arcs, reach);
        measure_smooth(reach);
    }
    (*visit_)(batch_);
}

// Measures the distances of the batch. Precondition: `reach` is at least the distance from the
// middle of the batch to its farthest pixel.
void RegionField::measure_distances(Arcs arcs, double reach) {
    const Vec2 to_batch = offset_ - batch_.middle();
    view_.evaluate(arcs, -to_batch);
    const double horizon = view_.horizon(reach);
    grow(functions_, arcs.size());
    points_.clear();
    // A pointer, because std::vector checks indices in hardened builds.
    ArcFunctions* const functions = functions_.data();
    std::size_t count = 0;  // number of near arcs, counted without an unpredictable branch
    for (std::size_t k = 0; k < arcs.size(); ++k) {
        functions[count] = view_.arc_functions(k);
        count += view_.is_within(k, horizon) ? 1U : 0U;
        if (arcs[k].corner && view_.is_within(k, horizon)) {
            points_.push_back(arcs[k].tail + to_batch);
        }
    }
    const std::span<const ArcFunctions> near = std::span(functions_).first(count);
    const bool gradient = needs_.gradient || needs_.smooth == SmoothImages::DistanceAndGradient;
    // A pixel slightly outside of a sharp corner may face no arc: it is not between the normals at
    // the ends of any arc. In this case, distances to the ends of all arcs are included.
    if (!batch_.measure(near, points_, gradient)) {
        for (const DistanceArc& arc : arcs) {
            points_.push_back(arc.tail + to_batch);
            points_.push_back(arc.head() + to_batch);
        }
        batch_.measure(near, points_, gradient);
    }
}

// Measures the smooth distances of the batch. Returns false if the plain distances of some pixels
// replace them (PixelBatch::measure_smooth). For the region of the ghost
// (RegionKind::Surroundings), no films are passed to the batch, so that the smooth distances of its
// pixels equal their distances. For a circle, only one of its two arcs is passed, because the
// function `across` of either arc is 0 on the whole circle.
bool RegionField::measure_smooth(double reach) {
    const bool is_circle = region_->kind == RegionKind::Circle;
    Arcs films = region_->boundary.films();
    if (region_->kind != RegionKind::Bubble) {
        films = films.first(is_circle ? 1 : 0);
    }
    const Vec2 point = batch_.middle() - offset_;
    view_.evaluate(films, point);
    films_.clear();
    for (std::size_t k = 0; k < films.size(); ++k) {
        const Vec2& chord = films[k].shape.chord;
        const double far = (point - films[k].tail - 0.5 * chord).norm() + reach;
        if (chord.norm() > kMinChord * far) {
            films_.push_back(view_.film_functions(k));
            if (is_circle) {
                films_.back().along = {kNoEnd, 0.0F, 0.0F, 0.0F};
            }
        }
    }
    return batch_.measure_smooth(films_, needs_.smooth == SmoothImages::DistanceAndGradient);
}

}  // namespace foam::texgen
