#include "texgen/raster/cell_group.h"

#include "texgen/raster/simd/kernel.h"
#include "texgen/raster/simd/vector_clones.h"

#include <algorithm>
#include <cmath>

namespace foam::texgen {

namespace {

constexpr std::size_t kLanes = SideLanes::kLanes;
constexpr double kRounding = 2.0;  // subpixels, of both ends of a film and more

std::size_t blocks_of(std::size_t sides) {
    return (sides + kLanes - 1) / kLanes;
}

// What a bubble's extent is made of. An arc reaches beyond its chord by no more than its sagitta,
// half the chord times the tangent of a quarter of its turn, or by a whole diameter.
struct Reach {
    std::int32_t left, right, bottom, top;  // of the tails
    double beyond;                          // the largest of the sides, pixels
};

FOAMTEX_VECTOR_CLONES void extend(const SideLanes& sides, Reach& reach) {
    constexpr double kLeastCosine = 0.2;  // of an arc whose sagitta is asked for
    Reach to = reach;
    for (std::size_t k = 0; k < kLanes; ++k) {
        to.left = std::min(to.left, sides.tail_x[k]);
        to.right = std::max(to.right, sides.tail_x[k]);
        to.bottom = std::min(to.bottom, sides.tail_y[k]);
        to.top = std::max(to.top, sides.tail_y[k]);
        const double length = std::abs(sides.chord_x[k]) + std::abs(sides.chord_y[k]);
        const double sine = std::abs(sides.sine[k]);
        const double cosine = sides.cosine[k];
        const double sagitta = 0.5 * length * sine / (1.0 + cosine);
        const double beyond = cosine > kLeastCosine ? sagitta : length / sine;
        to.beyond = beyond > to.beyond ? beyond : to.beyond;
    }
    reach = to;
}

RegionExtent extent_of(std::span<const SideLanes> sides) {
    const SubpixelPoint first = sides.front().tail(0);
    Reach reach{first.x, first.x, first.y, first.y, 0.0};
    for (const SideLanes& some : sides) {
        extend(some, reach);
    }
    const auto margin = static_cast<std::int32_t>(reach.beyond * kSubpixel + kRounding);
    return {first,
            {reach.left - margin, reach.bottom - margin},
            {reach.right + margin, reach.top + margin}};
}

}  // namespace

void CellGroup::begin(std::span<const TorusBubble> bubbles, const FilmStep* films) {
    films_ = films;
    bubbles_ = bubbles.first(std::min(bubbles.size(), kMost));
    step_ = 0;
    most_sides_ = 0;
    std::size_t blocks = 0;
    for (const TorusBubble& bubble : bubbles_) {
        __builtin_prefetch(&films[index_of(film_of(bubble.side))]);
        blocks += blocks_of(bubble.sides);
        most_sides_ = std::max<std::size_t>(most_sides_, bubble.sides);
    }
    grow(lanes_, blocks);
    SideLanes* to = lanes_.data();
    for (std::size_t k = 0; k < bubbles_.size(); ++k) {
        walks_[k] = {bubbles_[k].side, {}, to};
        to += blocks_of(bubbles_[k].sides);
    }
}

void CellGroup::advance() {
    if (step_ == most_sides_) {
        return;
    }
    for (std::size_t k = 0; k < bubbles_.size(); ++k) {
        if (step_ < bubbles_[k].sides) {
            go(walks_[k]);
        }
    }
    ++step_;
}

std::span<const TorusCell> CellGroup::cells() {
    while (step_ < most_sides_) {
        advance();
    }
    for (std::size_t k = 0; k < bubbles_.size(); ++k) {
        const auto& [bubble, side, count, first] = bubbles_[k];
        SideLanes* to = walks_[k].to;
        for (std::size_t lane = count; lane % kLanes != 0; ++lane) {
            to[lane / kLanes].set(lane % kLanes, {}, to->tail(0));
        }
        const std::span<const SideLanes> lanes(to, blocks_of(count));
        cells_[k] = {bubble, {lanes, count, first}, extent_of(lanes)};
    }
    return std::span(cells_).first(bubbles_.size());
}

void CellGroup::go(Walk& walk) const {
    const FilmStep& film = films_[index_of(film_of(walk.side))];
    const std::size_t side = index_of(walk.side) & 1U;
    const int along = 1 - 2 * static_cast<int>(side);  // no branch: nobody foresees the side
    const double sign = along;
    walk.to[step_ / kLanes].set(
        step_ % kLanes,
        {{sign * film.chord_x, sign * film.chord_y}, film.cosine, sign * film.sine},
        SubpixelPoint{film.tail_x[side], film.tail_y[side]} + walk.lift);
    walk.lift = walk.lift + SubpixelPoint{along * film.lift_x, along * film.lift_y};
    walk.side = film.next[side];
    __builtin_prefetch(&films_[index_of(film_of(walk.side))]);
}

}  // namespace foam::texgen
