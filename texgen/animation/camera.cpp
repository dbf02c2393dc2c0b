// SPDX-License-Identifier: Apache-2.0

#include "texgen/animation/camera.h"

#include "core/foam/measure.h"
#include "core/geometry/elementary.h"
#include "texgen/events/event_context.h"

#include <algorithm>
#include <limits>
#include <numbers>

namespace foam::texgen {

namespace {

// The bounding box of the points passed to `include`.
struct Box {
    Vec2 low = Vec2::Constant(std::numeric_limits<double>::infinity());
    Vec2 high = -low;

    void include(const Vec2& point) {
        low = low.cwiseMin(point);
        high = high.cwiseMax(point);
    }
    bool is_empty() const { return !(low.x() <= high.x()); }
};

// Extends the box by an arc: by its ends and by its leftmost, rightmost, highest and lowest points.
// At these extreme points the tangent is parallel to an axis.
void include_arc(const FilmArc& arc, const Vec2& tail, Box& box) {
    constexpr double kQuarter = 0.5 * std::numbers::pi;
    const double tail_angle = ieee::atan2(arc.chord.y(), arc.chord.x()) - arc.half_angle;
    box.include(tail);
    box.include(tail + arc.chord);
    for (int k = -4; k <= 4; ++k) {  // tangent angles are between -2 pi and 2 pi
        const double fraction = (k * kQuarter - tail_angle) / (2.0 * arc.half_angle);
        if (fraction > 0.0 && fraction < 1.0) {
            box.include(tail + point_at(arc, fraction));
        }
    }
}

Box box_of(const Frame& frame) {
    Box box;
    for (const FilmId film : frame.network.films()) {
        const JunctionId tail = frame.network.tail(forward_side(film));
        include_arc(frame.arcs[film], frame.positions[tail], box);
    }
    for (const LoneBubble& bubble : frame.lone_bubbles) {
        const Vec2 radius = Vec2::Constant(lone_radius(bubble));
        box.include(bubble.center - radius);
        box.include(bubble.center + radius);
    }
    return box;
}

// Returns the view in which the box is centered and as large as possible inside a margin on each
// side. `margin` is a fraction of the shorter side of the image. `size` is the size of the image in
// pixels.
View fitted_view(const Box& box, const Vec2& size, double margin) {
    if (box.is_empty()) {
        return {};
    }
    const Vec2 inner = size - Vec2::Constant(2.0 * margin * size.minCoeff());
    return {0.5 * (box.low + box.high), (inner.array() / (box.high - box.low).array()).minCoeff()};
}

Vec2 size_in_pixels(const ImageOptions& image) {
    return {image.width, image.height};
}

}  // namespace

View camera_view(const Frame& first, const ImageOptions& image, const CameraOptions& camera) {
    View view = fitted_view(box_of(first), size_in_pixels(image), camera.margin);
    view.center = point_in_view(view, size_in_pixels(image), camera.center);
    view.pixels_per_unit *= camera.zoom;
    return view;
}

}  // namespace foam::texgen
