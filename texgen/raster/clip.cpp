#include "texgen/raster/clip.h"

#include <algorithm>
#include <utility>

namespace foam::texgen {

namespace {

// All points with sign * point[axis] <= bound.
struct HalfPlane {
    int axis;
    double sign;
    double bound;

    double beyond(const Vec2& point) const { return sign * point[axis] - bound; }
};

// Where an edge crosses the border; from whichever end comes first, to round alike both ways.
Vec2 crossing(const HalfPlane& half, const Vec2& inside, const Vec2& outside) {
    const double in = half.beyond(inside);
    const double out = half.beyond(outside);
    const bool inside_first =
        std::pair(inside.x(), inside.y()) < std::pair(outside.x(), outside.y());
    Vec2 point = inside_first ? Vec2(inside + in / (in - out) * (outside - inside))
                              : Vec2(outside + out / (out - in) * (inside - outside));
    point[half.axis] = half.sign * half.bound;
    return point;
}

// Sutherland and Hodgman's rule.
std::vector<Vec2> clipped_to(const std::vector<Vec2>& chain, const HalfPlane& half) {
    std::vector<Vec2> rest;
    Vec2 from = chain.empty() ? Vec2::Zero() : chain.back();
    for (const Vec2& to : chain) {
        const bool from_inside = half.beyond(from) <= 0.0;
        const bool to_inside = half.beyond(to) <= 0.0;
        if (from_inside != to_inside) {
            rest.push_back(from_inside ? crossing(half, from, to) : crossing(half, to, from));
        }
        if (to_inside) {
            rest.push_back(to);
        }
        from = to;
    }
    return rest;
}

bool is_within(const Vec2& point, const Vec2& low, const Vec2& high) {
    return (point.array() >= low.array()).all() && (point.array() <= high.array()).all();
}

}  // namespace

void clip_to_box(std::vector<Vec2>& chain, const Vec2& low, const Vec2& high) {
    if (std::all_of(
            chain.begin(), chain.end(), [&](const Vec2& p) { return is_within(p, low, high); })) {
        return;
    }
    for (const int axis : {0, 1}) {
        chain = clipped_to(chain, {axis, 1.0, high[axis]});
        chain = clipped_to(chain, {axis, -1.0, -low[axis]});
    }
}

}  // namespace foam::texgen
