// SPDX-License-Identifier: Apache-2.0

#include "texgen/raster/arcs/patch_boundaries.h"

#include "core/foam/measure.h"

namespace foam::texgen {

namespace {

// Appends the boundary loop that contains a half-edge.
void append_network_loop(const PixelPatch& pixels, HalfEdgeId first, ArcLoops& to) {
    HalfEdgeId h = first;
    do {
        to.sides.push_back(pixels.arc(h));
        h = pixels.frame.network.next(h);
    } while (h != first);
    to.loop_ends.push_back(to.sides.size());
}

// Appends the circle of a lone bubble as two semicircles, counter-clockwise if `sign` is 1 and
// clockwise if `sign` is -1.
void append_circle(const PixelPatch& pixels, const LoneBubble& bubble, int sign, ArcLoops& to) {
    const Vec2 radius(pixels.scale * lone_radius(bubble), 0.0);
    const Vec2 center = pixels.pixel(bubble.center);
    const double sine = sign;  // a semicircle has a half angle of 90 or -90 degrees
    to.sides.push_back({center - radius, {2.0 * radius, 0.0, sine}});
    to.sides.push_back({center + radius, {-2.0 * radius, 0.0, sine}});
    to.loop_ends.push_back(to.sides.size());
}

// Returns the boundary loops of the ghost bubble: one for the rim of each raft, one for each hole,
// and one for each lone bubble.
ArcLoops boundaries_of_ghost(const PixelPatch& pixels) {
    const Network& network = pixels.frame.network;
    ArcLoops boundaries;
    std::vector<bool> seen(network.film_slots(), false);
    for (const FilmId film : network.films()) {
        if (!network.is_outer(film) || seen[index_of(film)]) {
            continue;
        }
        const HalfEdgeId forward = forward_side(film);
        const HalfEdgeId first = network.left(forward) == network.ghost() ? forward : twin(forward);
        append_network_loop(pixels, first, boundaries);
        for (HalfEdgeId h = first; !seen[index_of(film_of(h))]; h = network.next(h)) {
            seen[index_of(film_of(h))] = true;
        }
    }
    for (const LoneBubble& bubble : pixels.frame.lone_bubbles) {
        append_circle(pixels, bubble, -1, boundaries);
    }
    return boundaries;
}

}  // namespace

bool may_be_visible(const RasterGrid& grid, std::span<const ArcLoops::Side> loop) {
    if (loop.empty()) {
        return false;
    }
    Vec2 low = loop.front().tail;
    Vec2 high = low;
    for (const ArcLoops::Side& arc : loop) {
        const Vec2 reach = Vec2::Constant(arc_length(film_arc(arc.arc)));
        low = low.cwiseMin(arc.tail - reach);
        high = high.cwiseMax(arc.tail + reach);
    }
    return low.x() < grid.width && low.y() < grid.height && high.x() > 0.0 && high.y() > 0.0;
}

std::size_t region_count(const Frame& frame) {
    return frame.network.bubble_slots() + frame.lone_bubbles.size();
}

ArcLoops boundaries_of(const PixelPatch& pixels, BubbleId bubble) {
    const Network& network = pixels.frame.network;
    if (bubble == network.ghost()) {
        return boundaries_of_ghost(pixels);
    }
    ArcLoops boundaries;
    if (index_of(bubble) < network.bubble_slots()) {
        append_network_loop(pixels, network.first(bubble), boundaries);
    } else {
        const std::size_t k = index_of(bubble) - network.bubble_slots();
        append_circle(pixels, pixels.frame.lone_bubbles[k], 1, boundaries);
    }
    return boundaries;
}

}  // namespace foam::texgen
